#include "view/trajectory_preview.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/palette.h"

namespace view {

namespace {

// Touches nearer to each other, or to where the ball is now, would only smear.
constexpr double touch_spacing = 0.6;  // radii
constexpr std::size_t most_touches = 3;
constexpr double dot_clearance = 0.12;  // radii: a dot nearer to the one before is left out

bool is_touch(physics::Event const& event, int ball) {
    using enum physics::EventKind;
    if (event.kind == hit) return event.ball == ball || event.other == ball;
    return event.ball == ball && (event.kind == land || event.kind == bounce);
}

bool is_near(Vec2 const& a, Vec2 const& b, double distance) { return geometry::length(a - b) < distance; }

std::vector<TrajectoryPreview::Sight> dots_on(physics::History const& coming, int ball, double time, double horizon,
                                              double clearance) {
    std::vector<TrajectoryPreview::Sight> dots;
    Vec2 last = physics::state_at(coming, ball, time).position;
    for (double i = std::floor(time / dot_spacing) + 1; i * dot_spacing <= time + horizon; ++i) {
        Vec2 const place = physics::state_at(coming, ball, i * dot_spacing).position;
        if (is_near(place, last, clearance)) continue;
        dots.push_back({place, i * dot_spacing - time});
        last = place;
    }
    return dots;
}

float presence_of(TrajectoryPreview const& preview, TrajectoryPreview::Sight const& sight) {
    return static_cast<float>(std::clamp(1 - sight.ahead / preview.horizon, 0.0, 1.0));
}

void add_ring(std::vector<Shape>& shapes, Vec2 const& at, double radius, double width, Colour const& paint) {
    shapes.emplace_back(
        ArcStroke{at, radius, 0, 2 * geometry::pi, 1.8 * width, faded(palette::ink, 0.35f * paint.alpha)});
    shapes.emplace_back(ArcStroke{at, radius, 0, 2 * geometry::pi, width, paint});
}

}  // namespace

TrajectoryPreview trajectory_preview(physics::History const& coming, physics::Scene const& scene, int ball, double time,
                                     double horizon) {
    TrajectoryPreview preview;
    preview.radius = scene.balls[static_cast<std::size_t>(ball)].radius;
    preview.horizon = horizon;
    time = std::max(time, coming.from);
    preview.dots = dots_on(coming, ball, time, horizon, dot_clearance * preview.radius);
    Vec2 last = physics::state_at(coming, ball, time).position;
    double const apart = touch_spacing * preview.radius;
    for (physics::Event const& event : coming.events) {
        if (event.time > time + horizon || preview.touches.size() == most_touches) break;
        if (!is_touch(event, ball)) continue;
        Vec2 const place = physics::state_at(coming, ball, event.time).position;
        if (is_near(place, last, apart)) continue;
        preview.touches.push_back({place, event.time - time});
        last = place;
    }
    return preview;
}

std::vector<Shape> trajectory_shapes(TrajectoryPreview const& preview, Camera const& camera) {
    std::vector<Shape> shapes;
    double const unit = 0.02 * camera.scale * std::clamp(preview.radius / 0.4, 0.4, 2.0);
    bool const held = preview.premise == Premise::held;
    Colour const paint = held ? palette::strain : palette::bright;
    double const thick = held ? 0.8 : 1.0;
    for (TrajectoryPreview::Sight const& dot : preview.dots) {
        float const presence = presence_of(preview, dot);
        double const radius = thick * unit * (1.1 + 1.5 * presence);
        Vec2 const at = pixel_of(camera, dot.place);
        shapes.emplace_back(Disc{at, radius + 0.7 * unit, faded(palette::ink, 0.3f * presence), {}, 0, 0.8 * unit});
        shapes.emplace_back(Disc{at, radius, faded(paint, 0.15f + 0.8f * presence), {}, 0, 0});
    }
    if (held) return shapes;  // where the spring's end is says it already
    for (TrajectoryPreview::Sight const& touch : preview.touches) {
        float const presence = presence_of(preview, touch);
        add_ring(shapes, pixel_of(camera, touch.place), (preview.radius * camera.scale) - unit, 1.3 * unit,
                 faded(paint, 0.35f + 0.5f * presence));
    }
    return shapes;
}

}  // namespace view
