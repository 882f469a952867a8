#include "view/effects.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/palette.h"

namespace view {

namespace {

bool is_seen(Camera const& camera, Vec2 const& place, double size) {
    return geometry::overlap(sight_of(camera), geometry::grown({place, place}, size));
}

// 0 but for an eighth of a second now and then, by simulated time.
double blink_at(double time, int ball) {
    constexpr double period = 2.9, closing = 0.13;  // s
    double const late = std::fmod(time + 0.83 * (ball % 7 + 1), period);
    return late < closing ? std::sin(geometry::pi * late / closing) : 0;
}

}  // namespace

std::vector<Shape> trail_shapes(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    for (std::size_t ball = 0; ball < moment.wakes.size(); ++ball) {
        std::vector<Vec2> const& trail = moment.wakes[ball].trail;
        double const radius = level.scene.balls[ball].radius;
        if (trail.size() < 3 || !is_seen(camera, trail.back(), 12 * radius)) continue;
        std::vector<Vec2> left, right;
        for (std::size_t i = 0; i < trail.size(); ++i) {
            Vec2 const way = trail[std::min(i + 1, trail.size() - 1)] - trail[i > 0 ? i - 1 : 0];
            double const length = geometry::length(way);
            if (length < 1e-9) continue;
            double const share = static_cast<double>(i) / static_cast<double>(trail.size() - 1);
            Vec2 const aside = 0.92 * radius * share * geometry::turned_left(way) / length;
            left.push_back(pixel_of(camera, trail[i] + aside));
            right.push_back(pixel_of(camera, trail[i] - aside));
        }
        Vec2 const head = pixel_of(camera, trail.back()), tail = pixel_of(camera, trail.front());
        if (left.size() < 3 || geometry::length(tail - head) < 1) continue;
        Area area;
        area.rings = {left};
        area.rings[0].insert(area.rings[0].end(), right.rbegin(), right.rend());
        float const strength = static_cast<float>(moment.wakes[ball].haste);
        area.paint.down = (tail - head) / geometry::length(tail - head);
        area.paint.top = faded(palette::bright, 0.5f * strength);
        area.paint.bottom = faded(palette::bright, 0);
        area.paint.top_y = geometry::dot(head, area.paint.down);
        area.paint.bottom_y = geometry::dot(tail, area.paint.down);
        shapes.emplace_back(std::move(area));
    }
    return shapes;
}

std::vector<Shape> dust_shapes(Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    for (Wake const& wake : moment.wakes)
        for (Fleck const& fleck : wake.dust) {
            if (!is_seen(camera, fleck.place, fleck.size)) continue;
            double const radius = fleck.size * camera.scale;
            float const strength = static_cast<float>((1 - fleck.age) * 0.75);
            Vec2 const at = pixel_of(camera, fleck.place);
            shapes.emplace_back(Disc{at, radius, faded(palette::dust, strength), {}, 0, 0.8 * radius});
        }
    return shapes;
}

std::vector<Shape> spark_shapes(Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    for (Wake const& wake : moment.wakes)
        for (Fleck const& fleck : wake.sparks) {
            if (!is_seen(camera, fleck.place, 10 * fleck.size)) continue;
            float const left = static_cast<float>(1 - fleck.age);
            Vec2 const at = pixel_of(camera, fleck.place);
            Vec2 const tail = at - pixels_along(camera, fleck.way) * 0.035 * (1 - fleck.age);
            double const width = fleck.size * camera.scale * (0.5 + 0.5 * left);
            shapes.emplace_back(Stroke{tail, at, 1.9 * width, faded(palette::strain, 0.6f * left)});
            shapes.emplace_back(Stroke{tail, at, width, faded(palette::spark, left)});
        }
    return shapes;
}

Monkey monkey_of(Moment const& moment, int ball, Shell const& shell, Camera const& camera,
                 std::optional<Vec2> const& pointer) {
    Monkey monkey;
    auto const index = static_cast<std::size_t>(ball);
    physics::State const& state = moment.balls[index];
    Wake const wake = index < moment.wakes.size() ? moment.wakes[index] : Wake{};
    double const run = std::abs(wake.spin) * shell.radius / camera.scale;  // m/s, of the shell past its feet
    // Carried round by the shell as far as it is loose and turns: where both sides pull equally it goes over quickly.
    double const carried = wake.loose * std::clamp(run, 0.0, 1.0);
    double const up = 1 - carried + carried * std::cos(shell.angle), aside = carried * std::sin(shell.angle);
    double const push = geometry::dot(wake.push, camera.right), speed = geometry::dot(state.velocity, camera.right);
    double const hurry = std::clamp(run / 6, 0.0, 1.0) * std::tanh(speed);
    monkey.lean = std::atan2(aside, up) - (1 - carried) * (0.35 * std::tanh(push / 10) + 0.12 * hurry);
    double const cycles = state.angle / geometry::pi;  // two a turn
    monkey.stride = cycles - std::floor(cycles);
    monkey.swing = std::clamp(run / 1.5, 0.0, 1.0);
    monkey.blink = blink_at(moment.time, ball);
    if (pointer) {
        Vec2 const way = *pointer - shell.centre;
        monkey.gaze = way / std::max(geometry::length(way), 2 * shell.radius);
    } else {
        Vec2 const way = pixels_along(camera, state.velocity) / camera.scale;
        double const length = geometry::length(way);
        monkey.gaze = length > 1e-9 ? Vec2(way * (std::tanh(length / 3) / length)) : Vec2(Vec2::Zero());
    }
    return monkey;
}

}  // namespace view
