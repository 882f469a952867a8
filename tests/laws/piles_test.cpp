// T13 and T14: columns, and heavy on light. The exact method hands piles over to steps, so both are bound.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

physics::Scene column(std::vector<double> const& masses) {
    std::vector<physics::Ball> balls;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        balls.push_back(disc_at({0, 0.5 + static_cast<double>(i)}));
        balls.back().mass = masses[i];
    }
    return scene_of({line({-50, 0}, {50, 0}, material(0.9))}, balls);
}

// The overlap with which a soft contact carries a weight, m (physics.md 9.2): weight / (m_eff (2 pi f)^2), where f is
// an eighth of the 960 substeps a second.
double overlap_under(double mass_above, double lower, double upper) {
    double const omega = 2 * pi * 120, effective = 1 / (1 / lower + 1 / upper);
    return mass_above * g / (effective * omega * omega);
}

// Takes the last ball out of the world.
void remove_last(Run& run) {
    int const last = static_cast<int>(run.scene.balls.size()) - 1;
    run.scene.balls.pop_back();
    run.world.legs.pop_back();
    run.history.legs.pop_back();
    if (!run.world.plans.empty()) run.world.plans.pop_back();
    run.world.still_steps.clear();
    std::erase_if(run.world.cached_contacts, [&](physics::CachedContact const& t) { return t.ball == last; });
    std::erase_if(run.world.ball_pairs, [&](physics::BallPair const& n) { return n.second == last; });
    run.world.fat_boxes.clear();
}

// At rest, and pressed together as soft contacts say; by no more than so much of 2r.
void check_column(std::vector<double> const& masses, double most) {
    double const above = std::accumulate(masses.begin() + 1, masses.end(), 0.0);
    for (Bound const& bound : bounds_of(law::piles)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        CAPTURE(masses.size());
        CAPTURE(masses.back());
        Run run(bound.method, column(masses));
        run.to(4);
        CHECK(deepest_overlap(run) <= most);
        CHECK(deepest_overlap(run) ==
              doctest::Approx(overlap_under(above, masses[0], masses[1])).epsilon(bound.tolerance));
        CHECK(fastest(run) <= 1e-3);
    }
}

}  // namespace

TEST_CASE("T13: columns of 10, 20 and 50 discs stand, a little pressed together") {
    check_column(std::vector<double>(10, 1), 0.006);
    check_column(std::vector<double>(20, 1), 0.012);
    check_column(std::vector<double>(50, 1), 0.03);
}

TEST_CASE("T14: a heavy disc on a light one does not press through") {
    check_column({1, 100}, 0.03);
    check_column({1, 400}, 0.12);
}

TEST_CASE("T14: columns of light discs carry a heavy one, each contact by its own law") {
    for (Bound const& bound : bounds_of(law::piles))
        for (int const light : {3, 5, 10})
            for (double const heavy : {100.0, 400.0}) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(light);
                CAPTURE(heavy);
                std::vector<double> masses(static_cast<std::size_t>(light), 1.0);
                masses.push_back(heavy);
                Run run(bound.method, column(masses));
                run.to(8);
                // The ground is twice as firm in frequency, and does not yield: its effective mass is the disc's.
                double sunk = overlap_under(heavy + light, 1, INFINITY) / 4 + overlap_under(heavy, 1, heavy);
                for (int i = 1; i < light; ++i) sunk += overlap_under(heavy + light - i, 1, 1);
                CHECK(0.5 + light - run.state(light).position.y() == doctest::Approx(sunk).epsilon(bound.tolerance));
                CHECK(fastest(run) <= 1e-3);
            }
}

TEST_CASE("T14: light discs whose load is taken away do not jump") {
    for (Bound const& bound : bounds_of(law::piles))
        for (std::vector<double> const& masses : {std::vector<double>{1, 100}, {1, 400}, {1, 1, 100}}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            CAPTURE(masses.size());
            Run run(bound.method, column(masses));
            run.to(2);
            remove_last(run);
            int const top = static_cast<int>(masses.size()) - 2;
            double highest = 0;
            for (int i = 1; i <= 240; ++i) {
                run.to(2 + i / 240.0);
                highest = std::max(highest, run.state(top).position.y());
            }
            CHECK(highest <= 0.5 + top + 0.02 * 0.5);
            CHECK(run.state(top).position.y() >= 0.5 + top - 0.01);
        }
}

TEST_CASE("T14: a light disc from which a load is pulled does not jump, at any ratio of masses") {
    for (Bound const& bound : bounds_of(law::piles))
        for (double const ratio : {1e2, 1e3, 1e4, 1e5, 1e6}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            CAPTURE(ratio);
            Run run(bound.method, column({1, ratio}));
            run.to(2);
            run.pull(1, {0, 6});
            for (int i = 0; i < 60; ++i) {
                run.to(2 + i / 60.0);
                REQUIRE(run.state(0).position.y() <= 0.5 + 0.02 * 0.5);
            }
        }
}

TEST_CASE("T13 and T14 pinned: article's balls do not meet: all of a column lie on the floor") {
    Run run(physics::Article{}, column({1, 1, 100}));
    run.to(4);
    for (int i = 0; i < 3; ++i) CHECK(run.state(i).position.y() == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a heap of thirty comes to rest inside its box, and wakes when the box is tilted") {
    std::vector<physics::Ball> balls;
    for (int i = 0; i < 30; ++i) balls.push_back(disc_at({1 + 1.1 * (i % 5) + 0.03 * (i / 5), 1 + 1.1 * (i / 5)}));
    Run run(physics::Steps{}, scene_of(chain({{0, 20}, {0, 0}, {7, 0}, {7, 20}}, material(0.6)), balls));
    run.to(15);
    CHECK(fastest(run) <= 1e-3);
    CHECK(deepest_overlap(run) <= 0.01);
    run.tilt(0.8);  // steeper than a heap of round things stands
    double most = 0;
    for (int i = 1; i <= 60; ++i) {
        run.to(15 + i / 60.0);
        most = std::max(most, fastest(run));
    }
    CHECK(most > 1e-2);
    for (int i = 0; i < 30; ++i) {
        Vec2 const p = run.state(i).position;
        CHECK(p.x() > 0.45);
        CHECK(p.x() < 6.55);
        CHECK(p.y() > 0.45);
    }
}
