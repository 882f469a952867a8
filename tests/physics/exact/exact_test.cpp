// Promises that only the exact method makes.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "physics/exact/exact_run.h"
#include "geometry/elementary.h"
#include "physics/exact/exact.h"
#include "physics/predict.h"

namespace {

using namespace context;
using geometry::Arc;
using geometry::pi;
using geometry::Segment;

#ifdef SMB2D_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

bool same_bits(State const& a, State const& b) {
    double const p[] = {a.position.x(), a.position.y(), a.velocity.x(), a.velocity.y(), a.angle, a.spin};
    double const q[] = {b.position.x(), b.position.y(), b.velocity.x(), b.velocity.y(), b.angle, b.spin};
    return std::memcmp(p, q, sizeof p) == 0;
}

// A course with a slope, an arc, a flat stretch, a step and a wall, and a ball that rolls, slips, flies and bounces.
std::vector<Piece> course(double turn, Vec2 const& shift, double scale, double restitution) {
    auto const [s, c] = geometry::sine_cosine(turn);
    auto const put = [&, c = c, s = s](double x, double y) -> Vec2 {
        return shift + scale * geometry::turned(Vec2(x, y), c, s);
    };
    auto const segment = [&](double x1, double y1, double x2, double y2) {
        return Piece{Segment{put(x1, y1), put(x2, y2)}, {0.3, restitution, 0.01}, 0};
    };
    return {segment(-4, 4, 0, 1),
            segment(0, 1, 3, 1),
            Piece{Arc{put(3, 3), 2 * scale, turn - pi / 2, pi / 3}, {0.3, restitution, 0.01}, 0},
            segment(6, 0, 12, 0),
            segment(12, 0, 12, 6),
            segment(-4, 4, -4, 8)};
}

}  // namespace

TEST_CASE("asking more often does not change a bit") {
    auto const run = [](double every_inverse, double until) {
        StepContext context(course(0, Vec2::Zero(), 1, 0.4), {disc(0.3, {-2, 5}, {1, 0})});
        for (int i = 1; i <= until * every_inverse; ++i) {
            context.to(i / every_inverse);
            if (i == every_inverse) context.pull(Pull{0, {1, 4}});
            if (i == 2 * every_inverse) context.pull(std::nullopt);
        }
        return context.now();
    };
    State const coarse = run(1, 9);
    CHECK(same_bits(coarse, run(24, 9)));
    CHECK(same_bits(coarse, run(1000, 9)));
}

TEST_CASE("T15: a scene far from the origin takes the same path") {
    // Doubles at 1e5 m are 1.5e-11 m apart; bounces and slip multiply that a little: 1e-9 r (T15 in tests/laws).
    Vec2 const away(1e5, -1e5);
    StepContext here(course(0, Vec2::Zero(), 1, 0), {disc(0.5, {-2, 4.2})});
    StepContext there(course(0, away, 1, 0), {disc(0.5, Vec2(-2, 4.2) + away)});
    for (int i = 1; i <= 100; ++i) {
        here.to(0.05 * i);
        there.to(0.05 * i);
        CHECK(geometry::length(there.now().position - away - here.now().position) <= 1e-9);
    }
}

TEST_CASE("a turned and scaled copy moves the same") {
    // Lengths by s^2 at the same times scale with s if gravity does too; nothing but rounding differs: 1e-9.
    double const turn = 0.3, scale = 4;
    StepContext plain(course(0, Vec2::Zero(), 1, 0.2), {disc(0.5, {-2, 4.2})});
    auto const [s, c] = geometry::sine_cosine(turn);
    StepContext copy(course(turn, Vec2(7, 3), scale, 0.2),
                     {disc(0.5 * scale, Vec2(7, 3) + scale * geometry::turned(Vec2(-2, 4.2), c, s))}, 9.81 * scale);
    Forces tilted;
    tilted.tilt = turn;
    REQUIRE_FALSE(apply(Exact{}, copy.scene, copy.world, tilted, copy.history));
    for (int i = 1; i <= 50; ++i) {
        plain.to(0.1 * i);
        copy.to(0.1 * i);
        Vec2 const expected = Vec2(7, 3) + scale * geometry::turned(plain.now().position, c, s);
        CHECK(geometry::length(copy.now().position - expected) <= 1e-9);
        CHECK(std::abs(copy.now().angle - plain.now().angle) <= 1e-9);
    }
}

