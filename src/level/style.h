// How an element is painted: the presentation attributes and the style attribute, inherited as in SVG.
#pragma once

#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "level/level.h"
#include "level/outlines.h"

namespace level {

struct Style {
    std::string_view fill = "black", stroke = "none", stroke_width = "1", fill_opacity = "1", stroke_opacity = "1",
                     fill_rule = "nonzero", visibility = "visible";
    double opacity = 1;   // of the element and all groups that hold it
    bool hidden = false;  // display none
};

// The style of a node whose parent has the style `from_above`. The text that it refers to lives in the document.
Style style_of(pugi::xml_node node, Style const& from_above);

// The filled and the stroked part of a shape, at most one of each. Throws Unsupported for paint that is no plain
// colour.
std::vector<Decoration> decorations_of(std::vector<Outline> const& outlines, Style const& style,
                                       double metres_per_unit);

}  // namespace level
