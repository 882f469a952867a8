// Sensors against closed forms and against looking at very many moments.
#include "physics/world/sensors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "physics/method.h"

using namespace physics;
using geometry::pi;

namespace {

constexpr double g = 9.81;  // m/s^2
std::vector<Method> const all_methods{Exact{}, Steps{}, Article{}};

Piece floor_at(double y, double restitution = 0) {
    return {geometry::Segment{{-100, y}, {100, y}}, {0.9, restitution, 0}, 0};
}

Ball ball_at(Vec2 const& place, Vec2 const& velocity = Vec2::Zero(), double spin = 0) {
    Ball ball;
    ball.start = {place, velocity, 0, spin};
    return ball;
}

Sensor rectangle(Vec2 const& low, Vec2 const& high) {
    Sensor sensor;
    sensor.region = PolygonRegion{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
    return sensor;
}

Sensor fence_line(Vec2 const& from, Vec2 const& to) {
    Sensor sensor;
    sensor.region = LineRegion{from, to};
    return sensor;
}

Sensor disc(Vec2 const& centre, double radius) {
    Sensor sensor;
    sensor.region = DiscRegion{centre, radius};
    return sensor;
}

Scene scene_of(std::vector<Piece> pieces, std::vector<Ball> balls, std::vector<Sensor> sensors, double gravity = g) {
    Scene scene;
    scene.terrain = terrain_of(std::move(pieces));
    scene.balls = std::move(balls);
    scene.sensors = std::move(sensors);
    scene.gravity = gravity;
    return scene;
}

struct SenseRun {
    World world;
    History history;
};

// In windows of `every` seconds, with a pull from 0.5 s to 1.7 s where there is a target.
SenseRun run_of(Method const& method, Scene const& scene, double until, double every,
                std::optional<Vec2> const& target = std::nullopt) {
    SenseRun run;
    run.world = world_at_start(method, scene, run.history);
    auto const go_on = [&](double to) {
        while (run.world.time < to)
            REQUIRE_FALSE(advance(method, scene, run.world, std::min(to, run.world.time + every), run.history));
    };
    if (target) {
        go_on(0.5);
        REQUIRE_FALSE(apply(method, scene, run.world, {0, Pull{0, *target}}, run.history));
        go_on(1.7);
        REQUIRE_FALSE(apply(method, scene, run.world, {}, run.history));
    }
    go_on(until);
    return run;
}

std::optional<double> time_of(SenseRun const& run, int sensor = 0) {
    for (Event const& event : run.history.events)
        if (event.kind == EventKind::sensor && event.other == sensor) return event.time;
    return std::nullopt;
}

// All events of the one at the times of the other, in the same order.
void require_same_events(SenseRun const& once, SenseRun const& often) {
    REQUIRE(often.history.events.size() == once.history.events.size());
    for (std::size_t i = 0; i < once.history.events.size(); ++i) {
        Event const &a = once.history.events[i], &b = often.history.events[i];
        REQUIRE(a.time == b.time);
        REQUIRE(a.kind == b.kind);
        REQUIRE(a.other == b.other);
    }
}

// How far outside its region a place is, m; of a line, the distance from it.
double gap_to(Sensor const& sensor, Vec2 const& place) {
    if (auto const* d = std::get_if<DiscRegion>(&sensor.region)) return geometry::length(place - d->centre) - d->radius;
    if (auto const* l = std::get_if<LineRegion>(&sensor.region))
        return geometry::nearest_point(geometry::Segment{l->from, l->to}, place).distance;
    auto const& corners = std::get<PolygonRegion>(sensor.region).corners;
    double widest = -never;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2 const way = corners[(i + 1) % corners.size()] - corners[i];
        widest = std::max(widest, geometry::cross(place - corners[i], way) / geometry::length(way));
    }
    return sensor.outside ? -widest : widest;
}

bool passes_through(LineRegion const& l, Vec2 const& before, Vec2 const& now) {
    Vec2 const way = l.to - l.from, step = now - before;
    double const denominator = geometry::cross(way, step);
    if (denominator == 0) return false;
    double const along = geometry::cross(before - l.from, step) / denominator;
    double const share = geometry::cross(before - l.from, way) / denominator;
    return along >= 0 && along <= 1 && share >= 0 && share <= 1;
}

std::vector<Sensor> random_sensors(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> x(-3, 3), y(-2, 2), size(0.05, 1);
    std::vector<Sensor> sensors;
    for (int i = 0; i < count; ++i) {
        Vec2 const place(x(random), y(random));
        Vec2 const extent(size(random), size(random));
        if (i % 3 == 0) sensors.push_back(disc(place, extent.x()));
        if (i % 3 == 1) sensors.push_back(fence_line(place, {x(random), y(random)}));
        if (i % 3 == 2) sensors.push_back(rectangle(place, place + extent));
    }
    sensors.push_back(rectangle({-2, -1.6}, {2, 1.5}));
    sensors.back().outside = true;
    return sensors;
}

// A ball in a bowl of radius 2 that is pulled out of it: pendulum, spring, flight, impacts.
Scene bowl_with(std::vector<Sensor> sensors, double friction) {
    geometry::Arc const bowl{{0, 0}, 2, pi, pi};
    return scene_of({{bowl, {friction, 0.5, 0}, 0}}, {ball_at({-1.4, 0.3})}, std::move(sensors));
}

}  // namespace

