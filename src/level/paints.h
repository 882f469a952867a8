// What paints a shape, as one colour: a gradient stands for the mean of its stops.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <pugixml.hpp>

#include "level/style.h"

namespace level {

struct Paint {
    std::string colour;  // #rrggbb
    double opacity = 1;
};

class Paints {
public:
    Paints(pugi::xml_node root, Styles& styles) : root_(root), styles_(styles) {}

    // Of fill or stroke, nothing for none. `current` is what currentColor means. Throws Unsupported for what is
    // neither a colour nor a gradient of this file, patterns for one.
    std::optional<Paint> paint_in(std::string_view text, std::string_view current);

    bool met_gradients() const { return met_gradients_; }

private:
    std::optional<Paint> mean_of(std::string const& id);
    pugi::xml_node gradient(std::string const& id);

    pugi::xml_node root_;
    Styles& styles_;
    std::unordered_map<std::string, pugi::xml_node> by_id_;
    std::unordered_map<std::string, std::optional<Paint>> means_;
    bool met_gradients_ = false;
};

}  // namespace level
