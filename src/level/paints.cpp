#include "level/paints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "level/colours.h"
#include "level/document.h"
#include "level/faults.h"
#include "level/numbers.h"

namespace level {

namespace {

using Channels = std::array<double, 4>;  // red, green, blue times opacity, each to 255; opacity, to 1

struct Stop {
    double share = 0;  // of the painted area before it
    Channels channels{};
};

Channels channels_of(std::string const& colour, double opacity) {
    auto const rgb = static_cast<unsigned>(std::strtoul(colour.c_str() + 1, nullptr, 16));
    return {opacity * (rgb >> 16 & 255), opacity * (rgb >> 8 & 255), opacity * (rgb & 255), opacity};
}

Paint paint_of(Channels const& channels) {
    auto const byte = [&](int channel) {
        return static_cast<unsigned>(std::clamp(std::lround(channels[channel] / channels[3]), 0L, 255L));
    };
    if (channels[3] <= 0) return {"#000000", 0};
    char text[8];
    std::snprintf(text, sizeof text, "#%06x", byte(0) << 16 | byte(1) << 8 | byte(2));
    return {text, std::min(channels[3], 1.0)};
}

// The mean over the painted area, the first and the last colour reaching to its ends.
Paint mean_of_stops(std::vector<Stop> const& stops) {
    Channels sum{};
    auto const add = [&](double share, Channels const& from, Channels const& to) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * (from[i] + to[i]) / 2;
    };
    add(stops.front().share, stops.front().channels, stops.front().channels);
    for (std::size_t i = 1; i < stops.size(); ++i)
        add(stops[i].share - stops[i - 1].share, stops[i - 1].channels, stops[i].channels);
    add(1 - stops.back().share, stops.back().channels, stops.back().channels);
    return paint_of(sum);
}

bool is_gradient(pugi::xml_node node) {
    std::string_view const tag = Document::tag_of(node);
    return tag == "linearGradient" || tag == "radialGradient";
}

pugi::xml_attribute paint_reference_of(pugi::xml_node node) {
    pugi::xml_attribute const plain = node.attribute("href");
    return plain ? plain : node.attribute("xlink:href");
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
                             colour ? channels_of(*colour, share_in(style.stop_opacity, 1)) : Channels{}});
        }
        std::string_view const reference = trimmed(paint_reference_of(node).value());
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
        return colour ? std::optional(Paint{*colour, 1}) : std::nullopt;
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
