#include <algorithm>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/backdrop.h"
#include "view/polygon.h"
#include "view/outline_points.h"

using view::Vec2;
using namespace view_test;

namespace {

physics::State const rolling_state{{6, 1.5}, {2, 0}, 0.7, -4};

view::Picture picture_at(level::Level const& level, double time, view::Moment const& more = {}) {
    view::Stage const stage = view::stage_of(std::make_shared<level::Level const>(level));
    physics::History const history = steady_history(rolling_state);
    view::Moment moment = view::moment_at(level, history, time);
    moment.forces = more.forces;
    moment.status = more.status;
    moment.noticed_at = more.noticed_at;
    return view::picture_of(stage, moment, view::camera_at(level, history, time, Vec2(1280, 720)));
}

view::Shell shell_in(view::Picture const& picture) { return all_of<view::Shell>(picture.shapes).at(0); }

// 16 m x 9 m on 1280 x 720: 80 pixels to the metre, the world's origin at the lower left corner.
Vec2 pixel(double x, double y) { return {80 * x, 720 - 80 * y}; }

}  // namespace

TEST_CASE("the ball is drawn where it is and as it is turned") {
    view::Picture const picture = picture_at(floor_level(16, 9), 0.25);
    view::Shell const shell = shell_in(picture);
    CHECK(geometry::length(shell.centre - pixel(6.5, 1.5)) < 1e-9);
    CHECK(shell.radius == doctest::Approx(40));
    CHECK(shell.angle == doctest::Approx(0.7 - 4 * 0.25).epsilon(1e-12));
    CHECK(shell.livery == 0);
    CHECK(picture.width == 1280);
    CHECK(picture.height == 720);
}

TEST_CASE("ghosts lie behind the balls") {
    view::Stage const stage = view::stage_of(std::make_shared<level::Level const>(floor_level(16, 9)));
    physics::History const history = steady_history(rolling_state);
    view::Moment const moment = view::moment_at(*stage.level, history, 0.25);
    view::Camera const camera = view::camera_at(*stage.level, history, 0.25, Vec2(1280, 720));
    view::Dressing dressing;
    dressing.ghosts = {view::Disc{Vec2(123, 45), 6.75, {}, {}, 0, 0}};
    std::vector<view::Shape> const shapes = view::picture_of(stage, moment, camera, dressing).shapes;
    auto const ghost = std::find_if(shapes.begin(), shapes.end(), [](view::Shape const& shape) {
        auto const* disc = std::get_if<view::Disc>(&shape);
        return disc && disc->radius == 6.75;
    });
    auto const is_ball = [](view::Shape const& shape) { return std::holds_alternative<view::Shell>(shape); };
    REQUIRE(ghost != shapes.end());
    CHECK(std::none_of(shapes.begin(), ghost, is_ball));
    CHECK(std::any_of(ghost, shapes.end(), is_ball));
    CHECK(view::picture_of(stage, moment, camera).shapes.size() + 1 == shapes.size());
}

TEST_CASE("under a page the heading stays, and the card at the end is not there") {
    view::Stage const stage = view::stage_of(std::make_shared<level::Level const>(floor_level(16, 9)));
    physics::History const history = steady_history(rolling_state);
    view::Camera const camera = view::camera_at(*stage.level, history, 0.25, Vec2(1280, 720));
    auto const panels = [&](view::Lettering lettering, bool is_over) {
        view::Moment moment = view::moment_at(*stage.level, history, 0.25);
        moment.time = 5;
        if (is_over) moment.status.fall_time = 0.1;
        view::Dressing dressing;
        dressing.lettering = lettering;
        return count_of<view::Panel>(view::picture_of(stage, moment, camera, dressing).shapes);
    };
    CHECK(panels(view::Lettering::game, true) > panels(view::Lettering::game, false));
    CHECK(panels(view::Lettering::heading, true) == panels(view::Lettering::game, false));
    CHECK(panels(view::Lettering::none, true) < panels(view::Lettering::heading, true));
}

