#include "level/paints.h"

#include <algorithm>
#include <vector>

#include "level/colours.h"
#include "level/document.h"
#include "level/faults.h"
#include "level/numbers.h"

namespace level {

namespace {

struct Stop {
    double share = 0;  // of the painted area before it
    Colour colour;     // red, green and blue times the opacity
};

Colour premultiplied(Colour const& colour, double opacity) {
    double const all = colour.opacity * opacity;
    return {colour.red * all, colour.green * all, colour.blue * all, all};
}

Paint paint_of(Colour const& sum) {
    if (sum.opacity <= 0) return {"#000000", 0};
    return {hexadecimal_of({sum.red / sum.opacity, sum.green / sum.opacity, sum.blue / sum.opacity, 1}),
            std::min(sum.opacity, 1.0)};
}

// The mean over the painted area, the first and the last colour reaching to its ends.
Paint mean_of_stops(std::vector<Stop> const& stops) {
    Colour sum{0, 0, 0, 0};
    auto const add = [&](double share, Colour const& from, Colour const& to) {
        sum.red += share * (from.red + to.red) / 2;
        sum.green += share * (from.green + to.green) / 2;
        sum.blue += share * (from.blue + to.blue) / 2;
        sum.opacity += share * (from.opacity + to.opacity) / 2;
    };
    add(stops.front().share, stops.front().colour, stops.front().colour);
    for (std::size_t i = 1; i < stops.size(); ++i)
        add(stops[i].share - stops[i - 1].share, stops[i - 1].colour, stops[i].colour);
    add(1 - stops.back().share, stops.back().colour, stops.back().colour);
    return paint_of(sum);
}

bool is_gradient(pugi::xml_node node) {
    std::string_view const tag = Document::tag_of(node);
    return tag == "linearGradient" || tag == "radialGradient";
}

}  // namespace

pugi::xml_node Paints::gradient(std::string const& id) {
    if (by_id_.empty())
        for (pugi::xml_node node = root_; node; node = next_within(node, root_))
            if (is_gradient(node)) by_id_.try_emplace(node.attribute("id").value(), node);
    auto const found = by_id_.find(id);
    return found == by_id_.end() ? pugi::xml_node() : found->second;
}

// A gradient without stops has those of the one that it refers to.
std::optional<Paint> Paints::mean_of(std::string const& id) {
    constexpr int longest_chain = 16;
    pugi::xml_node node = gradient(id);
    bool const is_radial = Document::tag_of(node) == "radialGradient";
    std::vector<Stop> stops;
    for (int i = 0; i < longest_chain && node && stops.empty(); ++i) {
        for (pugi::xml_node const child : node.children()) {
            if (Document::tag_of(child) != "stop") continue;
            Style const style = styles_.of(child, Style{});
            auto const colour = colour_in(same_word(style.stop_color, "currentcolor") ? style.color : style.stop_color);
            double const least = stops.empty() ? 0 : stops.back().share;
            double const offset = share_in(child.attribute("offset").value(), 0);
            stops.push_back({std::max(is_radial ? offset * offset : offset, least),
                             premultiplied(colour.value_or(Colour{0, 0, 0, 0}), share_in(style.stop_opacity, 1))});
        }
        std::string_view const reference = Document::reference_of(node);
        node = reference.substr(0, 1) == "#" ? gradient(std::string(reference.substr(1))) : pugi::xml_node();
    }
    if (stops.empty()) return std::nullopt;
    return mean_of_stops(stops);
}

std::optional<Paint> Paints::paint_in(std::string_view text, std::string_view current) {
    text = trimmed(text);
    if (same_word(text, "currentcolor")) text = current;
    std::size_t const close = text.find(')');
    bool const is_reference = same_word(text.substr(0, 4), "url(") && close != std::string_view::npos;
    if (!is_reference) {
        auto const colour = colour_in(text);
        return colour ? std::optional(Paint{hexadecimal_of(*colour), colour->opacity}) : std::nullopt;
    }
    std::string_view name = trimmed(text.substr(4, close - 4));
    bool const has_quotes = name.size() > 1 && (name[0] == '"' || name[0] == '\'') && name.back() == name[0];
    if (has_quotes) name = name.substr(1, name.size() - 2);
    std::string const id(name.substr(0, 1) == "#" ? name.substr(1) : std::string_view());
    auto const known = means_.find(id);
    auto const mean = known != means_.end() ? known->second : means_.emplace(id, mean_of(id)).first->second;
    met_gradients_ = met_gradients_ || mean.has_value();
    if (mean) return mean;
    std::string_view const otherwise = trimmed(text.substr(close + 1));
    if (!otherwise.empty() && !same_word(otherwise.substr(0, 4), "url(")) return paint_in(otherwise, current);
    throw Unsupported("the paint " + quoted(text));
}

}  // namespace level
