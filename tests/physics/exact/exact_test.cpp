// Promises that only the exact method makes.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "physics/predict.h"
#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;

TEST_CASE("a turned and scaled copy moves the same") {
    // Lengths by s^2 at the same times scale with s if gravity does too; nothing but rounding differs: 1e-9.
    double const turn = 0.3, scale = 4;
    Run plain(Exact{}, course_at({0, 0}, 0.2, 4.2));
    auto const [s, c] = geometry::sine_cosine(turn);
    Run copy = exact_run(course({7, 3}, 0.2, turn, scale),
                         {disc(0.5 * scale, Vec2(7, 3) + scale * geometry::turned(Vec2(-2, 4.2), c, s))}, g * scale);
    copy.tilt(turn);
    for (int i = 1; i <= 50; ++i) {
        plain.to(0.1 * i);
        copy.to(0.1 * i);
        Vec2 const expected = Vec2(7, 3) + scale * geometry::turned(plain.state().position, c, s);
        CHECK(geometry::length(copy.state().position - expected) <= 1e-9);
        CHECK(std::abs(copy.state().angle - plain.state().angle) <= 1e-9);
    }
}

TEST_CASE("elastic bounces among fixed discs: no overlap, no drift of energy") {
    Material const elastic{0, 1, 0};
    std::vector<Piece> pieces = ring({{0, 0}, {8, 0}, {8, 6}, {0, 6}}, elastic);
    for (int i = 0; i < 8; ++i)
        pieces.push_back(arc({1.5 + 1.7 * (i % 4), 2.0 + 2.1 * (i / 4)}, 0.3 + 0.04 * i, 0, 2 * pi, elastic));
    Run run = exact_run(pieces, {disc(0.2, {0.6, 0.7}, {3.1, 2.3}, 1)}, 0);
    double const before = energy_of(run);
    long long const wanted = sanitized ? 20'000 : 2'000'000;
    long long bounces = 0;
    double deepest = 0;
    for (double t = 100; bounces < wanted; t += 100) {
        run.to(t);
        for (Event const& event : run.history.events) {
            REQUIRE(event.kind == EventKind::bounce);
            ++bounces;
            for (Piece const& piece : run.scene.terrain.pieces)
                deepest = std::max(deepest, 0.2 - geometry::nearest_point(piece.curve, event.state.position).distance);
        }
        forget_before(run.history, t);
        run.history.events.clear();
    }
    CHECK(deepest <= 1e-11);
    CHECK(std::abs(energy_of(run) / before - 1) <= 1e-9);
}

TEST_CASE("balls that come to rest on each other are handed over, and taken back when apart") {
    // Three lie in a pyramid and roll apart, each on its way.
    std::vector<Ball> balls{disc(0.3, {-0.3, 0.3}), disc(0.3, {0.3, 0.3}), disc(0.3, {0, 0.3 + 0.3 * std::sqrt(3.0)})};
    for (Ball& ball : balls) ball.friction = 0;
    Run run = exact_run({line({-50, 0}, {50, 0})}, balls);
    double const before = energy_of(run);
    run.to(10);
    CHECK(run.count(EventKind::handover) >= 1);
    CHECK(run.count(EventKind::takeover) >= 1);
    CHECK(energy_of(run) <= before);
    for (int i = 0; i < 3; ++i) CHECK(run.state(i).position.y() > 0.29);
}

TEST_CASE("what is predicted comes true to the bit") {
    Run run = exact_run(course({0, 0}, 0.4), {disc(0.3, {-2, 5}, {1, 0})});
    run.to(0.7);
    History const ahead = predicted(Exact{}, run.scene, run.world, 6);
    for (double const t : {1.0, 2.5, 4.0, 6.5}) {
        run.to(t);
        CHECK(same_bits(state_at(ahead, 0, t), run.state()));
    }
}

TEST_CASE("the state at an earlier time is read from the history") {
    Run run = exact_run(course({0, 0}, 0.4), {disc(0.3, {-2, 5}, {1, 0})});
    std::vector<State> seen;
    for (int i = 1; i <= 40; ++i) {
        run.to(0.2 * i);
        seen.push_back(run.state());
    }
    for (int i = 1; i <= 40; ++i)
        CHECK(geometry::length(state_at(run.history, 0, 0.2 * i).position - seen[i - 1].position) <= 1e-12);
}
