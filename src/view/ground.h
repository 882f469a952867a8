// The ground as people see it: earth with a lit, grassy edge wherever the terrain faces up, and an edge that shows what
// it does where it is slippery, sticky, soft or bouncy. In metres, for any camera.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "level/level.h"
#include "view/bodies.h"
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

// The ground of a level, which must outlive it. The paint of a body is made when that comes into a sight for the first
// time: large drawings have tens of thousands that no picture shows.
class LazyGround {
public:
    LazyGround() = default;  // none
    explicit LazyGround(level::Level const& level);

    // What overlaps a sight, in m. Threads may ask at the same time.
    Ground within(geometry::Box const& sight) const;

private:
    struct Painted {
        std::once_flag once;
        std::unique_ptr<Ground const> ground;
    };
    Ground const& painted(std::size_t body) const;

    level::Level const* level_ = nullptr;
    bool plain_ = true;  // all of it is grass
    std::vector<Body> bodies_;
    std::vector<geometry::Box> boxes_;  // by body: what its paint lies in
    std::unique_ptr<Painted[]> painted_;
};

Ground ground_of(level::Level const& level);  // all of it

std::vector<Shape> ground_shapes(Ground const& ground, Camera const& camera);

}  // namespace view