TEST_CASE("elastic bounces among fixed discs: no overlap, no drift of energy") {
    Material const elastic{0, 1, 0};
    std::vector<Piece> pieces{line({0, 0}, {8, 0}, elastic), line({8, 0}, {8, 6}, elastic),
                              line({8, 6}, {0, 6}, elastic), line({0, 6}, {0, 0}, elastic)};
    for (int i = 0; i < 8; ++i)
        pieces.push_back({Arc{{1.5 + 1.7 * (i % 4), 2.0 + 2.1 * (i / 4)}, 0.3 + 0.04 * i, 0, 2 * pi}, elastic, 0});
    StepContext context(pieces, {disc(0.2, {0.6, 0.7}, {3.1, 2.3}, 1)}, 0);
    double const before = energy_of(context.scene.balls[0], context.now(), 0);
    long long const wanted = sanitized ? 20'000 : 2'000'000;
    long long bounces = 0;
    double deepest = 0;
    for (double t = 100; bounces < wanted; t += 100) {
        context.to(t);
        for (Event const& event : context.history.events) {
            REQUIRE(event.kind == EventKind::bounce);
            ++bounces;
            for (Piece const& piece : context.scene.terrain.pieces)
                deepest = std::max(deepest, 0.2 - geometry::nearest_point(piece.curve, event.state.position).distance);
        }
        forget_before(context.history, t);
        context.history.events.clear();
    }
    CHECK(deepest <= 1e-11);
    CHECK(std::abs(energy_of(context.scene.balls[0], context.now(), 0) / before - 1) <= 1e-9);
}

TEST_CASE("T11: bounces that never end come to rest at their limit") {
    // Total time sqrt(2h/g)(1+e)/(1-e) (physics.md 6.1).
    for (double const e : {0.35, 0.8, 0.99}) {
        CAPTURE(e);
        double const height = 1.3;
        StepContext context({line({-5, 0}, {5, 0}, {0.7, e, 0})}, {disc(0.5, {0, 0.5 + height})});
        double const rest = std::sqrt(2 * height / 9.81) * (1 + e) / (1 - e);
        context.to(rest + 1);
        CHECK(context.history.events.back().kind == EventKind::rest);
        CHECK(std::abs(context.history.events.back().time - rest) <= 1e-9);
        CHECK(context.history.events.size() <= 5000);
        CHECK(context.now().velocity == Vec2::Zero());
    }
}

TEST_CASE("T12: ten minutes at rest leave every bit where it was") {
    std::vector<Piece> const groove{line({-3, 3}, {0, 0}), line({0, 0}, {3, 3})};
    StepContext context(groove, {disc(0.5, {0, 0.5 * std::sqrt(2.0)})});
    State const before = context.now();
    context.to(600);
    CHECK(same_bits(before, context.now()));
    CHECK(context.world.legs[0].phase == Phase::rest);
}

TEST_CASE("T19: five touching balls pass the blow to the last, in either order of creation") {
    for (bool const reversed : {false, true}) {
        std::vector<Ball> balls{disc(0.5, {-3, 0.5}, {2, 0})};
        for (int i = 0; i < 5; ++i) balls.push_back(disc(0.5, {1.0 * i, 0.5}));
        for (Ball& ball : balls) {
            ball.restitution = 1;
            ball.friction = 0;
        }
        if (reversed) std::reverse(balls.begin(), balls.end());
        StepContext context({line({-50, 0}, {50, 0}, {0, 0, 0})}, balls);
        context.to(2);
        for (int i = 0; i < 6; ++i) {
            double const expected = i == (reversed ? 0 : 5) ? 2 : 0;
            CHECK(std::abs(context.now(i).velocity.x() - expected) <= 1e-12);
        }
        CHECK(context.count(EventKind::handover) == 0);
    }
}

TEST_CASE("T19: a ball that strikes two at once throws them apart symmetrically") {
    // Elastic, no friction: the two leave along the lines of centres with J = 2 v cos / (1 + 2 cos^2), from momentum
    // and energy.
    Ball striker = disc(0.5, {-2, 0}, {3, 0});
    Ball upper = disc(0.5, {1, 0.5}), lower = disc(0.5, {1, -0.5});
    std::vector<Ball> balls{striker, upper, lower};
    for (Ball& ball : balls) {
        ball.restitution = 1;
        ball.friction = 0;
    }
    StepContext context({}, balls, 0);
    context.to(2);
    double const cosine = std::sqrt(0.75);
    double const speed = 2 * 3 * cosine / (1 + 2 * cosine * cosine);
    CHECK(context.now(1).velocity.x() == doctest::Approx(speed * cosine).epsilon(1e-12));
    CHECK(context.now(2).velocity.x() == doctest::Approx(speed * cosine).epsilon(1e-12));
    CHECK(std::abs(context.now(1).velocity.y() + context.now(2).velocity.y()) <= 1e-12);
    CHECK(context.now(0).velocity.x() == doctest::Approx(3 - 2 * speed * cosine).epsilon(1e-11));
}

