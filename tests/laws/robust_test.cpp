// One ball under the exact method where engines let it fall through: kinds of scenes that came from outside or that
// the hunt found. No ball is ever deeper than 1e-9 m, and none is handed over.
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using physics::EventKind;
using physics::Phase;

namespace {

// The deepest place, seen at close times: radius less distance to the nearest curve as it was drawn.
double deepest(std::vector<physics::Piece> const& drawn, Run& run, double until) {
    double deepest = -1;
    double const radius = run.scene.balls[0].radius;
    for (int i = 1; i <= until * 997; ++i) {
        run.to(i / 997.0);
        for (physics::Piece const& piece : drawn)
            deepest = std::max(deepest, radius - geometry::nearest_point(piece.curve, run.state().position).distance);
    }
    CHECK(run.count(EventKind::handover) == 0);
    return deepest;
}

}  // namespace

TEST_CASE("a ball that leaves a rounded corner upwards comes back on to it") {
    std::vector<physics::Piece> const pieces{line({0, 0}, {12, 0}, material(0.9)),
                                             arc({12, 2}, 2, -pi / 2, pi / 2, material(0.9)),
                                             line({14, 2}, {14, 3}, material(0.9))};
    Run run = exact_run(pieces, {rolling({3, 0.5}, 7)});
    CHECK(deepest(pieces, run, 4) <= 1e-9);
    CHECK(run.state().velocity.x() < 0);  // it is on its way back
}

TEST_CASE("a ball that flies up along a wall meets the arch that the wall goes over into") {
    std::vector<physics::Piece> const pieces{line({0, 0}, {0, 2.5}, material(0.9, 0.5)),
                                             arc({3, 2.5}, 3, pi, -pi / 2, material(0.9, 0.5)),
                                             line({0, 0}, {6, 0}, material(0.9, 0.5))};
    // Up to 0.3 m above the joint and back: along the chord of the way nothing is gained.
    Run run = exact_run(pieces, {disc_at({0.5, 0.5}, {0, std::sqrt(2 * g * 2.3)})});
    CHECK(deepest(pieces, run, 3) <= 1e-9);
}

TEST_CASE("a ball falls into a cup of its own radius, or a bit wider, and rests where it fits") {
    for (double const play : {0.0, 1e-10, 1e-7, 1e-3}) {
        CAPTURE(play);
        std::vector<physics::Piece> const pieces{arc({8, 4}, 0.5 + play, pi, pi, material(0.9))};
        Run run = exact_run(pieces, {disc_at({8, 6})});
        CHECK(deepest(pieces, run, 4) <= 1e-9);
        CHECK(run.state().position.x() == doctest::Approx(8).epsilon(1e-12));
        CHECK(std::abs(run.state().position.y() - (4 - play)) <= (play < 1e-6 ? play : 0) + 1e-9);
        CHECK(run.leg().phase == Phase::rest);
    }
}

TEST_CASE("what is drawn twice, there and back or in parts is as if drawn once") {
    physics::Material const of = material(0.9);
    physics::Ball const ball = disc_at({9, 0.5}, {-3, 0});
    auto const moved = [&](std::vector<physics::Piece> const& pieces) {
        return state_after(physics::Exact{}, scene_of(pieces, {ball}), 6);
    };
    physics::State const once = moved({line({0, 0}, {6, 0}, of), line({6, 0}, {10, 0}, of)});
    for (auto const& other : {moved({line({0, 0}, {6, 0}, of), line({6, 0}, {10, 0}, of), line({0, 0}, {6, 0}, of),
                                     line({6, 0}, {10, 0}, of)}),
                              moved({line({0, 0}, {6, 0}, of), line({6, 0}, {10, 0}, of), line({10, 0}, {6, 0}, of),
                                     line({6, 0}, {0, 0}, of)}),
                              moved({line({0, 0}, {10, 0}, of), line({7, 0}, {3, 0}, of)})}) {
        CHECK(geometry::length(other.position - once.position) <= 1e-9);
        CHECK(geometry::length(other.velocity - once.velocity) <= 1e-9);
    }
    // Where surfaces differ the greater friction counts.
    physics::State const ice = moved({line({0, 0}, {10, 0}, material(0)), line({10, 0}, {0, 0}, of)});
    CHECK(geometry::length(ice.position - once.position) <= 1e-9);
}

TEST_CASE("dropped on a joint, a ball bounces alike in whichever order its two surfaces are drawn") {
    Vec2 const left{0, 0}, joint{8, 0}, right{16, 0};
    physics::Material const hard = material(0.9, 0.8), soft = material(0.1, 0.2);
    std::vector<physics::State> bounced;
    for (auto const& pieces : {std::vector{line(left, joint, hard), line(joint, right, soft)},
                               std::vector{line(joint, right, soft), line(left, joint, hard)},
                               std::vector{line(right, joint, soft), line(joint, left, hard)}}) {
        Run run = exact_run(pieces, {disc_at({8, 3}, {0, 0}, 4)});
        run.to(1);
        bounced.push_back(run.history.events.front().state);
        // What rubs most is what it meets.
        CHECK(bounced.back().velocity.y() == doctest::Approx(0.8 * std::sqrt(2 * g * 2.5)).epsilon(1e-14));
        CHECK(same_bits(bounced.back(), bounced.front()));
    }
}

