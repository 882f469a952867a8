#include "view/camera.h"

#include <algorithm>
#include <cmath>

#include "view/path_mean.h"
#include "view/soft_limits.h"

namespace view {

namespace {

constexpr double ahead = 0.3;  // s, how far ahead it looks in a steady motion, sideways

// Of a level that is not shown whole, how wide a part of it is seen: as many radii as in the levels that ship.
double wanted_width(level::Level const& level) {
    double constexpr least = 0.25, most = 0.6;  // m
    double const radius = level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    if (radius > most) return whole_width * radius / most;
    return radius < least ? whole_width * std::sqrt(radius / least) : whole_width;
}

bool is_shown_whole(level::Level const& level) {
    return level.size.x() <= whole_width && level.size.y() <= whole_height;
}

// What is seen of a level, m, before the picture's proportions are considered.
Vec2 natural_view(level::Level const& level) {
    Vec2 const least = Vec2::Constant(1e-6);
    if (is_shown_whole(level)) return level.size.cwiseMax(least);
    double const width = wanted_width(level);
    return level.size.cwiseMin(Vec2(width, width * whole_height / whole_width)).cwiseMax(least);
}

double natural_scale(level::Level const& level, Vec2 const& size) {
    Vec2 const view = natural_view(level);
    return std::min(size.x() / view.x(), size.y() / view.y());
}

// A level that is shown whole keeps still, and is seen from as far away as the ball needs that has left the picture.
void show_whole(Camera& camera, level::Level const& level, Vec2 const& ball, double radius) {
    Vec2 const margin = (camera.size / camera.scale - level.size) / 2;
    double farther = 1;
    for (int axis = 0; axis < 2; ++axis) {
        double const low = -margin[axis], high = level.size[axis] + margin[axis];
        double const below = softly_above(low - (ball[axis] - radius), 0, radius);
        double const above = softly_above(ball[axis] + radius - high, 0, radius);
        farther += (below + above) / (high - low);
        camera.centre[axis] = (low - below + high + above) / 2;
    }
    camera.scale /= farther;
}

// One axis: how far from the middle of what is seen a ball is, m, when it is never beyond the edge.
double kept_in_sight(double off, double radius, double view) {
    double const most = std::max(0.25 * view, 0.5 * view - radius);
    return softly_limited(off, most - std::min(radius, 0.2 * most), most);
}

// One axis: ahead of the ball, within the level where it is larger than the view, as far beyond it as the ball is, and
// never without the ball.
struct Axis {
    double ball, looked_at, radius;  // m
    double extent, view;             // m, of the level and of what is seen of it
};
double followed_by(Axis const& axis) {
    auto const& [ball, looked_at, radius, extent, view] = axis;
    double const margin = std::max(0.0, (view - extent) / 2), width = 3 * radius;
    double const below = softly_above(radius - margin - ball, 0, width);
    double const above = softly_above(ball + radius - extent - margin, 0, width);
    double const low = std::min(view, extent) / 2 - below, high = std::max(extent - view / 2, extent / 2) + above;
    double const centre = softly_within(looked_at, low, high);
    return ball - kept_in_sight(ball - centre, radius, view);
}

}  // namespace

Vec2 pixels_along(Camera const& camera, Vec2 const& way) {
    return {geometry::dot(way, camera.right) * camera.scale, -geometry::cross(camera.right, way) * camera.scale};
}

Vec2 pixel_of(Camera const& camera, Vec2 const& world) {
    return camera.size / 2 + pixels_along(camera, world - camera.centre);
}

Vec2 world_of(Camera const& camera, Vec2 const& pixel) {
    Vec2 const offset = (pixel - camera.size / 2) / camera.scale;
    return camera.centre + offset.x() * camera.right - offset.y() * geometry::turned_left(camera.right);
}

double turn_of(Camera const& camera) { return std::atan2(camera.right.y(), camera.right.x()); }

geometry::Box sight_of(Camera const& camera) {
    Vec2 const half = camera.size / (2 * camera.scale), right = camera.right.cwiseAbs();
    Vec2 const reach(half.x() * right.x() + half.y() * right.y(), half.x() * right.y() + half.y() * right.x());
    return {camera.centre - reach, camera.centre + reach};
}

double size_unit(level::Level const& level) { return wanted_width(level) / whole_width; }

Camera camera_at(level::Level const& level, physics::History const& history, double time, Vec2 const& size,
                 Lens const& lens) {
    Camera camera;
    camera.size = size;
    bool const is_calm = lens.motion == Motion::reduced && !is_shown_whole(level);
    camera.scale = natural_scale(level, size) * lens.zoom * (is_calm ? calm_zoom : 1);
    double const radius = level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    Vec2 const ball = followed(level, history, time);
    Vec2 const view = size / camera.scale;
    if (is_shown_whole(level) && lens.zoom <= 1) {
        show_whole(camera, level, ball, radius);
        return camera;
    }
    PathMean const mean = mean_of_path(level, history, time);
    // Up and down it looks where the ball is: a bouncing one would rock the picture.
    Vec2 const lead(spans[0].mean_age() + (lens.motion == Motion::reduced ? 0 : ahead), spans[1].mean_age());
    for (int i = 0; i < 2; ++i) {
        double const lead_length = softly_limited(mean.velocity[i] * lead[i], 0, 0.3 * view[i]);
        double const looked_at = mean.position[i] + lead_length + lens.pan[i];
        camera.centre[i] = followed_by({ball[i], looked_at, radius, level.size[i], view[i]});
    }
    return camera;
}

Camera turned_camera(Camera camera, level::Level const& level, physics::History const& history, double time,
                     double turn) {
    if (turn == 0) return camera;
    double const cosine = std::cos(turn), sine = std::sin(turn);
    PathMean const mean = mean_of_path(level, history, time);
    Vec2 const late(spans[0].mean_age(), spans[1].mean_age());
    Vec2 const pivot = mean.position + late.cwiseProduct(mean.velocity);
    Vec2 const ball = followed(level, history, time), before = camera.centre;
    camera.centre = pivot + geometry::turned(before - pivot, cosine, sine);
    camera.right = Vec2(cosine, sine);
    // What may be beyond the edge now is moved in, but no more than it was already.
    double const radius = level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    Vec2 const off = geometry::turned(ball - camera.centre, cosine, -sine);
    Vec2 shift = Vec2::Zero();
    for (int i = 0; i < 2; ++i) {
        double const view = camera.size[i] / camera.scale, earlier = ball[i] - before[i];
        shift[i] = kept_in_sight(off[i], radius, view) - off[i] - (kept_in_sight(earlier, radius, view) - earlier);
    }
    camera.centre -= geometry::turned(shift, cosine, sine);
    camera.swing = camera.centre - before;
    return camera;
}

Vec2 middle_of(physics::Region const& region) {
    if (auto const* disc = std::get_if<physics::DiscRegion>(&region)) return disc->centre;
    if (auto const* line = std::get_if<physics::LineRegion>(&region)) return (line->from + line->to) / 2;
    geometry::Box box;
    for (Vec2 const& corner : std::get<physics::PolygonRegion>(region).corners)
        box = geometry::united(box, {corner, corner});
    return (box.low + box.high) / 2;
}

Camera towards_goal(level::Level const& level, Camera camera, double share) {
    auto const goal = std::find(level.meanings.begin(), level.meanings.end(), level::Meaning::goal);
    if (share <= 0 || goal == level.meanings.end()) return camera;
    Vec2 const place = middle_of(level.scene.sensors[static_cast<std::size_t>(goal - level.meanings.begin())].region);
    Vec2 const view = camera.size / camera.scale;
    for (int axis = 0; axis < 2; ++axis) {
        if (level.size[axis] <= view[axis]) continue;
        double const there = softly_within(place[axis], view[axis] / 2, level.size[axis] - view[axis] / 2);
        camera.centre[axis] += share * (there - camera.centre[axis]);
    }
    return camera;
}

Lens zoomed(Lens const& lens, Camera const& camera, Vec2 const& pixel, double notches) {
    Lens after = lens;
    after.zoom = std::clamp(lens.zoom * std::pow(1.15, notches), least_zoom, greatest_zoom);
    // A pan is along the world's axes before the turn.
    Vec2 const off = (pixel - camera.size / 2) / camera.scale, from_centre(off.x(), -off.y());
    after.pan += from_centre * (1 - lens.zoom / after.zoom);
    // Back at the natural zoom nothing of a pan is left; further in, the ball must stay in sight.
    Vec2 const reach = 0.4 * camera.size / camera.scale * (lens.zoom / after.zoom) * std::max(0.0, 1 - 1 / after.zoom);
    after.pan = after.pan.cwiseMax(-reach).cwiseMin(reach);
    return after;
}

}  // namespace view
