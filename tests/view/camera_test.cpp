#include <filesystem>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/camera.h"

using view::Vec2;
using namespace view_test;

// A few operations on numbers of the size of a thousand pixels lose at most some units in the last place.
constexpr double rounding = 1e-9;

TEST_CASE("a pixel of a point of the world is that point again") {
    view::Camera const camera{Vec2(3.25, -7.5), 71.3, Vec2(1913, 777)};
    for (Vec2 const& point : {Vec2(0, 0), Vec2(12.5, 3.75), Vec2(-400, 0.001)})
        CHECK(geometry::length(view::world_of(camera, view::pixel_of(camera, point)) - point) < rounding);
}

TEST_CASE("the middle of the picture shows the camera's centre, and up in the world is up in the picture") {
    view::Camera const camera{Vec2(2, 3), 100, Vec2(800, 600)};
    CHECK(geometry::length(view::pixel_of(camera, Vec2(2, 3)) - Vec2(400, 300)) < rounding);
    CHECK(geometry::length(view::pixel_of(camera, Vec2(2, 4)) - Vec2(400, 200)) < rounding);
}

TEST_CASE("a level of at most 16 m x 9 m is shown whole, wherever the ball is") {
    struct Case {
        Vec2 level, size;
    };
    for (Case const& c : {Case{{16, 9}, {1280, 720}}, Case{{16, 9}, {700, 900}}, Case{{4, 8.5}, {1280, 720}},
                          Case{{15, 2}, {333, 101}}, Case{{16, 9}, {1921, 1080}}}) {
        level::Level const level = floor_level(c.level.x(), c.level.y());
        physics::History const history = steady_history({c.level / 2, {30, 12}, 0, 0});
        for (double const time : {0.0, 0.4, 3.0}) {
            view::Camera const camera = view::camera_at(level, history, time, c.size);
            geometry::Box const sight = view::sight_of(camera);
            CHECK(sight.low.x() < rounding);
            CHECK(sight.low.y() < rounding);
            CHECK(sight.high.x() > c.level.x() - rounding);
            CHECK(sight.high.y() > c.level.y() - rounding);
            if (time > 0) continue;
            // Centred, and as large as it can be: one of the sides fits exactly.
            CHECK(geometry::length(camera.centre - c.level / 2) < rounding);
            Vec2 const room = c.size / camera.scale - c.level;
            CHECK(std::min(room.x(), room.y()) == doctest::Approx(0).epsilon(rounding));
        }
    }
}

TEST_CASE("in a larger level the camera follows, keeps the ball in sight and does not look beyond the level") {
    level::Level const level = floor_level(300, 30);
    Vec2 const size(1280, 720);
    physics::History const history = steady_history({{1, 2}, {40, 0}, 0, 0});
    for (double time = 0; time < 7; time += 0.1) {
        geometry::Box const sight = view::sight_of(view::camera_at(level, history, time, size));
        double const ball = 1 + 40 * time;
        // No farther than a ball that touches the edge asks for.
        CHECK(sight.low.x() > -0.25);
        CHECK(sight.high.x() < 300.25);
        CHECK(ball > sight.low.x());
        CHECK(ball < sight.high.x());
    }
}

TEST_CASE("the camera moves softly: a jump of the ball's velocity is none of the camera's") {
    level::Level const level = floor_level(300, 30);
    physics::History history = resting_history({100, 15});
    history.legs[0][0].until = 1;
    history.legs[0].push_back(steady_leg({{100, 15}, {10, 0}, 0, 0}, 1));
    auto const centre = [&](double t) { return view::camera_at(level, history, t, Vec2(1280, 720)).centre.x(); };
    double const step = 1e-3;
    // In its first millisecond the ball moves by 10 mm; the mean of its path by less than a tenth of that.
    CHECK(std::abs(centre(1 + step) - centre(1)) < 1e-3);
    CHECK(centre(4) - centre(3) == doctest::Approx(10).epsilon(1e-6));
}

TEST_CASE("a ball that leaves a level shown whole, but has not fallen out yet, is in sight with all of the level") {
    level::Level const level = floor_level(16, 9);
    for (Vec2 const& velocity : {Vec2(0, 8), Vec2(20, 0), Vec2(-20, 3), Vec2(3, -4)}) {
        physics::History const history = steady_history({{8, 1.5}, velocity, 0, 0});
        for (double time = 0; time < 3; time += 0.05) {
            Vec2 const ball = Vec2(8, 1.5) + velocity * time;
            bool const is_out = ball.x() < -8 || ball.x() > 24 || ball.y() < -4.5 || ball.y() > 13.5;
            if (is_out) break;
            geometry::Box const sight = view::sight_of(view::camera_at(level, history, time, Vec2(1280, 720)));
            CHECK(sight.low.x() < std::min(rounding, ball.x()));
            CHECK(sight.low.y() < std::min(rounding, ball.y()));
            CHECK(sight.high.x() > std::max(16 - rounding, ball.x()));
            CHECK(sight.high.y() > std::max(9 - rounding, ball.y()));
        }
    }
}

