#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/actors.h"
#include "view/palette.h"

namespace view {

namespace {

constexpr int most_half_turns = 22;
constexpr double least_pitch = 1.1;  // units: a short spring shows fewer turns, not a block

// The coil from the side: half turns in front lean one way, those behind the other.
std::vector<Vec2> coil(Vec2 const& from, Vec2 const& to, double lead, double amplitude, double unit) {
    Vec2 const way = to - from;
    double const length = geometry::length(way);
    Vec2 const along = way / length;
    Vec2 const across = geometry::turned_left(along);
    std::vector<Vec2> points = {from, from + lead * along};
    int const half_turns = std::clamp(static_cast<int>((length - 2 * lead) / (least_pitch * unit)), 2, most_half_turns);
    double const pitch = (length - 2 * lead) / half_turns;
    for (int i = 0; i < half_turns; ++i) {
        double const side = i % 2 == 0 ? amplitude : -amplitude;
        points.push_back(from + (lead + (i + 0.5) * pitch) * along + side * across);
    }
    points.push_back(to - lead * along);
    points.push_back(to);
    return points;
}

void add_hand(std::vector<Shape>& shapes, Vec2 const& at, double size, Colour const& wire) {
    shapes.emplace_back(ArcStroke{at, 1.5 * size, 0, 2 * geometry::pi, 0.75 * size, palette::ink});
    shapes.emplace_back(ArcStroke{at, 1.5 * size, 0, 2 * geometry::pi, 0.4 * size, palette::bright});
    shapes.emplace_back(Disc{at, 0.7 * size, wire, palette::ink, 0.2 * size, 0});
}

}  // namespace

std::vector<Shape> spring_shapes(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    if (!moment.forces.pull) return shapes;
    physics::Pull const& pull = *moment.forces.pull;
    Vec2 const from = pixel_of(camera, moment.balls[static_cast<std::size_t>(pull.ball)].position);
    Vec2 const to = pixel_of(camera, pull.target);
    double const length = geometry::length(to - from);
    double const unit = 0.05 * size_unit(level) * camera.scale;
    double const stretch = std::clamp(length / (level.drag_reach * camera.scale), 0.0, 1.0);
    // 0 with the hook within the ball to 1 where it is well outside.
    double const radius = level.scene.balls[static_cast<std::size_t>(pull.ball)].radius * camera.scale;
    double const clear = std::clamp((length - 0.7 * radius) / radius, 0.0, 1.0);
    Colour const wire = mixed(palette::steel, palette::strain, static_cast<float>(stretch));
    Colour const back = mixed(palette::steel_back, palette::strain, static_cast<float>(0.5 * stretch));
    if (length > 2 * unit) {
        // The wire keeps its length: a coil that is drawn out becomes slimmer.
        // Within the ball it is slim and faint, so that neither coils nor hook hide the monkey.
        double const slim = std::min(1.0, 0.25 * length / unit / 3.6) * (0.4 + 0.6 * clear);
        double const amplitude = 3.6 * unit * slim * std::sqrt(std::max(0.12, 1 - stretch * stretch));
        float const seen = static_cast<float>(0.35 + 0.65 * clear);
        double const lead = std::min(3 * unit, 0.2 * length);
        std::vector<Vec2> const points = coil(from, to, lead, amplitude, unit);
        std::size_t const last = points.size() - 1;
        for (std::size_t i = 0; i < last; ++i)
            shapes.emplace_back(Stroke{points[i], points[i + 1], 1.35 * unit, faded(palette::ink, 0.85f * seen)});
        for (std::size_t i = 0; i < last; i += 2)
            shapes.emplace_back(Stroke{points[i], points[i + 1], 0.7 * unit, faded(back, seen)});
        for (std::size_t i = 1; i < last; i += 2)
            shapes.emplace_back(Stroke{points[i], points[i + 1], 0.8 * unit, faded(wire, seen)});
    }
    double const knob = (0.5 + 0.5 * clear) * unit;
    shapes.emplace_back(Disc{from, 1.3 * knob, palette::steel, palette::ink, 0.35 * knob, 0});
    add_hand(shapes, to, (1.1 + 0.9 * clear) * unit, wire);
    return shapes;
}

}  // namespace view
