#include "level/paints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "level/document.h"
#include "level/faults.h"
#include "level/lengths.h"
#include "level/numbers.h"

namespace level {

namespace {

struct Share {
    double before = 0;  // of the painted area
    Colour colour;      // red, green and blue times the opacity
};

Colour premultiplied(Colour const& colour) {
    double const all = colour.opacity;
    return {colour.red * all, colour.green * all, colour.blue * all, all};
}

Colour opaque(Colour const& colour) { return {colour.red, colour.green, colour.blue, 1}; }

// In user space, of the attributes that name it; nothing where one is missing, in per cent or no length.
std::optional<Vec2> point_in(pugi::xml_node node, char const* x, char const* y) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  // what per cent are of
    try {
        Vec2 const point(length_of_text(node.attribute(x).value(), nothing),
                         length_of_text(node.attribute(y).value(), nothing));
        if (std::isfinite(point.x()) && std::isfinite(point.y())) return point;
    } catch (Broken const&) {
    }
    return std::nullopt;
}

Paint paint_of(Colour const& sum) {
    if (sum.opacity <= 0) return {"#000000", 0};
    return {hexadecimal_of({sum.red / sum.opacity, sum.green / sum.opacity, sum.blue / sum.opacity, 1}),
            std::min(sum.opacity, 1.0)};
}

// The mean over the painted area, the first and the last colour reaching to its ends.
Paint mean_of_shares(std::vector<Share> const& shares) {
    Colour sum{0, 0, 0, 0};
    auto const add = [&](double share, Colour const& from, Colour const& to) {
        sum.red += share * (from.red + to.red) / 2;
        sum.green += share * (from.green + to.green) / 2;
        sum.blue += share * (from.blue + to.blue) / 2;
        sum.opacity += share * (from.opacity + to.opacity) / 2;
    };
    add(shares.front().before, shares.front().colour, shares.front().colour);
    for (std::size_t i = 1; i < shares.size(); ++i)
        add(shares[i].before - shares[i - 1].before, shares[i - 1].colour, shares[i].colour);
    add(1 - shares.back().before, shares.back().colour, shares.back().colour);
    return paint_of(sum);
}

// The id in url(#id).
std::string named_in(std::string_view text) {
    std::string_view name = trimmed(text.substr(4, text.find(')') - 4));
    bool const has_quotes = name.size() > 1 && (name[0] == '"' || name[0] == '\'') && name.back() == name[0];
    if (has_quotes) name = name.substr(1, name.size() - 2);
    return std::string(name.substr(0, 1) == "#" ? name.substr(1) : std::string_view());
}

std::size_t first_comma(std::string_view arguments) {
    int depth = 0;
    for (std::size_t at = 0; at < arguments.size(); ++at) {
        if (arguments[at] == '(') ++depth;
        if (arguments[at] == ')') --depth;
        if (arguments[at] == ',' && depth == 0) return at;
    }
    return std::string_view::npos;
}

// What light-dark() is on a light page, and what var() falls back to: draw.io and Figma write such.
std::string_view without_choice(std::string_view text) {
    constexpr int deepest = 16;
    for (int i = 0; i < deepest; ++i) {
        text = trimmed(text);
        std::size_t const open = std::min(text.find('('), text.size());
        bool const is_light = same_word(text.substr(0, open), "light-dark");
        bool const is_choice = is_light || same_word(text.substr(0, open), "var");
        if (!is_choice || text.back() != ')') return text;
        std::string_view const arguments = text.substr(open + 1, text.size() - open - 2);
        std::size_t const comma = first_comma(arguments);
        if (comma == std::string_view::npos) return text;
        text = is_light ? arguments.substr(0, comma) : arguments.substr(comma + 1);
    }
    return text;
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
pugi::xml_node Paints::owner_of_stops(std::string const& id) {
    constexpr int longest_chain = 16;
    pugi::xml_node node = gradient(id);
    for (int i = 0; i < longest_chain && node; ++i) {
        auto const is_stop = [](pugi::xml_node child) { return Document::tag_of(child) == "stop"; };
        if (node.find_child(is_stop)) return node;
        std::string_view const reference = Document::reference_of(node);
        node = reference.substr(0, 1) == "#" ? gradient(std::string(reference.substr(1))) : pugi::xml_node();
    }
    return {};
}

// Once, be it that they are not understood: thousands of shapes may name them.
std::vector<GradientStop> const& Paints::stops_of(pugi::xml_node owner) {
    auto const [place, is_new] = stops_.try_emplace(owner.hash_value());
    Stops& known = place->second;
    if (is_new) {
        try {
            known.stops = read_stops(owner);
        } catch (Unsupported const& unsupported) {
            known.unsupported = unsupported.what();
        }
    }
    if (!known.unsupported.empty()) throw Unsupported(known.unsupported);
    return known.stops;
}

std::vector<GradientStop> Paints::read_stops(pugi::xml_node owner) {
    std::vector<GradientStop> stops;
    for (pugi::xml_node const child : owner.children()) {
        if (Document::tag_of(child) != "stop") continue;
        Style const style = styles_.of(child, Style{});
        auto const colour = colour_in(same_word(style.stop_color, "currentcolor") ? style.color : style.stop_color);
        double const least = stops.empty() ? 0 : stops.back().offset;
        stops.push_back(
            {std::max(share_in(child.attribute("offset").value(), 0), least), colour.value_or(Colour{0, 0, 0, 0})});
        stops.back().colour.opacity *= share_in(style.stop_opacity, 1);
    }
    return stops;
}

std::optional<Paint> Paints::mean_of(std::string const& id) {
    pugi::xml_node const owner = owner_of_stops(id);
    bool const is_radial = Document::tag_of(gradient(id)) == "radialGradient";
    auto& means = is_radial ? radial_means_ : linear_means_;
    auto const known = means.find(owner.hash_value());
    if (known != means.end()) return known->second;
    std::vector<Share> shares;
    for (GradientStop const& stop : stops_of(owner))
        shares.push_back({is_radial ? stop.offset * stop.offset : stop.offset, premultiplied(stop.colour)});
    auto const mean = shares.empty() ? std::nullopt : std::optional(mean_of_shares(shares));
    return means.emplace(owner.hash_value(), mean).first->second;
}

std::optional<Fade> Paints::fade_of(std::string const& id, Affine const& to_world) {
    pugi::xml_node const node = gradient(id);
    auto const is = [&](char const* name, std::string_view value) { return node.attribute(name).value() == value; };
    if (Document::tag_of(node) != "linearGradient" || !is("gradientUnits", "userSpaceOnUse")) return std::nullopt;
    if (node.attribute("gradientTransform") || !(is("spreadMethod", "") || is("spreadMethod", "pad")))
        return std::nullopt;
    auto const from = point_in(node, "x1", "y1"), to = point_in(node, "x2", "y2");
    std::vector<GradientStop> const& stops = stops_of(owner_of_stops(id));
    if (!from || !to || stops.size() != 2) return std::nullopt;
    bool const is_upright = to_world.b == 0 && to_world.c == 0;
    if (!is_upright || from->x() != to->x()) return std::nullopt;
    auto const world_y = [&](GradientStop const& stop) {
        return mapped(to_world, *from + stop.offset * (*to - *from)).y();
    };
    bool const goes_down = world_y(stops[0]) > world_y(stops[1]);
    GradientStop const &top = goes_down ? stops[0] : stops[1], &bottom = goes_down ? stops[1] : stops[0];
    if (world_y(top) == world_y(bottom)) return std::nullopt;
    return Fade{hexadecimal_of(opaque(top.colour)),
                hexadecimal_of(opaque(bottom.colour)),
                top.colour.opacity,
                bottom.colour.opacity,
                world_y(top),
                world_y(bottom)};
}

std::optional<Paint> Paints::paint_in(std::string_view text, std::string_view current) {
    text = without_choice(text);
    if (same_word(text, "currentcolor")) text = without_choice(current);
    std::size_t const close = text.find(')');
    bool const is_reference = same_word(text.substr(0, 4), "url(") && close != std::string_view::npos;
    if (!is_reference) {
        auto const colour = colour_in(text);
        return colour ? std::optional(Paint{hexadecimal_of(*colour), colour->opacity}) : std::nullopt;
    }
    std::string const id = named_in(text);
    auto const known = means_.find(id);
    auto const mean = known != means_.end() ? known->second : means_.emplace(id, mean_of(id)).first->second;
    met_gradients_ = met_gradients_ || mean.has_value();
    if (mean) return mean;
    std::string_view const otherwise = trimmed(text.substr(close + 1));
    if (!otherwise.empty() && !same_word(otherwise.substr(0, 4), "url(")) return paint_in(otherwise, current);
    throw Unsupported("the paint " + quoted(text));
}

std::optional<Paint> Paints::fill_in(std::string_view text, std::string_view current, Affine const& to_world) {
    bool const met_others = met_gradients_;
    auto paint = paint_in(text, current);
    std::string_view const reference = trimmed(text);
    if (!paint || !same_word(reference.substr(0, 4), "url(")) return paint;
    paint->fade = fade_of(named_in(reference), to_world);
    if (paint->fade) met_gradients_ = met_others;
    return paint;
}

}  // namespace level