TEST_CASE("a spring from the ball to the pointer is drawn while it is pulled, and only then") {
    level::Level const level = floor_level(16, 9);
    view::Moment pulled;
    pulled.forces.pull = physics::Pull{0, Vec2(9, 4)};
    view::Picture const with = picture_at(level, 0, pulled), without = picture_at(level, 0);
    int const coil = count_of<view::Stroke>(with.shapes) - count_of<view::Stroke>(without.shapes);
    CHECK(coil > 20);
    bool at_ball = false, at_pointer = false;
    for (view::Stroke const& stroke : all_of<view::Stroke>(with.shapes)) {
        at_ball = at_ball || geometry::length(stroke.from - pixel(6, 1.5)) < 1e-9;
        at_pointer = at_pointer || geometry::length(stroke.to - pixel(9, 4)) < 1e-9;
    }
    CHECK(at_ball);
    CHECK(at_pointer);
}

TEST_CASE("a spring without length is drawn without a number that is not finite") {
    view::Moment pulled;
    pulled.forces.pull = physics::Pull{0, rolling_state.position};
    for (view::Stroke const& stroke : all_of<view::Stroke>(picture_at(floor_level(16, 9), 0, pulled).shapes))
        CHECK((geometry::is_finite(stroke.from) && geometry::is_finite(stroke.to)));
}

TEST_CASE("equal times give equal backdrops and keys, in a level shown whole all times do") {
    level::Level const whole = floor_level(16, 9), large = floor_level(60, 9);
    CHECK(picture_at(whole, 0).backdrop_key == picture_at(whole, 2).backdrop_key);
    CHECK(picture_at(whole, 0).backdrop_key != 0);
    CHECK(picture_at(large, 1).backdrop_key == picture_at(large, 1).backdrop_key);
    CHECK(picture_at(large, 0.2).backdrop_key != picture_at(large, 4).backdrop_key);
    level::Level other = whole;
    other.hash = "fedcba9876543210";
    CHECK(picture_at(other, 0).backdrop_key != picture_at(whole, 0).backdrop_key);
}

TEST_CASE("a banana is drawn until it has been picked up") {
    level::Level level = floor_level(16, 9);
    level.scene.sensors.push_back({physics::DiscRegion{Vec2(3, 3), 0.25}});
    level.meanings.push_back(level::Meaning::banana);
    view::Moment taken;
    taken.noticed_at = {0.5};
    CHECK(count_of<view::Area>(picture_at(level, 0.4, taken).shapes) >= 3);
    CHECK(count_of<view::Area>(picture_at(level, 3, taken).shapes) == 0);
}

TEST_CASE("the ground's edge lies on the terrain, its earth on the side away from the ball") {
    view::Ground const ground = view::ground_of(floor_level(16, 9));
    REQUIRE(!ground.patches.empty());
    for (view::Patch const& patch : ground.patches) CHECK(patch.box.high.y() == doctest::Approx(1).epsilon(1e-12));
    CHECK(ground.patches.front().cover == view::Cover::earth);
}

TEST_CASE("a closed outline around the play is a wall, one without is solid") {
    level::Level level = floor_level(16, 9);
    level.outlines = {block({0.5, 0.5}, {8.5, 8.5}), block({4, 4}, {5, 5})};
    level.scene.balls[0].start.position = Vec2(2, 2);
    auto const earth_at = [&](Vec2 const& point) {
        int layers = 0;
        for (view::Patch const& patch : view::ground_of(level).patches) {
            if (patch.cover != view::Cover::earth) continue;
            int around = 0;
            for (auto const& ring : patch.rings) around += view::contains(ring, point) ? 1 : 0;
            layers += around % 2;
        }
        return layers;
    };
    CHECK(earth_at(Vec2(2, 2)) == 0);
    CHECK(earth_at(Vec2(4.5, 4.5)) == 1);
    CHECK(earth_at(Vec2(0.4, 4)) == 1);
    CHECK(earth_at(Vec2(0.6, 4)) == 0);
}

