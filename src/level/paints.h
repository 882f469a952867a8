// What paints a shape: a colour, or a gradient straight down; any other gradient stands for the mean of its stops.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <pugixml.hpp>

#include "level/colours.h"
#include "level/level.h"
#include "level/style.h"
#include "level/transform.h"

namespace level {

struct Paint {
    std::string colour;  // #rrggbb
    double opacity = 1;
    std::optional<Fade> fade = std::nullopt;  // of fills; the others are its means
};

struct GradientStop {
    double offset = 0;  // 0 to 1, never below the one before
    Colour colour;      // straight alpha
};

class Paints {
public:
    Paints(pugi::xml_node root, Styles& styles) : root_(root), styles_(styles) {}

    // Of fill or stroke, nothing for none. `current` is what currentColor means. Throws Unsupported for what is
    // neither a colour nor a gradient of this file, patterns for one.
    std::optional<Paint> paint_in(std::string_view text, std::string_view current);

    // The same of a fill, with a gradient of two stops in user space that goes straight down the world.
    std::optional<Paint> fill_in(std::string_view text, std::string_view current, Affine const& to_world);

    // Whether one was met that stands for its mean.
    bool met_gradients() const { return met_gradients_; }

private:
    // The gradient whose stops are those of the one with this id: itself, or one that it refers to.
    pugi::xml_node owner_of_stops(std::string const& id);
    std::vector<GradientStop> const& stops_of(pugi::xml_node owner);  // throws Unsupported
    std::vector<GradientStop> read_stops(pugi::xml_node owner);
    std::optional<Paint> mean_of(std::string const& id);
    std::optional<Fade> fade_of(std::string const& id, Affine const& to_world);
    pugi::xml_node gradient(std::string const& id);

    struct Stops {
        std::vector<GradientStop> stops;
        std::string unsupported;  // why they cannot be read, or empty
    };
    pugi::xml_node root_;
    Styles& styles_;
    std::unordered_map<std::string, pugi::xml_node> by_id_;
    std::unordered_map<std::string, std::optional<Paint>> means_;
    std::unordered_map<std::size_t, Stops> stops_;                                       // by owner
    std::unordered_map<std::size_t, std::optional<Paint>> linear_means_, radial_means_;  // the same
    bool met_gradients_ = false;
};

}  // namespace level
