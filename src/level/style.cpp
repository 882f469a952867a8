#include "level/style.h"

#include <algorithm>
#include <span>

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
                          {"stop-opacity", &Style::stop_opacity},
                          {"overflow", &Style::overflow}};

struct Place {
    std::string_view name;
    std::string_view Placement::*value;
};
constexpr Place places[] = {
    {"transform", &Placement::transform}, {"transform-origin", &Placement::origin}, {"transform-box", &Placement::box},
    {"translate", &Placement::translate}, {"rotate", &Placement::rotate},           {"scale", &Placement::scale},
};

// By which a style would change a shape or its place.
constexpr std::string_view ignored_properties[] = {"d",
                                                   "cx",
                                                   "cy",
                                                   "r",
                                                   "rx",
                                                   "ry",
                                                   "x",
                                                   "y",
                                                   "width",
                                                   "height",
                                                   "offset",
                                                   "offset-path",
                                                   "-webkit-transform-origin-x",
                                                   "-webkit-transform-origin-y",
                                                   "content-visibility",
                                                   "all"};

constexpr std::string_view undrawn_properties[] = {"stroke-dasharray", "marker", "marker-start",  "marker-mid",
                                                   "marker-end",       "filter", "mix-blend-mode"};

bool is_among(std::span<std::string_view const> names, std::string_view name) {
    return std::any_of(names.begin(), names.end(), [&](std::string_view known) { return same_word(name, known); });
}

// What CSS allows of display; anything else is as if it were not there.
bool is_display(std::string_view value) {
    constexpr std::string_view known[] = {
        "none", "inline",      "block",   "list-item",       "table",       "inline-table", "inline-block",
        "flex", "inline-flex", "grid",    "inline-grid",     "contents",    "flow-root",    "run-in",
        "ruby", "inherit",     "initial", "unset",           "revert",      "table-row",    "table-cell",
        "math", "compact",     "marker",  "table-row-group", "table-column"};
    return is_among(known, value);
}

// Of one element, before it is joined with what is inherited.
struct Own {
    double opacity = 1;
    bool clipped = false, masked = false;
};

// What the words for all properties stand for: the style above, or what counts where nobody says anything.
Style const* style_meant_by(std::string_view value, Style const& above) {
    static Style const initial{};
    if (same_word(value, "inherit") || same_word(value, "unset") || same_word(value, "revert")) return &above;
    return same_word(value, "initial") ? &initial : nullptr;
}

void apply(Style& style, Own& own, Style const& above, std::string_view name, std::string_view value) {
    if (value.empty()) return;
    Style const* const meant = style_meant_by(value, above);
    for (Text const& text : texts)
        if (same_word(name, text.name)) style.*text.value = meant ? meant->*text.value : value;
    // An element whose parent is hidden is not met.
    if (meant && same_word(name, "display")) style.hidden = style.contents = false;
    bool const depends = value.find("var(") != std::string_view::npos || same_word(value, "inherit");
    for (Place const& place : places) {
        if (!same_word(name, place.name)) continue;
        style.placement.*place.value = depends || meant ? std::string_view() : value;
        if (depends) style.ignored = place.name;
    }
    if (depends && !meant && same_word(name, "display")) style.ignored = "display";
    if (meant) return;
    if (same_word(name, "opacity")) own.opacity = share_in(value, 1);
    if (same_word(name, "display") && is_display(value)) {
        style.hidden = same_word(value, "none");
        style.contents = same_word(value, "contents");
    }
    if (same_word(name, "clip-path")) own.clipped = !same_word(value, "none");
    if (same_word(name, "mask") || same_word(name, "mask-image")) own.masked = !same_word(value, "none");
}

// Attributes of these names are nothing, or a label's or an animation's, and no properties.
bool is_property_only(std::string_view name) {
    return name == "translate" || name == "rotate" || name == "scale" || name == "transform-box";
}

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
    constexpr std::string_view own[] = {"opacity", "display", "clip-path", "mask", "mask-image"};
    return std::any_of(std::begin(texts), std::end(texts), is_it) ||
           std::any_of(std::begin(places), std::end(places), is_it) || is_among(ignored_properties, property) ||
           is_among(undrawn_properties, property) || is_among(own, property);
}

std::string_view Styles::kept(std::string_view css) {
    return has_comment(css) ? std::string_view(texts_.emplace_back(without_comments(css))) : css;
}

void Styles::note_undrawn(pugi::xml_node node, std::string_view property, std::string_view value) {
    bool const is_nothing = value.empty() || same_word(value, "none") || same_word(value, "normal") ||
                            style_meant_by(value, Style{}) != nullptr;
    if (is_nothing) return;
    for (std::string_view const known : undrawn_properties) {
        if (!same_word(property, known)) continue;
        auto const is_it = [&](Undrawn const& undrawn) { return undrawn.property == known; };
        auto found = std::find_if(undrawn_.begin(), undrawn_.end(), is_it);
        if (found == undrawn_.end()) found = undrawn_.insert(found, {known, node, 0});
        ++found->elements;
    }
}

Style Styles::of(pugi::xml_node node, Style const& from_above) {
    Style style = from_above;
    style.placement = {};
    style.contents = false;
    style.ignored = style.overflow = {};
    style.stop_color = style.stop_opacity = {};
    Own own;
    std::string_view css;
    for (pugi::xml_attribute const attribute : node.attributes()) {
        std::string_view const name = attribute.name();
        if (name == "style") css = attribute.value();
        if (is_property_only(name)) continue;
        apply(style, own, from_above, name, trimmed(attribute.value()));
        note_undrawn(node, name, trimmed(attribute.value()));
    }
    if (css.size() > largest_sheet) css = {};  // a fault that the walk reports
    // The style attribute outranks the sheets, and these the attributes; what is important outranks what is not.
    std::vector<Declaration> declarations;
    if (!sheet_.empty()) declarations = sheet_.declarations_for(node);
    for (Declaration const& declaration : declarations_in(kept(css))) declarations.push_back(declaration);
    for (bool const important : {false, true})
        for (Declaration const& declaration : declarations) {
            if (declaration.important != important) continue;
            apply(style, own, from_above, declaration.name, declaration.value);
            if (same_word(declaration.name, "transform")) style.placement.in_style = true;
            note_undrawn(node, declaration.name, declaration.value);
            for (std::string_view const property : ignored_properties)
                if (same_word(declaration.name, property)) style.ignored = property;
        }
    style.opacity *= own.opacity;
    style.clipped = style.clipped || own.clipped || own.masked;
    return style;
}

}  // namespace level
