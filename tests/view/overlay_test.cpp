#include <doctest/doctest.h>

#include "stages.h"
#include "view/overlay.h"

using view::Vec2;
using namespace view_test;

TEST_CASE("the figures are those of the article") {
    level::Level const level = floor_level(16, 9);
    view::Moment const moment = view::moment_at(level, steady_history({{5, 1.5}, {3, -2}, 0, 0}), 0);
    auto const figures = view::figures_of(level, moment, 0);
    REQUIRE(figures);
    // n = (0, 1): t = v - (v.n) n = (3, 0), L = v ^ n = 3 * 1 - (-2) * 0 = 3, theta = L / r = 3 / 0.5.
    CHECK(geometry::length(figures->normal - Vec2(0, 1)) < 1e-12);
    CHECK(geometry::length(figures->contact - Vec2(5, 1)) < 1e-12);
    CHECK(geometry::length(figures->kept - Vec2(3, 0)) < 1e-12);
    CHECK(figures->length == doctest::Approx(3).epsilon(1e-12));
    CHECK(figures->roll == doctest::Approx(6).epsilon(1e-12));
}

TEST_CASE("high above the ground there are no figures") {
    level::Level const level = floor_level(16, 9);
    CHECK(!view::figures_of(level, view::moment_at(level, resting_history({5, 7}), 0), 0));
}

TEST_CASE("energy is that of motion, rotation, height and spring") {
    level::Level level = floor_level(16, 9);
    level.scene.balls[0].mass = 2;
    level.scene.drag.frequency = 1;
    view::Energy const energy = view::energy_of(level, {{{5, 3}, {3, 4}, 0, 6}}, {0, physics::Pull{0, {5, 3.5}}});
    CHECK(energy.motion == doctest::Approx(2 * 25 / 2.0));
    // I = k m r^2 = 0.5 * 2 * 0.25, and I w^2 / 2 = 0.25 * 36 / 2.
    CHECK(energy.rotation == doctest::Approx(4.5));
    CHECK(energy.height == doctest::Approx(2 * 9.81 * 3));
    // (2 pi)^2 is 39.4784176; times m s^2 / 2 = 2 * 0.25 / 2.
    CHECK(energy.spring == doctest::Approx(9.8696044).epsilon(1e-8));
}

TEST_CASE("the curve of energies is that of the last two seconds, however much more of the past is known") {
    level::Level level = floor_level(16, 9);
    level.scene.balls[0].start.position = Vec2(5, 6);
    game::Session session = session_of(level);
    game::advance(session, 5);
    view::Recall const recall = view::recall_for({false, false, true});
    view::Moment const all = view::moment_of(session, 4, recall);
    game::forget_before(session, 4 - view::camera_memory);
    view::Moment const late = view::moment_of(session, 4, recall);
    REQUIRE(all.recent.size() == 61);  // every 1/30 s from 2 s to 4 s
    REQUIRE(late.recent.size() == 61);
    for (std::size_t i = 0; i < 61; ++i) {
        CHECK(all.recent[i][0].position == late.recent[i][0].position);
        CHECK(all.recent[i][0].position ==
              physics::state_at(session.history, 0, (60 + static_cast<double>(i)) / 30).position);
    }
    view::Camera const camera;
    std::size_t const with_curve = view::overlay_shapes(level, late, camera, {false, false, true}).size();
    view::Moment const bare = view::moment_of(session, 4, view::recall_for({true, true, false}));
    CHECK(bare.recent.empty());
    // A panel, and of each of the three lines sixty strokes.
    CHECK(with_curve == view::overlay_shapes(level, bare, camera, {false, false, true}).size() + 1 + 3 * 60);
}

TEST_CASE("a list of overlays is read word by word") {
    CHECK(view::overlays_from("figures,energy") == view::Overlays{true, false, true});
    CHECK(view::overlays_from("all") == view::Overlays{true, true, true});
    CHECK(!view::overlays_from("figure"));
    CHECK(!view::overlays_from(""));
    CHECK(!view::overlays_from("forces,"));
    CHECK(!view::overlays_from("forces,,energy"));
}

TEST_CASE("names of figures and forces do not lie on each other as a ball that is pulled sets out") {
    level::Level level = floor_level(16, 9);
    level.scene.drag.frequency = 0.4;
    for (double const speed : {0.5, 1.0, 1.5, 2.0, 3.0}) {
        CAPTURE(speed);
        view::Moment moment = view::moment_at(level, steady_history({{5, 1.5}, {speed, 0}, 0, 0}), 0.1);
        moment.forces.pull = physics::Pull{0, moment.balls[0].position + Vec2(1, 0.4)};
        view::Camera camera;
        auto const shapes = view::overlay_shapes(level, moment, camera, {true, true, false});
        std::vector<view::Panel> names = all_of<view::Panel>(shapes);
        std::erase_if(names, [](view::Panel const& panel) { return panel.size.y() != 20; });
        REQUIRE(names.size() >= 5);
        for (std::size_t i = 0; i < names.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                Vec2 const a = names[i].corner, b = names[j].corner;
                Vec2 const a_end = a + names[i].size, b_end = b + names[j].size;
                bool const apart = a_end.x() <= b.x() || b_end.x() <= a.x() || a_end.y() <= b.y() || b_end.y() <= a.y();
                CHECK(apart);
            }
    }
}
