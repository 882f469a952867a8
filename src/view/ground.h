// The ground as people see it: earth with a lit, grassy edge wherever the terrain faces up, and an edge that shows what
// it does where it is slippery, sticky, soft or bouncy. In metres, for any camera.
#pragma once

#include <vector>

#include "level/level.h"
#include "view/camera.h"
#include "view/picture.h"

namespace view {

enum class Cover { earth, shade, rim, turf, lit, ice, mud, tread, rubber };

struct Patch {                             // filled by the even-odd rule
    std::vector<std::vector<Vec2>> rings;  // m
    geometry::Box box;
    Cover cover = Cover::earth;
};

struct Tuft {                  // blades of grass, now and then a flower
    Vec2 root = Vec2::Zero();  // m
    Vec2 up = Vec2::UnitY();
    double height = 0.1;  // m
    int kind = 0;
};

// Strokes and drops that tell surfaces apart without colour: glints along ice, drops of mud, studs of a tread, the
// coil of a spring.
enum class Sign { glint, sheen, drop, stud, coil };
struct Mark {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();  // m
    double width = 0.02;                          // m
    Sign sign = Sign::glint;
};

struct Ground {
    std::vector<Patch> patches;  // in the order of painting
    std::vector<Mark> marks;     // over them
    std::vector<Tuft> tufts;
};

Ground ground_of(level::Level const& level);

std::vector<Shape> ground_shapes(Ground const& ground, Camera const& camera);

}  // namespace view
