// A picture as data: what to paint, back to front, in pixels (x right, y down, origin at the upper left corner).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/fill_rule.h"
#include "geometry/vector.h"

namespace view {

using geometry::Vec2;

struct Colour {  // sRGB, straight alpha, each 0 to 1
    float red = 0, green = 0, blue = 0, alpha = 1;
};

// Fills the whole picture from the top colour to the bottom one.
struct Sky {
    Colour top, bottom;
};

// A filled disc with a rim inside its edge; softness > 0 blurs the edge over that many pixels (shadows, glow).
struct Disc {
    Vec2 centre = Vec2::Zero();
    double radius = 0;
    Colour fill;
    Colour rim;
    double rim_width = 0;
    double softness = 0;
};

// A straight stroke with round ends.
struct Stroke {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    double width = 1;
    Colour colour;
};

// A stroke along a circle, round ends; angles as seen on the screen: from the x axis, clockwise positive (y is down).
struct ArcStroke {
    Vec2 centre = Vec2::Zero();
    double radius = 0;
    double from = 0, sweep = 0;  // rad
    double width = 1;
    Colour colour;
};

// How an area is filled: a gradient along `down`, and a grain that is fixed to the world and upright along it.
struct Paint {
    Colour top, bottom;
    double top_y = 0, bottom_y = 1;    // pixels from the picture's corner, along `down`
    double grain = 0;                  // 0 smooth to 1 strong
    Vec2 grain_origin = Vec2::Zero();  // pixel at which the world's origin lies
    double grain_scale = 1;            // pixels per metre
    Vec2 down = Vec2::UnitY();         // unit, on the screen: the world's way down
};

// Rings are closed polylines.
struct Area {
    std::vector<std::vector<Vec2>> rings;
    Paint paint;
    geometry::FillRule rule = geometry::FillRule::even_odd;
};

// The colours of a shell's two halves.
struct Livery {
    Colour upper, lower;
};

// How the monkey in a ball bears itself.
struct Monkey {
    double lean = 0;           // rad, counter-clockwise on the screen
    double stride = 0;         // 0 to 1, of a cycle of its legs
    double swing = 0;          // 0 it stands, to 1 it runs
    double blink = 0;          // 0 to 1: its eyes are closed
    Vec2 gaze = Vec2::Zero();  // on the screen, at most 1 long; 0 = straight ahead
};

// The ball: a striped, see-through shell that turns about a monkey; angle counter-clockwise on the screen.
struct Shell {
    Vec2 centre = Vec2::Zero();
    double radius = 0;
    double angle = 0;                          // rad
    int livery = 0;                            // which pair of colours, 0 = the player's
    Vec2 light = {-0.5, -0.8};                 // towards the light, on the screen
    std::optional<Livery> own = std::nullopt;  // in place of that pair
    Monkey monkey = {};
};

enum class Anchor { Left, Centre, Right };
enum class Weight { regular, bold };

struct Label {
    Vec2 at = Vec2::Zero();  // the base line's left end, middle or right end
    double height = 16;      // pixels from base line to base line
    std::string text;        // UTF-8
    Colour colour;
    Anchor anchor = Anchor::Left;
    Weight weight = Weight::regular;
    double swell = 0;  // pixels by which letters are thicker on every side: what lies behind others as their rim
};

// A rectangle with rounded corners, for panels and bars.
struct Panel {
    Vec2 corner = Vec2::Zero(), size = Vec2::Zero();
    double rounding = 0;
    Colour colour;
};

using Shape = std::variant<Sky, Area, Disc, Stroke, ArcStroke, Shell, Panel, Label>;

struct Picture {
    int width = 1280, height = 720;
    std::vector<Shape> backdrop;          // what stays the same while the camera rests: may be kept by the painter
    unsigned long long backdrop_key = 0;  // equal keys promise equal backdrops of equal size; 0 = do not keep
    std::vector<Shape> shapes;            // painted over the backdrop, in order
};

}  // namespace view
