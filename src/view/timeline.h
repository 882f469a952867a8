// The timeline: a thin bar at the lower edge that says where in the past one looks.
#pragma once

#include <vector>

#include "view/picture.h"

namespace view {

struct Timeline {
    double from = 0, shown = 0, to = 0;  // s: what is kept, what is looked at, the present
    enum class Sign { dot, flag, cross };
    struct Mark {
        double time = 0;  // s
        Colour colour;
        Sign sign = Sign::dot;
    };
    std::vector<Mark> marks;  // what happened: bananas, the goal
    struct Span {
        double from = 0, to = 0;  // s
    };
    std::vector<Span> pulls;  // when a ball was dragged
};

// Whether a pixel is on the bar, or near enough to press it; and the moment that it stands for, s.
bool is_on_timeline(Vec2 const& pixel, Vec2 const& size);
double time_at(Timeline const& timeline, Vec2 const& pixel, Vec2 const& size);

std::vector<Shape> timeline_shapes(Timeline const& timeline, Vec2 const& size);

}  // namespace view