TEST_CASE("past the end of an upright wall and back, a ball lands where it left, however the ground is cut") {
    for (Vec2 const& origin : {Vec2(0, 0), Vec2(37.3, 11.7), Vec2(-5.1, 80.9)})
        for (double share = 0.05; share < 1; share += 0.05) {
            Vec2 const centre = origin + Vec2(0, 2.5);
            double const first = share * pi / 2;
            std::vector<physics::Piece> const pieces{line(origin - Vec2(20, 0), origin, material(0)),
                                                     arc(centre, 2.5, -pi / 2, first, material(0)),
                                                     arc(centre, 2.5, -pi / 2 + first, pi / 2 - first, material(0)),
                                                     line(centre + Vec2(2.5, 0), centre + Vec2(2.5, 1), material(0))};
            Run run = exact_run(pieces, {disc_at(origin + Vec2(-2, 0.5), {12, 0})});
            run.to(4);
            // It has risen by 2 m, the radius of its centre's way.
            CHECK(run.time_of(EventKind::land) - run.time_of(EventKind::lift) ==
                  doctest::Approx(2 * std::sqrt(144 - 4 * g) / g).epsilon(1e-12));
        }
}

TEST_CASE("out of an arc of its own radius a ball rolls on along the tangent, however the arc is cut") {
    Vec2 const centre{8, 4};
    double const end = -0.5;  // rad, the right end of the cup, which begins as far to the left of its bottom
    Vec2 const right = centre + 0.5 * Vec2(std::cos(end), std::sin(end)), along(-std::sin(end), std::cos(end));
    std::vector<physics::State> left;
    for (double share = 0; share < 1; share += 0.1) {
        double const sweep = pi + 2 * end;
        std::vector<physics::Piece> pieces{line(right, right + 5 * along, material(0.9))};
        if (share > 0) pieces.push_back(arc(centre, 0.5, -pi - end, share * sweep, material(0.9)));
        pieces.push_back(arc(centre, 0.5, -pi - end + share * sweep, (1 - share) * sweep, material(0.9)));
        left.push_back(state_after(physics::Exact{}, scene_of(pieces, {disc_at(centre, {8, 1.5})}), 0.1));
        Vec2 const way = left.back().position - centre;
        CHECK(geometry::dot(way, along) > 0.1);
        CHECK(std::abs(geometry::cross(along, way)) <= 1e-12);
        CHECK(geometry::length(left.back().position - left.front().position) <= 1e-12);
    }
}

TEST_CASE("a ball falls through a hole as wide as itself, without friction") {
    std::vector<physics::Piece> const pieces{line({0, 0}, {8, 0}, material(0)), line({9, 0}, {16, 0}, material(0))};
    Run run = exact_run(pieces, {disc_at({7, 0.5}, {1, 0})});
    CHECK(deepest(pieces, run, 4) <= 1e-9);
    CHECK(run.state().position.y() < -1);
}

TEST_CASE("ends less than a micrometre apart hold a ball that starts between them") {
    std::vector<physics::Piece> const pieces{line({0, 0}, {1, 0}, material(0.9)),
                                             line({1 + 1e-7, 1e-7}, {8, 1e-7}, material(0.9))};
    Run run = exact_run(pieces, {disc_at({1, 0.5}, {1, 0}, -2)});
    run.to(3);
    CHECK(run.state().position.x() == doctest::Approx(4).epsilon(1e-6));  // the gap is a joint: the speed is kept
    CHECK(run.state().position.y() >= 0.5);
    CHECK(run.count(EventKind::handover) == 0);
}

TEST_CASE("without gravity a ball goes from a line on to a tangent arc at once") {
    std::vector<physics::Piece> const pieces{line({-10, 0}, {0, 0}, material(0.9)),
                                             arc({0, -1.5}, 1.5, pi / 2, -pi / 2, material(0.9)),
                                             line({1.5, -1.5}, {1.5, -9}, material(0.9))};
    Run run = exact_run(pieces, {disc_at({-1, -0.5}, {5, 0}, 10)}, 0);
    CHECK(deepest(pieces, run, 2) <= 1e-9);
    CHECK(geometry::length(run.state().velocity) == doctest::Approx(5).epsilon(1e-12));
    CHECK(run.history.events.size() < 10);
}

TEST_CASE("held by the spring in a corner of restitution 1 a ball comes to rest") {
    Run run = exact_run(chain({{0, 8}, {0, 0}, {16, 0}}, material(0.1, 1, 0.05)), {disc_at({3, 3}, {1, 2})});
    run.pull(0, {-2, -1});
    run.to(6);
    CHECK(run.leg().phase == Phase::rest);
    CHECK(geometry::length(run.state().position - Vec2(0.5, 0.5)) <= 1e-9);
    CHECK(run.count(EventKind::handover) == 0);
    CHECK(run.history.events.size() < 5000);
}
