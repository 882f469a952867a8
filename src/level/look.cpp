#include "level/look.h"

#include "level/faults.h"
#include "level/lengths.h"

namespace level {

namespace {

double width_in(std::string_view text) {
    constexpr double unknown = -1;  // per cent are of a viewport that nobody means for a stroke
    try {
        double const width = length_of_text(text, unknown);
        if (width >= 0) return width;
    } catch (Broken const&) {
    }
    throw Unsupported("stroke-width " + quoted(text));
}

std::optional<std::string> colour_given(std::string_view text, Style const& style, Paints& paints) {
    if (text.empty()) return std::nullopt;
    try {
        auto const paint = paints.paint_in(text, style.color);
        return paint ? std::optional(paint->colour) : std::nullopt;
    } catch (Unsupported const&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<Decoration> decorations_of(std::vector<Outline> const& outlines, Style const& style, Affine const& to_world,
                                       Paints& paints) {
    std::vector<Decoration> parts;
    if (!same_word(style.visibility, "visible") || outlines.empty()) return parts;
    auto const fill = paints.fill_in(style.fill.empty() ? "black" : style.fill, style.color, to_world);
    auto const stroke = paints.paint_in(style.stroke.empty() ? "none" : style.stroke, style.color);
    if (fill) {
        bool const is_even_odd = same_word(style.fill_rule, "evenodd");
        double const opacity = style.opacity * share_in(style.fill_opacity, 1);
        parts.push_back({outlines, fill->colour, std::nullopt, 0, opacity * fill->opacity,
                         is_even_odd ? geometry::FillRule::even_odd : geometry::FillRule::nonzero, fill->fade});
        if (auto& fade = parts.back().fade) {
            fade->top_opacity *= opacity;
            fade->bottom_opacity *= opacity;
        }
    }
    double const width = stroke ? width_in(style.stroke_width) * scale_of(to_world) : 0;
    if (width > 0)
        parts.push_back({outlines, std::nullopt, stroke->colour, width,
                         style.opacity * stroke->opacity * share_in(style.stroke_opacity, 1)});
    bool const one_part = parts.size() == 2 && parts[0].opacity == parts[1].opacity;
    if (one_part) {
        parts[0].stroke = parts[1].stroke;
        parts[0].stroke_width = width;
        parts.pop_back();
    }
    std::erase_if(parts, [](Decoration const& part) { return part.opacity <= 0; });
    return parts;
}

Tint tint_of(Style const& style, Paints& paints) {
    return {colour_given(style.fill, style, paints), colour_given(style.stroke, style, paints)};
}

}  // namespace level