TEST_CASE("a ball that rolls below a goal's edge does not enter it, however near the edge is") {
    for (Method const& method : all_methods)
        for (double const below : {1e-2, 1e-4, 1e-9}) {
            Scene const scene = scene_of({floor_at(0)}, {ball_at({0, 0.5}, {5, 0}, -10)},
                                         {rectangle({3, 0.5 + below}, {45, 2}), rectangle({3, 0.5 - below}, {45, 2})});
            INFO(std::string(name_of(method)));
            SenseRun const run = run_of(method, scene, 10, 10);
            CHECK_FALSE(time_of(run, 0));
            // Entered from the side at 5 m/s; the article's rolling adds rounding alone.
            REQUIRE(time_of(run, 1));
            CHECK(std::abs(*time_of(run, 1) - 0.6) <= 1e-9);
        }
}

TEST_CASE("a line just under a ball let go is crossed within the first step") {
    for (Method const& method : all_methods) {
        Scene const scene = scene_of({}, {ball_at({4, 6})}, {fence_line({2, 6 - 5e-5}, {6, 6 - 5e-5})});
        auto const time = time_of(run_of(method, scene, 1, 1));
        INFO(std::string(name_of(method)));
        REQUIRE(time);
        CHECK(*time > 0);
        CHECK(*time <= 1.0 / 240);
        if (std::holds_alternative<Exact>(method)) CHECK(std::abs(*time - std::sqrt(2 * 5e-5 / g)) <= 1e-9);
    }
}

TEST_CASE("a line behind a bounce within a step is crossed on the way down") {
    double const impact = 100.5 / 240, above = 1e-3;  // s, in the middle of a step; m
    double const drop = g * impact * impact / 2;
    Scene const scene =
        scene_of({floor_at(0, 1)}, {ball_at({0, 0.5 + drop})}, {fence_line({-1, 0.5 + above}, {1, 0.5 + above})});
    double const crossing = std::sqrt(2 * (drop - above) / g);
    auto const exact = time_of(run_of(Exact{}, scene, 0.5, 1)), steps = time_of(run_of(Steps{}, scene, 0.5, 1));
    REQUIRE(exact);
    REQUIRE(steps);
    CHECK(std::abs(*exact - crossing) <= 1e-11);
    // The chord leaves the parabola by g h^2 / 8 = 2e-5 m, which takes 5e-6 s at 4.1 m/s.
    CHECK(std::abs(*steps - crossing) <= 1e-5);
}

