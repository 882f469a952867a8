// Shapes as the records that the shaders take, collected in order: no GL here.
#pragma once

#include <array>
#include <vector>

#include "screen/coverage.h"
#include "view/picture.h"

namespace screen {

enum class Program { disc, box, arc, plain_area, smooth_area, smooth_edge, grained_area, grained_edge, glyph, shell };
constexpr int program_count = 10;

// Whether what lies below shows through; where it does not, painting costs less.
enum class Blending { over, opaque };

// What one quad is drawn from; shaders.h says what each program takes place and form for.
struct Quad {
    std::array<float, 8> corners{};  // pixels, in the order of a triangle strip
    std::array<float, 4> place{}, form{}, colour{}, second_colour{}, more{0, 1, 0, 0};
};

struct Run {
    Program program;
    Blending blending;
    int first = 0, count = 0;  // quads
};

struct Batch {
    std::vector<Quad> quads;
    std::vector<Run> runs;

    bool is_empty() const { return quads.empty(); }
    void add(Program program, Quad const& quad, Blending blending = Blending::over);
    void clear();
};

// A box given by two corners.
std::array<float, 8> upright(double left, double top, double right, double bottom);
std::array<float, 4> floats(view::Colour const& colour);
// Its own colours, or those of its number.
view::Livery livery_of(view::Shell const& shell);

// A box of the sky of a picture so high, pixels.
void add_shape(Batch& batch, view::Sky const& sky, Box const& box, int height);
void add_shape(Batch& batch, view::Disc const& disc);
void add_shape(Batch& batch, view::Stroke const& stroke);
void add_shape(Batch& batch, view::ArcStroke const& arc);
void add_shape(Batch& batch, view::Panel const& panel);
void add_shape(Batch& batch, view::Shell const& shell);

}  // namespace screen
