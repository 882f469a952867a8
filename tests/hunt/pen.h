// A pen: lines and arcs that go on where the last one ended, with its tangent.
#pragma once

#include <cmath>
#include <vector>

#include "hunt/dice.h"
#include "hunt/sketch.h"

namespace hunt {

class Pen {
public:
    Pen(Vec2 const& at, Vec2 const& heading) : at_(at), heading_(heading) {}

    Pen& ahead(double length) {
        Vec2 const to = at_ + length * heading_;
        strokes_.push_back(Line{at_, to});
        at_ = to;
        return *this;
    }
    // Counter-clockwise where the angle is positive. More than half a turn is drawn in two arcs.
    Pen& bend(double radius, double angle) {
        if (std::abs(angle) > geometry::pi) return bend(radius, angle / 2).bend(radius, angle / 2);
        auto const [sine, cosine] = geometry::sine_cosine(angle);
        Vec2 const centre = at_ + (angle < 0 ? -radius : radius) * geometry::turned_left(heading_);
        Vec2 const to = centre + geometry::turned(at_ - centre, cosine, sine);
        strokes_.push_back(Bow{at_, to, radius, false, angle > 0});
        at_ = to;
        heading_ = geometry::turned(heading_, cosine, sine);
        return *this;
    }
    Pen& corner(double angle) {
        auto const [sine, cosine] = geometry::sine_cosine(angle);
        heading_ = geometry::turned(heading_, cosine, sine);
        return *this;
    }
    Pen& to(Vec2 const& point) {
        strokes_.push_back(Line{at_, point});
        heading_ = (point - at_) / geometry::length(point - at_);
        at_ = point;
        return *this;
    }

    Vec2 const& at() const { return at_; }
    std::vector<Stroke> const& strokes() const { return strokes_; }

private:
    Vec2 at_, heading_;
    std::vector<Stroke> strokes_;
};

}  // namespace hunt
