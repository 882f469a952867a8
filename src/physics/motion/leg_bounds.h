// Bounds on where a leg leads between two times, that hold for certain (to rounding), from its ends and from bounds on
// its acceleration: what a search by inclusion skips intervals with (physics.md 3.10).
#pragma once

#include <optional>

#include "physics/motion/leg.h"

namespace physics {

struct Range {
    double low = 0, high = 0;
};

// The part of a leg between two times, both in seconds since the leg began.
class LegPart {
public:
    LegPart(Leg const& leg, double from, double to);

    // Of (position - origin) . direction, m, the direction being of length 1.
    Range along(Vec2 const& origin, Vec2 const& direction) const;
    // Of |position - point|, m.
    Range distance_from(Vec2 const& point) const;

private:
    double acceleration_along(Vec2 const& direction) const;
    double acceleration() const;
    // A curve is nowhere farther from its chord than this, for an acceleration of at most so much.
    double sag(double acceleration) const { return 0.125 * (to_ - from_) * (to_ - from_) * acceleration; }

    Leg const& leg_;
    double from_, to_;
    Vec2 begin_ = Vec2::Zero(), end_ = Vec2::Zero();  // m, the positions at the ends
    // Where the ball runs round a circle, it is there that it cannot leave: within a range of polar angles.
    struct Round {
        Vec2 centre = Vec2::Zero();
        double rho = 0;  // m
        Range angles;    // rad
    };
    std::optional<Round> round_;
};

}  // namespace physics
