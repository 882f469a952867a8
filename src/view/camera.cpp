#include "view/camera.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Sideways and up: over which time, s, the place and the velocity are averaged. The velocity turns round at a bounce,
// so it is the one that must be slow. Up and down there is less room to lag behind in.
struct Spans {
    double place, velocity;
    double mean_age() const { return 0.4 * place; }  // of weight()
};
constexpr Spans spans[] = {{1.0, 1.6}, {0.7, 1.2}};
constexpr double longest_span = 1.6;  // s
constexpr double spacing = 1.0 / 60;  // s, the path is taken as straight between whole multiples of it
constexpr double ahead = 0.3;         // s, how far ahead it looks in a steady motion, sideways
static_assert(longest_span + 2 * spacing < camera_memory);

// Up to the limits exactly x; smooth, and never beyond `most`, where |x| exceeds `free`.
double softly_limited(double x, double free, double most) {
    double const beyond = std::abs(x) - free, room = most - free;
    if (beyond <= 0) return x;
    return std::copysign(free + room * std::tanh(beyond / room), x);
}

// max(x, low) with a parabola in place of the bend; never below `low`, and x itself from low + width on.
double softly_above(double x, double low, double width) {
    if (x >= low + width) return x;
    if (x <= low - width) return low;
    double const rise = x - low + width;
    return low + rise * rise / (4 * width);
}

double softly_within(double x, double low, double high) {
    double const width = std::min(1.5, (high - low) / 4);
    if (!(width > 0)) return (low + high) / 2;
    return -softly_above(-softly_above(x, low, width), -high, width);
}

// Where a ball has fallen out it is no longer followed.
Vec2 followed(level::Level const& level, physics::History const& history, double time) {
    Vec2 const position = physics::state_at(history, level.player, std::max(time, history.from)).position;
    Vec2 place;
    for (int axis = 0; axis < 2; ++axis)
        place[axis] = softly_within(position[axis], -level.size[axis] / 2, level.size[axis] * 1.5);
    return place;
}

// The kernel over age by which the path is averaged, of area 1, and its derivative: the kernel and, at the far end, its
// slope are 0, so that the mean velocity is continuous where the ball's is not.
double weight(double age, double over) {
    return age < over ? 12 * age * (over - age) * (over - age) / (over * over * over * over) : 0;
}
double slope(double age, double over) {
    return age < over ? 12 * (over - age) * (over - 3 * age) / (over * over * over * over) : 0;
}

struct Mean {
    Vec2 position = Vec2::Zero();  // m
    Vec2 velocity = Vec2::Zero();  // m/s
};

// The integrals of the weights times position and velocity, from where the ball is now. The path is a chain of chords
// whose joints stand still while time goes on; over each of them three points of Gauss are exact.
Mean mean_of_path(level::Level const& level, physics::History const& history, double time) {
    struct Point {
        double place, share;
    };
    static double const node = std::sqrt(0.6);
    Point const points[] = {{-node, 5.0 / 18}, {0, 8.0 / 18}, {node, 5.0 / 18}};
    Vec2 const now = followed(level, history, time);
    Mean mean{now, Vec2::Zero()};
    double end = time;
    Vec2 place = now;
    for (double joint = std::ceil(time / spacing) - 1; end > time - longest_span; --joint) {
        double const start = joint * spacing;
        Vec2 const before = followed(level, history, start);
        double const from = std::max(start, time - longest_span);
        for (Point const& point : points) {
            double const when = (from + end) / 2 + (end - from) / 2 * point.place;
            Vec2 const off = before + (place - before) * ((when - start) / (end - start)) - now;
            for (int axis = 0; axis < 2; ++axis) {
                double const share = (end - from) * point.share * off[axis];
                mean.position[axis] += share * weight(time - when, spans[axis].place);
                mean.velocity[axis] += share * slope(time - when, spans[axis].velocity);
            }
        }
        end = start;
        place = before;
    }
    return mean;
}

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
    double const most = std::max(0.25 * view, 0.5 * view - radius);
    return ball - softly_limited(ball - centre, most - std::min(radius, 0.2 * most), most);
}

}  // namespace

Vec2 pixel_of(Camera const& camera, Vec2 const& world) {
    Vec2 const offset = (world - camera.centre) * camera.scale;
    return {camera.size.x() / 2 + offset.x(), camera.size.y() / 2 - offset.y()};
}

Vec2 world_of(Camera const& camera, Vec2 const& pixel) {
    Vec2 const offset = (pixel - camera.size / 2) / camera.scale;
    return {camera.centre.x() + offset.x(), camera.centre.y() - offset.y()};
}

geometry::Box sight_of(Camera const& camera) {
    Vec2 const half = camera.size / (2 * camera.scale);
    return {camera.centre - half, camera.centre + half};
}

double size_unit(level::Level const& level) { return wanted_width(level) / whole_width; }

Camera camera_at(level::Level const& level, physics::History const& history, double time, Vec2 const& size,
                 Lens const& lens) {
    Camera camera;
    camera.size = size;
    camera.scale = natural_scale(level, size) * lens.zoom;
    double const radius = level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    Vec2 const ball = followed(level, history, time);
    Vec2 const view = size / camera.scale;
    if (is_shown_whole(level) && lens.zoom <= 1) {
        show_whole(camera, level, ball, radius);
        return camera;
    }
    Mean const mean = mean_of_path(level, history, time);
    // Up and down it looks where the ball is: a bouncing one would rock the picture.
    Vec2 const lead(spans[0].mean_age() + ahead, spans[1].mean_age());
    for (int i = 0; i < 2; ++i) {
        double const lead_length = softly_limited(mean.velocity[i] * lead[i], 0, 0.3 * view[i]);
        double const looked_at = mean.position[i] + lead_length + lens.pan[i];
        camera.centre[i] = followed_by({ball[i], looked_at, radius, level.size[i], view[i]});
    }
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
    Vec2 const from_centre = world_of(camera, pixel) - camera.centre;
    after.pan += from_centre * (1 - lens.zoom / after.zoom);
    // Back at the natural zoom nothing of a pan is left; further in, the ball must stay in sight.
    Vec2 const reach = 0.4 * camera.size / camera.scale * (lens.zoom / after.zoom) * std::max(0.0, 1 - 1 / after.zoom);
    after.pan = after.pan.cwiseMax(-reach).cwiseMin(reach);
    return after;
}

}  // namespace view
