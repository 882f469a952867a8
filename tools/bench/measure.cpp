// Prints what the methods cost: microseconds per simulated second for one ball, a prediction of 10 s among many
// surfaces, long times unsampled, milliseconds per 1/60 s for piles. With the name of a part only that part.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "geometry/elementary.h"
#include "physics/predict.h"

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

// The least time of a call, in seconds; short ones are repeated within a measurement.
template <typename Call>
double seconds_of(Call const& call, int calls) {
    double least = 1e9;
    for (int i = 0; i < repeats; ++i) {
        auto const before = std::chrono::steady_clock::now();
        for (int k = 0; k < calls; ++k) call();
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    }
    return least / calls;
}

double sampled_sum = 0;  // so that no sample is left out by the compiler

// A whole run from its start, asked for at 60 Hz.
void run_sampled(physics::Method const& method, Scene const& scene, physics::Forces const& forces, int seconds) {
    Started run = started(method, scene, 0);
    physics::apply(method, scene, run.world, forces, run.history);
    for (int frame = 1; frame <= seconds * 60; ++frame) {
        double const time = frame / 60.0;
        physics::advance(method, scene, run.world, time, run.history);
        sampled_sum += physics::state_at(run.history, 0, time).position.x();
        physics::forget_before(run.history, time);
    }
}

void print_single(char const* name, Scene const& scene, int seconds, physics::Forces const& forces = {}) {
    std::printf("%-36s", name);
    for (physics::Method const& method :
         {physics::Method(physics::Exact{}), physics::Method(physics::Steps{}), physics::Method(physics::Article{})})
        std::printf("  %s %6.2f", physics::name_of(method),
                    seconds_of([&] { run_sampled(method, scene, forces, seconds); }, 20) / seconds * 1e6);
    std::printf("\n");
}

void print_singles() {
    std::printf("microseconds per simulated second, one ball, sampled at 60 Hz\n");
    Vec2 const down_slope(0.5 * std::sin(pi / 9), 0.5 * std::cos(pi / 9));
    Scene const ramp = scene_of(
        {line({-900 * std::cos(pi / 9), 900 * std::sin(pi / 9)}, {900 * std::cos(pi / 9), -900 * std::sin(pi / 9)})},
        {ball_at(down_slope)});
    Scene const valley = scene_of({{geometry::Arc{{0, 3}, 3, -pi, pi}, {0.9, 0, 0}, 0}}, {ball_at({1.5, 1})});
    Scene const floor = scene_of({line({-900, 0}, {900, 0})}, {ball_at({0, 0.5})});
    Scene loose = floor;
    loose.drag.damping = 0.02;
    physics::Forces pulled;
    pulled.pull = physics::Pull{0, {3, 0.7}};
    print_single("flight", scene_of({}, {ball_at({0, 0})}), 10);
    print_single("ramp", ramp, 10);
    print_single("bouncing, e = 0.8, to rest", scene_of({line({-900, 0}, {900, 0}, 0.8)}, {ball_at({0, 2})}), 5);
    print_single("bouncing, e = 0.99", scene_of({line({-900, 0}, {900, 0}, 0.99)}, {ball_at({0, 2})}), 10);
    print_single("valley, a true arc", valley, 10);
    print_single("drag on the floor", floor, 10, pulled);
    print_single("drag on the floor, damping 0.02", loose, 10, pulled);
}

// Small hills with platforms above them.
Scene landscape_of(int surfaces) {
    std::vector<physics::Piece> pieces;
    auto const ground = [](int i) { return Vec2(2.0 * i, 0.3 * ((i * 7) % 5)); };
    for (int i = 0; i < surfaces / 2; ++i) pieces.push_back(line(ground(i), ground(i + 1), 0.4));
    for (int i = surfaces / 2; i < surfaces; ++i) {
        Vec2 const from(2.0 * (i - surfaces / 2), 4.0 + i % 3);
        pieces.push_back(line(from, from + Vec2(1.2, 0.2), 0.4));
    }
    Ball ball = ball_at({surfaces / 2.0, 2.5});
    ball.start.velocity = {4, 0};
    return scene_of(pieces, {ball});
}

void print_predictions() {
    physics::Method const method = physics::Exact{};
    for (int const surfaces : {100, 1000, 10000}) {
        Scene const scene = landscape_of(surfaces);
        Started const run = started(method, scene, 0);
        auto const ahead = [&] { return physics::predicted(method, scene, run.world, 10); };
        std::size_t const events = ahead().events.size();
        std::printf("prediction of 10 s among %5d surfaces: %7.1f us, %d events\n", surfaces,
                    seconds_of(ahead, 20) * 1e6, static_cast<int>(events));
    }
}

void print_unsampled() {
    physics::Method const method = physics::Exact{};
    Scene const scene = scene_of({line({-1000, 0}, {900000, 0})}, {[] {
                                     Ball ball = ball_at({0, 0.5});
                                     ball.start.velocity = {20, 0};
                                     return ball;
                                 }()});
    for (double const time : {1.0, 1000.0})
        std::printf("%4.0f simulated seconds of rolling, unsampled: %.2f us\n", time,
                    seconds_of([&] { sampled_sum += started(method, scene, time).world.time; }, 200) * 1e6);
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

int main(int count, char** arguments) {
    std::string const part = count > 1 ? arguments[1] : "all";
    if (part == "all" || part == "singles") print_singles();
    if (part == "all" || part == "predictions") print_predictions();
    if (part == "all" || part == "unsampled") print_unsampled();
    if (part != "all" && part != "piles") return 0;
    for (int const balls : {100, 1000})
        for (double const rate : {60.0, 240.0}) print_pile(balls, rate);
}
