#include "physics/sense.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace physics {

namespace {

// How far outside a region a ball is, and how fast that grows; <= 0 is inside.
struct Gap {
    double value = 0;  // m
    double rate = 0;   // m/s
};

Gap gap_to(DiscRegion const& disc, double reach, State const& state) {
    Vec2 const way = state.position - disc.centre;
    double const distance = geometry::length(way);
    return {distance - disc.radius - reach, distance > 0 ? geometry::dot(way, state.velocity) / distance : 0};
}

// From edge i's line, positive to its right, which is outside of a counter-clockwise polygon.
Gap gap_to_edge(PolygonRegion const& polygon, std::size_t i, State const& state) {
    Vec2 const& a = polygon.corners[i];
    Vec2 const way = polygon.corners[(i + 1) % polygon.corners.size()] - a;
    Vec2 const outward = geometry::turned_right(way) / geometry::length(way);
    return {geometry::dot(state.position - a, outward), geometry::dot(state.velocity, outward)};
}

// The edge farthest out bounds the distance from below, and is exactly zero on the polygon's edge.
Gap gap_to(PolygonRegion const& polygon, State const& state) {
    Gap widest{-never, 0};
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        Gap const gap = gap_to_edge(polygon, i, state);
        if (gap.value > widest.value) widest = gap;
    }
    return widest;
}

// A time in which a gap cannot close while |acceleration| <= bound (physics.md 3.2, for the least of several edges
// with every speed at most `speed`).
double safe_time(double gap, double closing, double bound) {
    if (gap <= 0) return 0;
    double const root = std::sqrt(closing * closing + 2 * bound * gap);
    double const denominator = closing + root;
    return denominator > 0 ? 2 * gap / denominator : never;
}

struct Watch {
    Sensor const& sensor;
    double radius;

    // The gap whose fall through zero is the event, with the fastest it may close now.
    Gap operator()(State const& state) const {
        if (auto const* disc = std::get_if<DiscRegion>(&sensor.region))
            return gap_to(*disc, sensor.rim ? radius : 0, state);
        auto const* polygon = std::get_if<PolygonRegion>(&sensor.region);
        Gap const gap = gap_to(*polygon, state);
        // Which edge is the farthest may change on the way: only the speed bounds all of them at once.
        double const speed = geometry::length(state.velocity);
        return sensor.outside ? Gap{-gap.value, -speed} : Gap{gap.value, -speed};
    }
};

constexpr int advancement_cap = 10000;  // steps of conservative advancement; a grazing path takes a few hundred

std::optional<double> first_entry(Watch const& watch, Leg const& leg, double from, double to) {
    double const bound = acceleration_bound(leg, from, to);
    double t = from;
    for (int i = 0; i < advancement_cap; ++i) {
        Gap const gap = watch(at(leg, t));
        if (gap.value <= sensor_accuracy) return t;
        t += safe_time(gap.value, -gap.rate, bound);
        if (!(t <= to)) return std::nullopt;
    }
    return t;
}

// The first crossing of a line's stretch by the centre.
std::optional<double> first_crossing(LineRegion const& line, Leg const& leg, double from, double to) {
    Vec2 const way = line.to - line.from;
    double const span = geometry::length(way);
    Vec2 const normal = geometry::turned_left(way) / span;
    double const bound = acceleration_bound(leg, from, to);
    double t = from;
    for (int i = 0; i < advancement_cap; ++i) {
        State const state = at(leg, t);
        double const height = geometry::dot(state.position - line.from, normal);
        double const rate = geometry::dot(state.velocity, normal);
        double const along = geometry::dot(state.position - line.from, way) / span;
        bool const there = std::abs(height) <= sensor_accuracy;
        if (there && along >= 0 && along <= span) return t;
        // Next to the line but beyond its ends: no nearer to it than the way back to an end.
        double const beyond = std::max({0.0, -along, along - span});
        double const gap = std::max(std::abs(height), beyond);
        double const closing = gap > beyond ? (height > 0 ? -rate : rate) : geometry::length(state.velocity);
        t += std::max(safe_time(gap, closing, bound), there ? 1e-9 : 0.0);
        if (!(t <= to)) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<double> first_notice(Sensor const& sensor, double radius, Leg const& leg, double from, double to) {
    if (auto const* line = std::get_if<LineRegion>(&sensor.region)) return first_crossing(*line, leg, from, to);
    return first_entry({sensor, radius}, leg, from, to);
}

struct Notice {
    double time = never;
    int ball = 0;
};

std::optional<double> first_notice_by(Scene const& scene, History const& history, Sensor const& sensor, int ball,
                                      double from, double to) {
    Trail<Leg> const& legs = history.legs[ball];
    auto leg = std::upper_bound(legs.begin(), legs.end(), from, [](double t, Leg const& l) { return t < l.since; });
    if (leg != legs.begin()) --leg;
    for (; leg != legs.end() && leg->since <= to; ++leg) {
        double const end = leg + 1 == legs.end() ? to : std::min(to, (leg + 1)->since);
        auto const time = first_notice(sensor, scene.balls[ball].radius, *leg, std::max(from, leg->since), end);
        if (time) return time;
    }
    return std::nullopt;
}

void add_in_order(History& history, Event const& event) {
    auto const place = std::upper_bound(history.events.begin(), history.events.end(), event.time,
                                        [](double t, Event const& e) { return t < e.time; });
    history.events.insert(place, event);
}

void note(World& world, History& history, int sensor, int ball, double time) {
    add_in_order(history, {time, EventKind::sensor, ball, state_at(history, ball, time), no_contact, sensor});
    world.noticed[sensor][ball] = true;
}

}  // namespace

std::vector<std::vector<bool>> nothing_noticed(Scene const& scene) {
    return {scene.sensors.size(), std::vector<bool>(scene.balls.size(), false)};
}

void sense(Scene const& scene, World& world, double from, double to, History& history) {
    for (int i = 0; i < static_cast<int>(scene.sensors.size()); ++i) {
        Sensor const& sensor = scene.sensors[i];
        Notice first;
        for (int ball = 0; ball < static_cast<int>(scene.balls.size()); ++ball) {
            if ((sensor.ball >= 0 && sensor.ball != ball) || world.noticed[i][ball]) continue;
            auto const time = first_notice_by(scene, history, sensor, ball, from, to);
            if (!time) continue;
            if (sensor.each_ball)
                note(world, history, i, ball, *time);
            else if (*time < first.time)
                first = {*time, ball};
        }
        if (first.time == never) continue;
        note(world, history, i, first.ball, first.time);
        world.noticed[i].assign(scene.balls.size(), true);
    }
}

}  // namespace physics
