#include "level/style.h"

#include <algorithm>

#include "level/faults.h"
#include "level/numbers.h"

namespace level {

namespace {

struct Text {
    std::string_view name;
    std::string_view Style::*value;
};
constexpr Text texts[] = {{"fill", &Style::fill},
                          {"stroke", &Style::stroke},
                          {"stroke-width", &Style::stroke_width},
                          {"fill-opacity", &Style::fill_opacity},
                          {"stroke-opacity", &Style::stroke_opacity},
                          {"fill-rule", &Style::fill_rule},
                          {"visibility", &Style::visibility},
                          {"color", &Style::color},
                          {"stop-color", &Style::stop_color},
                          {"stop-opacity", &Style::stop_opacity}};

struct Place {
    std::string_view name;
    std::string_view Placement::*value;
};
constexpr Place places[] = {
    {"transform", &Placement::transform}, {"transform-origin", &Placement::origin}, {"transform-box", &Placement::box},
    {"translate", &Placement::translate}, {"rotate", &Placement::rotate},           {"scale", &Placement::scale},
};

constexpr std::string_view geometry_properties[] = {"d", "cx", "cy", "r", "rx", "ry", "x", "y", "width", "height"};

// What CSS allows of display; anything else is as if it were not there.
bool is_display(std::string_view value) {
    constexpr std::string_view known[] = {
        "none", "inline",      "block",   "list-item",       "table",       "inline-table", "inline-block",
        "flex", "inline-flex", "grid",    "inline-grid",     "contents",    "flow-root",    "run-in",
        "ruby", "inherit",     "initial", "unset",           "revert",      "table-row",    "table-cell",
        "math", "compact",     "marker",  "table-row-group", "table-column"};
    return std::any_of(std::begin(known), std::end(known), [&](auto word) { return same_word(value, word); });
}

// Of one element, before it is joined with what is inherited.
struct Own {
    double opacity = 1;
    bool clipped = false, masked = false;
};

void apply(Style& style, Own& own, std::string_view name, std::string_view value) {
    if (value.empty() || same_word(value, "inherit")) return;
    for (Text const& text : texts)
        if (same_word(name, text.name)) style.*text.value = value;
    for (Place const& place : places)
        if (same_word(name, place.name)) style.placement.*place.value = value;
    if (same_word(name, "opacity")) own.opacity = share_in(value, 1);
    if (same_word(name, "display") && is_display(value)) style.hidden = same_word(value, "none");
    if (same_word(name, "clip-path")) own.clipped = !same_word(value, "none");
    if (same_word(name, "mask")) own.masked = !same_word(value, "none");
}

// Attributes of these names are no properties, but a tooltip, a label or an animation's.
bool is_property_only(std::string_view name) { return name == "translate" || name == "rotate" || name == "scale"; }

}  // namespace

double share_in(std::string_view text, double otherwise) {
    text = trimmed(text);
    bool const per_cent = !text.empty() && text.back() == '%';
    if (per_cent) text.remove_suffix(1);
    Parsed const parsed = parsed_number(text);
    if (parsed.syntax != Syntax::good) return otherwise;
    return std::clamp(per_cent ? parsed.value / 100 : parsed.value, 0.0, 1.0);
}

bool is_understood(std::string_view property) {
    auto const is_it = [&](auto const& known) { return same_word(property, known.name); };
    auto const is_word = [&](std::string_view word) { return same_word(property, word); };
    constexpr std::string_view own[] = {"opacity", "display", "clip-path", "mask"};
    return std::any_of(std::begin(texts), std::end(texts), is_it) ||
           std::any_of(std::begin(places), std::end(places), is_it) ||
           std::any_of(std::begin(geometry_properties), std::end(geometry_properties), is_word) ||
           std::any_of(std::begin(own), std::end(own), is_word);
}

std::string_view Styles::kept(std::string_view css) {
    return has_comment(css) ? std::string_view(texts_.emplace_back(without_comments(css))) : css;
}

Style Styles::of(pugi::xml_node node, Style const& from_above) {
    Style style = from_above;
    style.placement = {};
    style.geometry = {};
    style.stop_color = style.stop_opacity = {};
    Own own;
    std::string_view css;
    for (pugi::xml_attribute const attribute : node.attributes()) {
        std::string_view const name = attribute.name();
        if (name == "style") css = attribute.value();
        if (!is_property_only(name)) apply(style, own, name, trimmed(attribute.value()));
    }
    if (css.size() > largest_sheet) css = {};  // a fault that the walk reports
    // The style attribute outranks the sheets, and these the attributes; what is important outranks what is not.
    std::vector<Declaration> declarations;
    if (!sheet_.empty()) declarations = sheet_.declarations_for(node);
    for (Declaration const& declaration : declarations_in(kept(css))) declarations.push_back(declaration);
    for (bool const important : {false, true})
        for (Declaration const& declaration : declarations) {
            if (declaration.important != important) continue;
            apply(style, own, declaration.name, declaration.value);
            for (std::string_view const property : geometry_properties)
                if (same_word(declaration.name, property)) style.geometry = property;
        }
    style.opacity *= own.opacity;
    style.clipped = style.clipped || own.clipped || own.masked;
    return style;
}

}  // namespace level
