// T12: what rests stays; and grooves.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

physics::Scene groove_with(physics::Ball const& ball, physics::Material const& of) {
    return scene_of(chain({{-2, 2}, {0, 0}, {2, 2}}, of), {ball});
}

// After some seconds to come to rest, ten minutes in which it must not stir: |v|, and 1e-3 r of drift at 1e-4 m/s.
void stays_ten_minutes(Bound const& bound, physics::Scene const& scene, double settling = 5) {
    CAPTURE(std::string(physics::name_of(bound.method)));
    Run run(bound.method, scene);
    run.to(settling);
    physics::State const before = run.state();
    double fastest = 0;
    for (int i = 1; i <= 1200; ++i) {
        run.to(settling + 0.5 * i);
        fastest = std::max(fastest, length(run.state().velocity));
        forget_before(run.history, run.world.time);
    }
    CHECK(fastest <= bound.tolerance);
    CHECK(length(run.state().position - before.position) <= 5 * bound.tolerance);
    CHECK((bound.tolerance > 0 || same_bits(run.state(), before)));
    CHECK(run.leg().phase == physics::Phase::rest);
}

}  // namespace

TEST_CASE("T12: a ball that rests on a floor or in a groove stays for ten minutes") {
    for (Bound const& bound : bounds_of(law::rest)) {
        stays_ten_minutes(bound, floor_with(disc_at({0, 0.52}), material(0.9)));
        stays_ten_minutes(bound, floor_with(disc_at({0, 0.5}), material(0.9, 0.8, 0.05)));
        // Dropped beside the middle, it rolls into it.
        stays_ten_minutes(bound, groove_with(disc_at({0.1, 1}), material(0.9)));
        stays_ten_minutes(bound, groove_with(disc_at({0, std::sqrt(0.5) + 0.01}), material(0.9, 0, 0.05)));
        // Dropped on the middle, and laid there.
        stays_ten_minutes(bound, groove_with(disc_at({0, std::sqrt(0.5) + 0.01}), material(0.9)));
        stays_ten_minutes(bound, groove_with(disc_at({0, 0.5 * std::sqrt(2.0)}), {}), 0);
    }
}

TEST_CASE("T12: in a groove with unlike sides a ball comes to rest, whatever the friction") {
    struct Sides {
        double left, right;  // slopes
    };
    for (Bound const& bound : bounds_of(law::rest)) {
        if (std::holds_alternative<physics::Article>(bound.method))
            continue;  // it knows no friction to end its rocking
        for (Sides const sides : {Sides{0.5, 1.5}, Sides{0.2, 2}})
            for (double const friction : {0.9, 0.3, 0.1}) {
                CAPTURE(sides.left);
                CAPTURE(friction);
                // At distance r from both lines through the origin, and dropped from a centimetre above.
                double const a = std::sqrt(1 + sides.left * sides.left), b = std::sqrt(1 + sides.right * sides.right);
                double const x = 0.5 * (a - b) / (sides.left + sides.right);
                Vec2 const place(x, 0.5 * a - sides.left * x);
                stays_ten_minutes(bound, scene_of({line({-4, 4 * sides.left}, {0, 0}, material(friction)),
                                                   line({0, 0}, {4, 4 * sides.right}, material(friction))},
                                                  {disc_at(place + Vec2(0, 0.01))}));
            }
    }
}

TEST_CASE("T12: on a slope that rolling resistance holds a ball on it stays for ten minutes") {
    for (Bound const& bound : bounds_of(law::rest)) {
        if (std::holds_alternative<physics::Article>(bound.method)) continue;  // pinned below
        stays_ten_minutes(bound, slope_with(0.04, disc_at(Vec2::Zero()), material(0.9, 0, 0.05)).scene);
    }
}

TEST_CASE("T12 pinned: article knows of no rolling resistance: on a slope nothing holds") {
    double const angle = 0.04;
    Slope const slope = slope_with(angle, disc_at(Vec2::Zero()), material(0.9, 0, 0.05));
    physics::State const state = state_after(physics::Article{}, slope.scene, 5);
    CHECK(geometry::dot(state.velocity, slope.down) == doctest::Approx(g * std::sin(angle) * 5).epsilon(1e-12));
}

TEST_CASE("a spinning ball locks at once in a corner whose slope, 1 in 3, turns its friction, 3, against the wall") {
    for (double const spin : {4.0, -4.0}) {
        Run run = exact_run({line({0, 2}, {6, 0}, material(3)), line({6, 0}, {6, 9}, material(0))},
                            {disc_at({5.5, 4}, {0, 0}, spin)});
        run.to(10);
        // One way round it rubs until it stands, the other way the forces grow without bound.
        CHECK(run.state().spin == 0);
        CHECK(run.leg().phase == physics::Phase::rest);
        CHECK(run.state().position.x() == doctest::Approx(5.5).epsilon(1e-9));
        CHECK(run.state().position.y() == doctest::Approx((0.5 + 0.5 * std::sqrt(10)) / 3).epsilon(1e-9));
    }
}

TEST_CASE("spin in a symmetric groove falls at mu g / (k (1 + mu^2) cos)") {
    double const mu = 0.5;
    for (Bound const& bound : bounds_of(law::groove)) {
        Run run(bound.method, groove_with(disc_at({0, std::sqrt(0.5)}, {0, 0}, 20), material(mu)));
        run.to(0.3);
        double const fall = mu * g / (0.5 * (1 + mu * mu) * std::sqrt(0.5));
        CHECK(0.5 * run.state().spin == doctest::Approx(10 - fall * 0.3).epsilon(bound.tolerance));
    }
}