TEST_CASE("the camera's velocity is continuous and its acceleration bounded, also where the ball bounces") {
    level::Level const level = floor_level(300, 30);
    double const speed = 8;
    physics::History const history = bouncing_history(Vec2(100, 15), speed);
    auto const centre = [&](double t) { return view::camera_at(level, history, t, Vec2(1280, 720)).centre.x(); };
    double const step = 1e-3;
    double greatest = 0;
    for (double time = 0.01; time < 5; time += step)
        greatest =
            std::max(greatest, std::abs(centre(time + step) - 2 * centre(time) + centre(time - step)) / (step * step));
    // The slope of the kernel at age 0, 12 / (1.6 s)^2, times the lead of 0.7 s and the change of velocity, twice the
    // speed; half as much again for the place. Were its velocity to jump by a tenth of it, this would be 800 m/s^2.
    CHECK(greatest < 12 / (1.6 * 1.6) * 0.7 * 2 * speed * 1.5);
}

TEST_CASE("in every experiment the ball is in sight until it has fallen out") {
    for (auto const& entry : std::filesystem::directory_iterator(ASSETS "/lab")) {
        CAPTURE(entry.path().filename().string());
        auto const level = read_level(entry.path().string());
        game::Session session = game::session_of(level, game::method_for({}, level->scene));
        game::advance(session, 10);
        bool lost = false;
        for (double time = 0; time < std::min(10.0, session.fall_time.value_or(10)); time += 1.0 / 60) {
            Vec2 const ball = physics::state_at(session.history, level->player, time).position;
            Vec2 const pixel = view::pixel_of(view::camera_at(*level, session.history, time, Vec2(640, 360)), ball);
            lost = lost || pixel.x() < 0 || pixel.y() < 0 || pixel.x() > 640 || pixel.y() > 360;
        }
        CHECK_FALSE(lost);
    }
}

TEST_CASE("in a steady motion the camera looks ahead") {
    level::Level const level = floor_level(300, 30);
    physics::History const history = steady_history({{100, 15}, {5, 0}, 0, 0});
    double const centre = view::camera_at(level, history, 4, Vec2(1280, 720)).centre.x();
    CHECK(centre > 120 + 0.5);
    CHECK(centre < 120 + 3);
}

TEST_CASE("the camera needs no more of the past than it says") {
    level::Level const level = floor_level(300, 30);
    physics::History const history = bouncing_history(Vec2(100, 15), 9);
    for (double const time : {3.1, 4.0, 5.77}) {
        physics::History late = history;
        physics::forget_before(late, time - view::camera_memory);
        view::Camera const whole = view::camera_at(level, history, time, Vec2(640, 360));
        view::Camera const part = view::camera_at(level, late, time, Vec2(640, 360));
        CHECK(whole.centre == part.centre);
        CHECK(whole.scale == part.scale);
    }
}

TEST_CASE("a large ball on a large page is seen no larger than in the levels that ship, nor a small one lost") {
    level::Level level = floor_level(210, 297);
    level.scene.balls[0].radius = 4;
    physics::History const history = steady_history(level.scene.balls[0].start);
    view::Camera const camera = view::camera_at(level, history, 0, Vec2(1280, 720));
    double const across = 2 * 4 * camera.scale / 1280;
    CHECK(across > 0.04);
    CHECK(across < 0.1);
}

TEST_CASE("the wheel keeps the point under the pointer") {
    level::Level const level = floor_level(16, 9);
    physics::History const history = resting_history({8, 4.5});
    Vec2 const size(1280, 720), pointer(700, 400);
    view::Lens lens;
    view::Camera const before = view::camera_at(level, history, 0, size, lens);
    Vec2 const point = view::world_of(before, pointer);
    for (int i = 0; i < 5; ++i) lens = view::zoomed(lens, view::camera_at(level, history, 0, size, lens), pointer, 1);
    view::Camera const after = view::camera_at(level, history, 0, size, lens);
    CHECK(after.scale == doctest::Approx(before.scale * std::pow(1.15, 5)).epsilon(1e-12));
    CHECK(geometry::length(view::world_of(after, pointer) - point) < rounding);
    for (int i = 0; i < 5; ++i) lens = view::zoomed(lens, view::camera_at(level, history, 0, size, lens), pointer, -1);
    CHECK(geometry::length(view::camera_at(level, history, 0, size, lens).centre - before.centre) < 1e-6);
}

TEST_CASE(
    "where motion is reduced a camera that follows is a quarter farther away, and one that shows all is the same") {
    view::Lens calm;
    calm.motion = view::Motion::reduced;
    Vec2 const size(1280, 720);
    physics::History const history = steady_history({{20, 1.5}, {6, 0}, 0, 0});
    level::Level const large = floor_level(60, 20), small = floor_level(16, 9);
    view::Camera const usual = view::camera_at(large, history, 3, size);
    view::Camera const far = view::camera_at(large, history, 3, size, calm);
    CHECK(far.scale == doctest::Approx(usual.scale * 0.8));
    CHECK(far.centre.x() < usual.centre.x());  // it looks less far ahead
    CHECK(view::camera_at(small, history, 0.1, size, calm).scale == view::camera_at(small, history, 0.1, size).scale);
}
