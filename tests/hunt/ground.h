// The ground as the judge sees it: straight and round limbs, and how far they are. Shares no code with what moves
// balls.
#pragma once

#include <vector>

#include "hunt/sketch.h"

namespace hunt {

struct Limb {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    bool round = false;
    Vec2 centre = Vec2::Zero();
    double radius = 0;
    double start = 0, sweep = 0;  // rad, as geometry::Arc
    // A circle that the limb lies in.
    Vec2 middle = Vec2::Zero();
    double reach = 0;
    double friction = 0, resistance = 0;
};
using Ground = std::vector<Limb>;

Limb bar(Vec2 const& from, Vec2 const& to);
Limb round_limb(Vec2 const& centre, double radius, double start, double sweep);
// The circle of an arc that is given by its ends, as SVG's appendix on arcs says.
Limb limb_of(Bow const& bow);

Ground ground_of(physics::Terrain const& terrain);
// As drawn. Curves become chords that are off by some 1e-3 of their size at most.
Ground ground_of(std::vector<Element> const& elements);

struct Foot {
    Vec2 point = Vec2::Zero();
    double distance = 1e300;  // m
    int limb = -1;
};
Foot foot_on(Limb const& limb, Vec2 const& from);
Foot nearest_on(Ground const& ground, Vec2 const& from);
// All feet nearer than `reach`, one a limb.
std::vector<Foot> feet_within(Ground const& ground, Vec2 const& from, double reach);

}  // namespace hunt