TEST_CASE("the ground in sight is what the whole ground has there, in its order") {
    level::Level level = floor_level(16, 9);
    level.outlines.clear();
    for (int i = 0; i < 40; ++i) {
        Vec2 const low(0.3 + i % 8 * 2, 0.3 + i / 8 * 1.8);
        level.outlines.push_back(block(low, low + Vec2(1, 0.6)));
    }
    geometry::Box const sight{Vec2(4, 2), Vec2(9, 6)};
    view::Ground const whole = view::ground_of(level);
    std::vector<view::Patch> wanted;
    for (view::Patch const& patch : whole.patches)
        if (geometry::overlap(sight, patch.box)) wanted.push_back(patch);
    REQUIRE(wanted.size() > 10);
    REQUIRE(wanted.size() < whole.patches.size());
    view::LazyGround const lazy(level);
    for (int time = 0; time < 2; ++time) {  // made, and found made
        std::vector<view::Patch> const seen = lazy.within(sight).patches;
        REQUIRE(seen.size() == wanted.size());
        for (std::size_t i = 0; i < seen.size(); ++i) {
            CHECK(seen[i].cover == wanted[i].cover);
            CHECK(seen[i].rings == wanted[i].rings);
        }
    }
    // All earth lies below all edges, and these below what grows.
    auto const layer = [](view::Cover cover) {
        return cover == view::Cover::earth ? 0 : cover == view::Cover::shade || cover == view::Cover::rim ? 1 : 2;
    };
    CHECK(std::is_sorted(whole.patches.begin(), whole.patches.end(),
                         [&](view::Patch const& a, view::Patch const& b) { return layer(a.cover) < layer(b.cover); }));
    CHECK(lazy.within({Vec2(100, 100), Vec2(101, 101)}).patches.empty());
}

TEST_CASE("points along an outline lie within half a millimetre of its arcs") {
    level::Outline outline{{geometry::Arc{Vec2(1, 2), 5, 0.3, 2.5}}, false};
    std::vector<Vec2> const points = view::points_along(outline, 10);
    for (std::size_t i = 1; i < points.size(); ++i) {
        double const middle = geometry::length((points[i - 1] + points[i]) / 2 - Vec2(1, 2));
        CHECK(5 - middle < 0.0005 + 1e-9);
    }
}

TEST_CASE("what the drawing paints is drawn in its colours, in front of the grass that comes before it") {
    level::Level level = floor_level(16, 9);
    level::Outline const slab{straight({2, 1}, {4, 1}).curves, false};
    level.decorations = {{{slab}, std::nullopt, "#ff0000", 0.1, 1}, {{slab}, std::nullopt, "#0000ff", 0.1, 0.5}};
    level.in_front = 1;
    view::Picture const picture = picture_at(level, 0);
    auto const place = [&](view::Colour const& colour) {
        for (std::size_t i = 0; i < picture.backdrop.size(); ++i)
            if (auto const* stroke = std::get_if<view::Stroke>(&picture.backdrop[i]))
                if (stroke->colour.red == colour.red && stroke->colour.blue == colour.blue) return i;
        return picture.backdrop.size();
    };
    std::size_t const red = place({1, 0, 0, 1}), blue = place({0, 0, 1, 1});
    REQUIRE(blue < picture.backdrop.size());
    CHECK(std::get<view::Stroke>(picture.backdrop[blue]).colour.alpha == doctest::Approx(0.5));
    std::size_t const ground = static_cast<std::size_t>(count_of<view::Area>(picture.backdrop));
    CHECK(blue - red > ground - 3);  // the three ridges of hills are behind both
    CHECK(std::holds_alternative<view::Area>(picture.backdrop[blue - 1]));
    CHECK(blue == picture.backdrop.size() - 1);
}

TEST_CASE("terrain that the drawing paints has no grass and no soil") {
    level::Level level = floor_level(16, 9);
    CHECK(!view::ground_of(level).patches.empty());
    level.outlines[0].painted = true;
    CHECK(view::ground_of(level).patches.empty());
}

TEST_CASE("a ball has the colour that the drawing gives it") {
    level::Level level = floor_level(16, 9);
    CHECK(!shell_in(picture_at(level, 0)).own);
    level.ball_tints = {{"#3366ff", "#000000"}};
    auto const own = shell_in(picture_at(level, 0)).own;
    REQUIRE(own);
    CHECK(own->upper.red == doctest::Approx(0.2));
    CHECK(own->upper.blue == doctest::Approx(1));
    CHECK(own->lower.red > own->upper.red);
}
