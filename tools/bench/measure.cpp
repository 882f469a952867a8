// Prints what the stepping methods cost: microseconds per simulated second for one ball, milliseconds per 1/60 s for
// piles.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "geometry/elementary.h"
#include "physics/method.h"

namespace {

using geometry::pi;
using geometry::Vec2;
using physics::Ball;
using physics::Scene;

constexpr int repeats = 7;  // the least of which counts: noise only ever adds

physics::Piece line(Vec2 const& from, Vec2 const& to, double restitution = 0) {
    return {geometry::Segment{from, to}, {0.9, restitution, 0}, 0};
}

Ball ball_at(Vec2 const& position) {
    Ball ball;
    ball.start.position = position;
    return ball;
}

Scene scene_of(std::vector<physics::Piece> pieces, std::vector<Ball> balls) {
    Scene scene;
    scene.terrain = physics::terrain_of(std::move(pieces));
    scene.balls = std::move(balls);
    return scene;
}

struct Started {
    physics::World world;
    physics::History history;
};

Started started(physics::Method const& method, Scene const& scene, double time) {
    Started run;
    run.world = physics::world_at_start(method, scene, run.history);
    physics::advance(method, scene, run.world, time, run.history);
    physics::forget_before(run.history, time);
    return run;
}

// Seconds of this machine for `frames` frames of 1/60 s from there on, asked for frame by frame as the window does.
double seconds_for(physics::Method const& method, Scene const& scene, Started const& from, int frames) {
    double least = 1e9;
    for (int i = 0; i < repeats; ++i) {
        Started run = from;
        double const start = run.world.time;
        auto const before = std::chrono::steady_clock::now();
        for (int frame = 1; frame <= frames; ++frame) {
            physics::advance(method, scene, run.world, start + frame / 60.0, run.history);
            physics::forget_before(run.history, run.world.time);
        }
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    }
    return least;
}

void print_single(char const* name, Scene const& scene) {
    for (physics::Method const& method : {physics::Method(physics::Steps{}), physics::Method(physics::Article{})})
        std::printf("%-28s %-8s %8.1f us per simulated second\n", name, physics::name_of(method),
                    seconds_for(method, scene, started(method, scene, 0.5), 120) / 2 * 1e6);
}

Scene pile_of(int count) {
    int const columns = static_cast<int>(std::sqrt(count * 2.0));
    double const width = 1.05 * columns + 1;
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i)
        balls.push_back(ball_at({1 + 1.05 * (i % columns) + 0.02 * ((i / columns) % 3), 0.6 + 1.02 * (i / columns)}));
    return scene_of({line({0, 0}, {width, 0}), line({0, 0}, {0, 200}), line({width, 0}, {width, 200})}, balls);
}

double deepest_overlap(Scene const& scene, physics::World const& world) {
    double deepest = 0;
    for (std::size_t i = 0; i < scene.balls.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            Vec2 const d = at(world.legs[i], world.time).position - at(world.legs[j], world.time).position;
            deepest = std::max(deepest, scene.balls[i].radius + scene.balls[j].radius - geometry::length(d));
        }
    return deepest;
}

void print_pile(int count, double rate) {
    Scene const scene = pile_of(count);
    physics::Method const method = physics::Steps{rate, 4};
    Started run = started(method, scene, 20);
    double const overlap = deepest_overlap(scene, run.world) / 0.5;
    auto const still =
        std::count_if(run.world.still_steps.begin(), run.world.still_steps.end(), [](int n) { return n > 0; });
    double const settled = seconds_for(method, scene, run, 60) / 60 * 1e3;
    run.world.still_steps.assign(run.world.still_steps.size(), -1000000);
    double const awake = seconds_for(method, scene, run, 20) / 20 * 1e3;
    std::printf("pile of %4d at %3.0f Hz: settled %.3f ms per 1/60 s, kept awake %.3f, overlap %.4f r, %d still\n",
                count, rate, settled, awake, overlap, static_cast<int>(still));
}

}  // namespace

int main() {
    Scene rolling = scene_of({line({-900, 300}, {900, -300})}, {ball_at({0, 0.6})});
    Scene bouncing = scene_of({line({-900, 0}, {900, 0}, 0.99)}, {ball_at({0, 2})});
    Scene valley = scene_of({{geometry::Arc{{0, 3}, 3, -pi, pi}, {0.9, 0, 0}, 0}}, {ball_at({1.5, 1})});
    Scene flying = scene_of({}, {ball_at({0, 0})});
    print_single("one ball, flight", flying);
    print_single("one ball, slope", rolling);
    print_single("one ball, bouncing", bouncing);
    print_single("one ball, valley", valley);
    for (int const count : {100, 1000})
        for (double const rate : {60.0, 240.0}) print_pile(count, rate);
}
