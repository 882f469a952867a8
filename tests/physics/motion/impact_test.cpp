// Impacts against mechanics: what an impulse at the rim may and may not do.
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "physics/exact/time_of_impact.h"
#include "physics/motion/impact.h"

using namespace physics;

TEST_CASE(
    "an impact turns the normal speed, keeps v + k s, and takes from slip and energy without reversing the slip") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> speed(-5, 5), share(0, 1);
    for (int i = 0; i < 100'000; ++i) {
        ContactSpeeds const before{-5 * share(random), speed(random), speed(random)};
        double const e = share(random), mu = 2 * share(random), k = 0.01 + share(random);
        ContactSpeeds const after = after_impact(before, e, mu, k);
        auto const energy = [k](ContactSpeeds const& s) {
            return 0.5 * (s.normal * s.normal + s.tangent * s.tangent + k * s.rim * s.rim);
        };
        REQUIRE(after.normal == -e * before.normal);
        // The impulse acts at the rim: what the centre gains the rim loses k-fold. Sums of numbers below 10: 1e-14.
        REQUIRE(std::abs(after.tangent + k * after.rim - before.tangent - k * before.rim) <= 1e-14 * 10);
        REQUIRE(std::abs(after.slip()) <= std::abs(before.slip()));
        REQUIRE(after.slip() * before.slip() >= 0);
        REQUIRE(energy(after) <= energy(before) * (1 + 1e-14));
        double const impulse = std::abs(after.tangent - before.tangent);
        REQUIRE(impulse <= mu * (1 + e) * std::abs(before.normal) * (1 + 1e-12) + 1e-15);
    }
}

TEST_CASE("a skidding ball that bounces is braked by mu times the normal impulse") {
    // A disc at 4 m/s, not spinning, that falls at 1 m/s on mu = 0.2, e = 0.5: J = 0.2 * 1.5 * 1.
    ContactSpeeds const after = after_impact({-1, 4, 0}, 0.5, 0.2, 0.5);
    CHECK(after.tangent == doctest::Approx(3.7).epsilon(1e-15));
    CHECK(after.rim == doctest::Approx(0.6).epsilon(1e-15));
}

TEST_CASE("without normal impulse there is no friction, however great") {
    CHECK(within_grip(1, INFINITY, 0) == 0);
    CHECK(within_grip(-1, 1e200, 0) == 0);
    CHECK(within_grip(-3, INFINITY, 1) == -3);
    CHECK(after_impact({0, 4, 0}, 0.5, INFINITY, 0.5).tangent == 4);
    Ball a, b;
    a.friction = b.friction = 1e200;
    State const spinning{{0, 0}, {0, 0}, 0, 3}, still{{1, 0}, {0, 0}, 0, 0};
    CHECK(friction_between(a, b) == 1e200);
    CHECK(pair_friction_impulse(a, spinning, b, still, {1, 0}, 0, 0) == 0);
    b.friction = 1e-200;
    CHECK(friction_between(a, b) == doctest::Approx(1));
    // Three in a row, of which the first two move together: that pair strikes without an impulse.
    std::vector<Ball> const row(3, a);
    std::vector<State> states{{{0, 0}, {1, 0}, 0, 2}, {{1, 0}, {1, 0}, 0, 2}, {{2, 0}, {1, 0}, 0, 0}};
    solve_simultaneous_impacts(row, {{0, 1}, {1, 2}}, states);
    for (State const& state : states) {
        CHECK(geometry::is_finite(state.velocity));
        CHECK(std::isfinite(state.spin));
    }
}
