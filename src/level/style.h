// How an element is shown: presentation attributes, style sheets and the style attribute, inherited as in SVG.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "level/css.h"

namespace level {

// The properties that place an element; they are its own and not inherited.
struct Placement {
    std::string_view transform, origin, box, translate, rotate, scale;
    bool in_style = false;  // transform stands in a style, not in its attribute
};

struct Style {
    std::string_view fill, stroke;  // as given; empty where nothing is
    std::string_view stroke_width = "1", fill_opacity = "1", stroke_opacity = "1", fill_rule = "nonzero",
                     visibility = "visible", color = "black";
    std::string_view stop_color, stop_opacity;  // of a gradient's stop, not inherited
    double opacity = 1;                         // of the element and all groups that hold it
    bool hidden = false;                        // display none
    bool contents = false;                      // display contents, which hides all but what holds others
    bool clipped = false;                       // by a clip path or mask, its own or of a group that holds it
    Placement placement;
    std::string_view ignored;   // a property that would change a shape or its place and does not, or empty
    std::string_view overflow;  // of a viewport
};

// A property that browsers draw and this program does not.
struct Undrawn {
    std::string_view property;
    pugi::xml_node first;  // the first element that has it
    int elements = 0;
};

// A number from 0 to 1, perhaps in per cent; `otherwise` where it is none.
double share_in(std::string_view text, double otherwise);

// Whether a property changes anything that this program shows or plays, in whatever case it is written.
bool is_understood(std::string_view property);

class Styles {
public:
    explicit Styles(Sheet sheet) : sheet_(std::move(sheet)) {}

    // The style of a node whose parent has the style `from_above`. The text that it refers to lives as long as the
    // document and this.
    Style of(pugi::xml_node node, Style const& from_above);

    std::vector<Undrawn> const& undrawn() const { return undrawn_; }

private:
    std::string_view kept(std::string_view css);
    void note_undrawn(pugi::xml_node node, std::string_view property, std::string_view value);

    Sheet sheet_;
    std::deque<std::string> texts_;
    std::vector<Undrawn> undrawn_;
};

}  // namespace level