TEST_CASE("at the start a ball in a region or on a line is noticed at 0, and outside of a fence too") {
    Sensor fence = rectangle({5, 5}, {6, 6});
    fence.outside = true;
    Scene const scene = scene_of({}, {ball_at({1, 1})},
                                 {disc({1.5, 1}, 1), rectangle({0, 0}, {1, 1}), fence_line({0, 1}, {2, 1}), fence}, 0);
    for (Method const& method : all_methods) {
        SenseRun const run = run_of(method, scene, 1, 1);
        for (int sensor = 0; sensor < 4; ++sensor) CHECK(time_of(run, sensor) == 0.0);
    }
}

TEST_CASE("a ball that runs round within a hair of a round region does not enter it") {
    // A pendulum's whole way of radius 1.5 about the region's centre.
    for (double const hair : {1e-4, 1e-9}) {
        Scene const scene = bowl_with({disc({0, 0}, 1.5 - hair), disc({0, -1.5 - 0.3 - hair}, 0.3)}, 0);
        Scene start = scene;
        start.balls[0].start.position = {-1.5 * std::sin(0.4), -1.5 * std::cos(0.4)};
        SenseRun const run = run_of(Exact{}, start, 10, 10);
        CHECK_FALSE(time_of(run, 0));
        CHECK_FALSE(time_of(run, 1));
    }
}

TEST_CASE("what a sensor notices is the first moment that its region holds the ball, on every kind of motion") {
    std::mt19937 random(3);
    double const until = 3, step = 1e-4;
    for (int round = 0; round < 8; ++round) {
        Scene const scene = bowl_with(random_sensors(random, 24), round % 2 == 0 ? 0.9 : 0);
        for (Method const& method : {Method(Exact{}), Method(Steps{})}) {
            SenseRun const run = run_of(method, scene, until, until, Vec2(0.8 + 0.2 * round, 1));
            for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
                Sensor const& sensor = scene.sensors[i];
                double const noticed = time_of(run, static_cast<int>(i)).value_or(never);
                CAPTURE(i);
                if (noticed > 0 && noticed < never) {
                    double const gap = gap_to(sensor, state_at(run.history, 0, noticed).position);
                    CHECK(std::abs(gap) <= 1e-10);  // at 20 m/s for a picosecond, and 1e-11 m
                }
                auto const* crossed = std::get_if<LineRegion>(&sensor.region);
                Vec2 before = state_at(run.history, 0, 0).position;
                for (double t = 0; t < std::min(noticed, until); t += step) {
                    Vec2 const now = state_at(run.history, 0, t).position;
                    REQUIRE((crossed ? !passes_through(*crossed, before, now) : gap_to(sensor, now) > 0));
                    before = now;
                }
            }
        }
    }
}

TEST_CASE("among hundreds of bounces in one window the same is noticed as when one asks at each") {
    std::mt19937 random(5);
    int noticed = 0;
    for (int round = 0; round < 20; ++round) {
        Ball ball = ball_at({-2.5, -0.5}, {1.5, 0});
        ball.radius = 0.1;
        Scene const scene = scene_of({floor_at(-1, 0.97)}, {ball}, random_sensors(random, 24), 1e4);
        SenseRun const once = run_of(Exact{}, scene, 4, 4), often = run_of(Exact{}, scene, 4, 1e-3);
        REQUIRE(once.history.events.size() > 100);
        require_same_events(once, often);
        noticed += static_cast<int>(std::count_if(once.history.events.begin(), once.history.events.end(),
                                                  [](Event const& e) { return e.kind == EventKind::sensor; }));
    }
    CHECK(noticed > 50);
}

TEST_CASE("the same is noticed at the same times in the same order however often one asks") {
    std::mt19937 random(4);
    for (int round = 0; round < 8; ++round) {
        Scene const scene = bowl_with(random_sensors(random, 24), 0.9);
        for (Method const& method : all_methods) {
            Vec2 const target(0.8 + 0.2 * round, 1);
            SenseRun const once = run_of(method, scene, 3, 3, target);
            for (double const every : {1.0 / 60, 0.25, 1e-3})
                require_same_events(once, run_of(method, scene, 3, every, target));
        }
    }
}
