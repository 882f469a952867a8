#include <cmath>
#include <filesystem>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/turning.h"

using view::Vec2;
using namespace view_test;

namespace {

constexpr double turn_rounding = 1e-9;

game::Session tilted_session(double when, double angle) {
    return session_of(floor_level(16, 9), physics::Exact{}, {{when, game::Tilt{angle}}});
}

}  // namespace

TEST_CASE("a tilt at once is followed along the integral of the kernel, and then held to the bit") {
    game::Session session = tilted_session(1, 0.3);
    game::advance(session, 3);
    CHECK(view::turn_at(session, 0.9) == 0);
    for (double const u : {0.1, 0.25, 0.5, 0.9}) {
        // Of 12 u (1 - u)^2 from 0 to u.
        double const share = 6 * u * u - 8 * u * u * u + 3 * u * u * u * u;
        CHECK(view::turn_at(session, 1 + u * view::turn_span) == doctest::Approx(0.3 * share).epsilon(turn_rounding));
    }
    CHECK(view::turn_at(session, 1 + view::turn_span) == 0.3);
    CHECK(view::turn_at(session, 3) == 0.3);
}

TEST_CASE("a tilt from the first moment on is followed as softly, though nothing is known of before") {
    game::Session session = tilted_session(0, 0.3);
    game::advance(session, 0.1);
    game::forget_before(session, 0);
    CHECK(view::turn_at(session, 0) == 0);
    CHECK(view::turn_at(session, 0.1) > 0);
    CHECK(view::turn_at(session, 0.1) < 0.15);
}

TEST_CASE("the turn is a function of the time, whatever was looked at or forgotten before") {
    game::Session session = tilted_session(3.6, 0.3);
    game::advance(session, 7);
    Vec2 const size(1280, 720);
    view::Camera const whole = view::camera_of(session, 3.8, size);
    CHECK(whole.right.y() > 0.01);
    game::forget_before(session, 3.8 - view::camera_memory);
    view::Camera const part = view::camera_of(session, 3.8, size);
    CHECK(whole.centre == part.centre);
    CHECK(whole.right == part.right);
    game::forget_before(session, 7 - view::camera_memory);
    CHECK(view::turn_at(session, 7) == 0.3);
}

TEST_CASE("without a tilt, or told not to, the camera is the upright one to the bit") {
    game::Session session = tilted_session(1, 0.3);
    game::advance(session, 3);
    Vec2 const size(1280, 720);
    view::Camera const upright = view::camera_at(*session.level, session.history, 2, size);
    view::Camera const never = view::camera_of(session, 2, size, view::Turning::never);
    CHECK(never.centre == upright.centre);
    CHECK(never.right == Vec2(1, 0));
    CHECK(view::camera_of(session, 0.5, size).centre == upright.centre);
    CHECK(view::camera_of(session, 2, size).right != Vec2(1, 0));
}

TEST_CASE("gravity points down in a picture that has been turned") {
    game::Session session = tilted_session(0, 0.3);
    game::advance(session, 2);
    view::Camera const camera = view::camera_of(session, 2, Vec2(1280, 720));
    Vec2 const gravity = physics::gravity_of(session.level->scene, session.world.forces);
    Vec2 const seen = view::pixels_along(camera, gravity) / camera.scale;
    CHECK(seen.x() == doctest::Approx(0).epsilon(turn_rounding));
    CHECK(seen.y() == doctest::Approx(9.81).epsilon(turn_rounding));
}

TEST_CASE("a pixel of a point of the world is that point again, however the picture is turned") {
    for (double const turn : {-2.0, -0.4, 0.1, 0.4}) {
        view::Camera camera{Vec2(3.25, -7.5), 71.3, Vec2(1913, 777)};
        camera.right = Vec2(std::cos(turn), std::sin(turn));
        CHECK(view::turn_of(camera) == doctest::Approx(turn).epsilon(turn_rounding));
        geometry::Box const sight = view::sight_of(camera);
        for (Vec2 const& pixel : {Vec2(0, 0), Vec2(1913, 0), Vec2(0, 777), Vec2(1913, 777)}) {
            Vec2 const point = view::world_of(camera, pixel);
            CHECK(geometry::length(view::pixel_of(camera, point) - pixel) < turn_rounding);
            CHECK(geometry::overlap(geometry::grown(sight, turn_rounding), {point, point}));
        }
    }
}