TEST_CASE("balls that come to rest on each other are handed over, and taken back when apart") {
    // Three lie in a pyramid and roll apart, each on its way.
    std::vector<Ball> balls{disc(0.3, {-0.3, 0.3}), disc(0.3, {0.3, 0.3}), disc(0.3, {0, 0.3 + 0.3 * std::sqrt(3.0)})};
    for (Ball& ball : balls) ball.friction = 0;
    StepContext context({line({-50, 0}, {50, 0})}, balls);
    int const count = static_cast<int>(balls.size());
    double before = 0, after = 0;
    for (int i = 0; i < count; ++i) before += energy_of(balls[i], context.now(i), 9.81);
    context.to(10);
    for (int i = 0; i < count; ++i) after += energy_of(balls[i], context.now(i), 9.81);
    CHECK(context.count(EventKind::handover) >= 1);
    CHECK(context.count(EventKind::takeover) >= 1);
    CHECK(after <= before);
    for (int i = 0; i < count; ++i) CHECK(context.now(i).position.y() > 0.29);
}

TEST_CASE("what is predicted comes true to the bit") {
    StepContext context(course(0, Vec2::Zero(), 1, 0.4), {disc(0.3, {-2, 5}, {1, 0})});
    context.to(0.7);
    History const ahead = predicted(Exact{}, context.scene, context.world, 6);
    for (double const t : {1.0, 2.5, 4.0, 6.5}) {
        context.to(t);
        CHECK(same_bits(state_at(ahead, 0, t), context.now()));
    }
}

TEST_CASE("the state at an earlier time is read from the history") {
    StepContext context(course(0, Vec2::Zero(), 1, 0.4), {disc(0.3, {-2, 5}, {1, 0})});
    std::vector<State> seen;
    for (int i = 1; i <= 40; ++i) {
        context.to(0.2 * i);
        seen.push_back(context.now());
    }
    for (int i = 1; i <= 40; ++i)
        CHECK(geometry::length(state_at(context.history, 0, 0.2 * i).position - seen[i - 1].position) <= 1e-12);
}

TEST_CASE("T6: nothing passes a line however fast it comes") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-1.5, 1.5), exponent(0, 5);
    for (int i = 0; i < (sanitized ? 2'000 : 100'000); ++i) {
        double const a = angle(random), speed = std::pow(10, exponent(random));
        StepContext context({line({0, -1e6}, {0, 1e6}, {0.5, 0.3, 0})},
                            {disc(0.5, {-1, 0}, {speed * std::cos(a), speed * std::sin(a)})}, 0);
        context.to(1);
        REQUIRE(context.now().position.x() <= -0.5 + 1e-9);
    }
}

TEST_CASE("T16: numbers that are not finite are refused and change nothing") {
    StepContext context({line({-5, 0}, {5, 0})}, {disc(0.5, {0, 2})});
    context.to(0.1);
    State const before = context.now();
    double const nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(advance(Exact{}, context.scene, context.world, nan, context.history));
    CHECK(advance(Exact{}, context.scene, context.world, full_grip, context.history));
    CHECK_FALSE(advance(Exact{}, context.scene, context.world, 0.1, context.history));
    CHECK_FALSE(advance(Exact{}, context.scene, context.world, -5, context.history));
    Forces broken;
    broken.tilt = nan;
    CHECK(apply(Exact{}, context.scene, context.world, broken, context.history));
    broken.tilt = 0;
    broken.pull = Pull{0, {nan, 0}};
    CHECK(apply(Exact{}, context.scene, context.world, broken, context.history));
    broken.pull = Pull{7, {0, 0}};
    CHECK(apply(Exact{}, context.scene, context.world, broken, context.history));
    CHECK(same_bits(before, context.now()));
}

TEST_CASE("T16: starts and targets of any size end, and stay finite") {
    for (double const size : {1e-300, 1e-9, 1.0, 1e6, 1e300}) {
        CAPTURE(size);
        StepContext context({line({-5, 0}, {5, 0}), line({5, 0}, {5, 5}), line({-5, 0}, {-5, 5})},
                            {disc(0.5, {0, 0.5})});
        context.pull(Pull{0, {size, size}});
        context.to(2);
        context.pull(std::nullopt);
        context.to(10);
        CHECK(geometry::is_finite(context.now().position));
        CHECK(context.now().position.y() >= 0.5 - 1e-9);
    }
}
