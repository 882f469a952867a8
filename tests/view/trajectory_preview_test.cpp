#include <doctest/doctest.h>

#include "physics/predict.h"
#include "stages.h"
#include "view/trajectory_preview.h"

using view::Vec2;
using namespace view_test;

namespace {

// Multiples of the spacing are rounded once.
constexpr double foresight_rounding = 1e-9;

physics::History steady() { return steady_history({{1, 5}, {4, 0}, 0, 0}); }

}  // namespace

TEST_CASE("the dots of a foresight stand still while the ball moves over them") {
    level::Level const level = floor_level(16, 9);
    view::TrajectoryPreview const early = view::trajectory_preview(steady(), level.scene, 0, 0.5, 1);
    view::TrajectoryPreview const late =
        view::trajectory_preview(steady(), level.scene, 0, 0.5 + 2.25 * view::dot_spacing, 1);
    REQUIRE(late.dots.size() > 10);
    for (std::size_t i = 0; i < 10; ++i)
        CHECK(geometry::length(early.dots[i + 2].place - late.dots[i].place) < foresight_rounding);
}

TEST_CASE("a foresight reaches its horizon, and not beyond") {
    level::Level const level = floor_level(16, 9);
    view::TrajectoryPreview const preview = view::trajectory_preview(steady(), level.scene, 0, 0.01, 1);
    CHECK(preview.dots.size() == 40);
    CHECK(preview.dots.front().ahead > 0);
    CHECK(preview.dots.back().ahead <= 1);
    CHECK(preview.dots.back().place.x() == doctest::Approx(1 + 4 * 1.0).epsilon(foresight_rounding));
}

TEST_CASE("a ball that falls is foreseen to touch where its rim meets the floor") {
    level::Level level = floor_level(16, 9);
    level.scene.balls[0].start.position = Vec2(8, 1.5 + 9.81 / 2 * 0.25);
    physics::World const world = Run(physics::Exact{}, level.scene).world;
    physics::History const coming = physics::predicted(physics::Exact{}, level.scene, world, 1);
    view::TrajectoryPreview const preview = view::trajectory_preview(coming, level.scene, 0, 0, 1);
    REQUIRE(preview.touches.size() == 1);
    CHECK(preview.touches[0].ahead == doctest::Approx(0.5).epsilon(foresight_rounding));
    CHECK(preview.touches[0].place.y() == doctest::Approx(1.5).epsilon(foresight_rounding));
}

TEST_CASE("a ball at rest leaves no dots") {
    level::Level const level = floor_level(16, 9);
    view::TrajectoryPreview const preview = view::trajectory_preview(resting_history({8, 1.5}), level.scene, 0, 0, 1);
    CHECK(preview.dots.empty());
    CHECK(preview.touches.empty());
    CHECK(view::trajectory_shapes(preview, {}).empty());
}