TEST_CASE("a ball in steady motion stays where it is in the picture while that turns about it") {
    level::Level const level = floor_level(300, 30);
    physics::History const history = steady_history({{100, 15}, {3, 0}, 0, 0});
    view::Camera const upright = view::camera_at(level, history, 4, Vec2(1280, 720));
    Vec2 const ball(112, 15);
    Vec2 const before = view::pixel_of(upright, ball);
    view::Camera const turned = view::turned_camera(upright, level, history, 4, 0.35);
    CHECK(geometry::length(view::pixel_of(turned, ball) - before) < 1e-6);
    CHECK(geometry::length(turned.centre - turned.swing - upright.centre) < turn_rounding);
}

TEST_CASE("the turned picture moves softly also where the ball bounces, and keeps the ball in sight") {
    level::Level const level = floor_level(300, 30);
    physics::History const history = bouncing_history(Vec2(100, 15), 8);
    double const turn = 0.4, step = 1e-3;
    auto const turned = [&](double t) {
        return view::turned_camera(view::camera_at(level, history, t, Vec2(1280, 720)), level, history, t, turn);
    };
    auto const centre = [&](double t) -> Vec2 { return turned(t).centre; };
    double greatest = 0;
    for (double time = 0.01; time < 4; time += step) {
        Vec2 const bend = (centre(time + step) - 2 * centre(time) + centre(time - step)) / (step * step);
        greatest = std::max(greatest, geometry::length(bend));
        Vec2 const ball = physics::state_at(history, 0, time).position;
        Vec2 const pixel = view::pixel_of(turned(time), ball);
        CHECK((pixel.x() > 0 && pixel.y() > 0 && pixel.x() < 1280 && pixel.y() < 720));
    }
    // Unturned, the bound of camera_test.cpp. The pivot's velocity is bounded as the camera's is, its lead being
    // shorter, and turning moves the centre by 2 sin(turn / 2) of it. A jump by a tenth of the turn's share of the
    // velocity would be 600 m/s^2.
    double const upright = 12 / (1.6 * 1.6) * 0.7 * 2 * 8 * 1.5;
    CHECK(greatest < upright * (1 + 2 * std::sin(turn / 2)));
}

TEST_CASE("over all shipped runs both cameras keep the ball in sight, and start, stop and turn softly") {
    Vec2 const size(640, 360);
    double const frame = 1.0 / 60;  // s
    for (auto const& entry : std::filesystem::directory_iterator(ASSETS "/runs")) {
        CAPTURE(entry.path().filename().string());
        game::Run const run = game::read_run(entry.path().string());
        game::Session session = session_of_run(run);
        game::advance(session, run.duration.value_or(10));
        auto const& level = session.level;
        auto const upright = [&](double t) { return view::camera_at(*level, session.history, t, size); };
        auto const centre = [&](double t) -> Vec2 {
            view::Camera const camera = upright(t);
            return camera.centre * camera.scale;
        };
        auto const turn = [&](double t) { return view::turn_at(session, t); };
        double shift = 0, bend = 0;  // pixels and rad a frame, by which velocities change within a frame
        for (double time = 2 * frame; time < session.world.time; time += frame) {
            Vec2 const change = centre(time) - 2 * centre(time - frame) + centre(time - 2 * frame);
            shift = std::max(shift, geometry::length(change));
            bend = std::max(bend, std::abs(turn(time) - 2 * turn(time - frame) + turn(time - 2 * frame)));
            Vec2 const ball = physics::state_at(session.history, level->player, time).position;
            Vec2 const beyond = (ball - level->size / 2).cwiseAbs() - level->size;  // of where it has fallen out
            if (beyond.maxCoeff() > 0) break;
            for (view::Camera const& camera : {upright(time), view::camera_of(session, time, size)}) {
                Vec2 const pixel = view::pixel_of(camera, ball);
                CHECK((pixel.x() > 0 && pixel.x() < 640 && pixel.y() > 0 && pixel.y() < 360));
            }
        }
        CHECK(shift < 1);
        // A tilt by all of 0.8 rad at once bends the turn by no more than the kernel's slope at age 0 gives.
        CHECK(bend <= 12 / (view::turn_span * view::turn_span) * 0.8 / 3600);
    }
}
