#include "level/style.h"

#include <algorithm>
#include <optional>

#include "level/colours.h"
#include "level/faults.h"
#include "level/numbers.h"

namespace level {

namespace {

// A number from 0 to 1, perhaps in per cent; anything else is 1, as if it were not there.
double opacity_in(std::string_view text) {
    text = trimmed(text);
    bool const per_cent = !text.empty() && text.back() == '%';
    if (per_cent) text.remove_suffix(1);
    Parsed const parsed = parsed_number(text);
    if (parsed.syntax != Syntax::good) return 1;
    return std::clamp(per_cent ? parsed.value / 100 : parsed.value, 0.0, 1.0);
}

void set(std::string_view& property, std::string_view value) {
    if (!value.empty() && value != "inherit") property = value;
}

void apply(Style& style, double& own_opacity, std::string_view name, std::string_view value) {
    if (name == "fill") set(style.fill, value);
    if (name == "stroke") set(style.stroke, value);
    if (name == "stroke-width") set(style.stroke_width, value);
    if (name == "fill-opacity") set(style.fill_opacity, value);
    if (name == "stroke-opacity") set(style.stroke_opacity, value);
    if (name == "fill-rule") set(style.fill_rule, value);
    if (name == "visibility") set(style.visibility, value);
    if (name == "opacity") own_opacity = opacity_in(value);
    if (name == "display") style.hidden = value == "none";
}

template <typename Visit>
void each_declaration(std::string_view css, Visit&& visit) {
    while (!css.empty()) {
        std::size_t const end = std::min(css.find(';'), css.size());
        std::string_view const declaration = css.substr(0, end);
        css.remove_prefix(std::min(end + 1, css.size()));
        std::size_t const colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        std::string_view value = declaration.substr(colon + 1);
        value = trimmed(value.substr(0, value.find('!')));
        visit(trimmed(declaration.substr(0, colon)), value);
    }
}

double width_in(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 2 && text.substr(text.size() - 2) == "px") text.remove_suffix(2);
    Parsed const parsed = parsed_number(text);
    if (parsed.syntax != Syntax::good || parsed.value < 0) throw Unsupported("stroke-width " + quoted(text));
    return parsed.value;
}

}  // namespace

Style style_of(pugi::xml_node node, Style const& from_above) {
    Style style = from_above;
    double own_opacity = 1;
    std::string_view css;
    for (pugi::xml_attribute const attribute : node.attributes()) {
        std::string_view const name = attribute.name();
        if (name == "style") css = attribute.value();
        apply(style, own_opacity, name, trimmed(attribute.value()));
    }
    // The style attribute outranks the others wherever it stands.
    each_declaration(css,
                     [&](std::string_view name, std::string_view value) { apply(style, own_opacity, name, value); });
    style.opacity *= own_opacity;
    return style;
}

std::vector<Decoration> decorations_of(std::vector<Outline> const& outlines, Style const& style,
                                       double metres_per_unit) {
    std::vector<Decoration> parts;
    if (style.visibility != "visible" || outlines.empty()) return parts;
    auto const fill = colour_in(style.fill), stroke = colour_in(style.stroke);
    if (fill) parts.push_back({outlines, fill, std::nullopt, 0, style.opacity * opacity_in(style.fill_opacity)});
    double const width = stroke ? width_in(style.stroke_width) * metres_per_unit : 0;
    if (width > 0)
        parts.push_back({outlines, std::nullopt, stroke, width, style.opacity * opacity_in(style.stroke_opacity)});
    bool const one_part = parts.size() == 2 && parts[0].opacity == parts[1].opacity;
    if (one_part) {
        parts[0].stroke = stroke;
        parts[0].stroke_width = width;
        parts.pop_back();
    }
    std::erase_if(parts, [](Decoration const& part) { return part.opacity <= 0; });
    return parts;
}

}  // namespace level
