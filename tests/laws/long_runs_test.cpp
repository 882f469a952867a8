// T18: an hour costs no more than its beginning promised, and its clock is right.
#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;

namespace {

constexpr double span = sanitized ? 600 : 3600;  // s
constexpr double rate = 60;                      // steps/s, where a method takes any

bool is_denormal(physics::State const& state) {
    for (double const number :
         {state.position.x(), state.position.y(), state.velocity.x(), state.velocity.y(), state.angle, state.spin})
        if (std::fpclassify(number) == FP_SUBNORMAL) return true;
    return false;
}

physics::Method coarser(physics::Method const& method) {
    if (std::holds_alternative<physics::Steps>(method)) return physics::Steps{rate, 4};
    if (std::holds_alternative<physics::Article>(method)) return physics::Article{rate};
    return method;
}

// What an hour comes to, asked four times a second.
struct Hour {
    std::size_t legs = 0, events = 0;
    int denormal = 0;  // samples
};
Hour hour_of(Run& run) {
    Hour hour;
    for (int i = 1; i <= static_cast<int>(span) * 4; ++i) {
        run.to(i / 4.0);
        hour.legs += run.history.legs[0].size() - 1;  // the last goes on
        hour.events += run.history.events.size();
        hour.denormal += is_denormal(run.state());
        run.history.events.clear();
        forget_before(run.history, run.world.time);
    }
    return hour;
}

}  // namespace

TEST_CASE("T18: an hour of rest takes a handful of legs, and the clock is right to the bit") {
    for (Bound const& bound : bounds_of(law::hour)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run run(coarser(bound.method), floor_with(disc_at({0, 0.52}), material(0.9)));
        Hour const hour = hour_of(run);
        CHECK(run.world.time == span);
        CHECK(run.leg().phase == physics::Phase::rest);
        CHECK(hour.events <= 4);
        CHECK(hour.denormal == 0);
        if (!std::holds_alternative<physics::Article>(bound.method)) CHECK(hour.legs <= 40);
    }
}

TEST_CASE("T18 pinned: article works on while the ball rests, a leg a step") {
    Run run(physics::Article{rate}, floor_with(disc_at({0, 0.52}), material(0.9)));
    CHECK(hour_of(run).legs == static_cast<std::size_t>(span * rate));
}

TEST_CASE("T18: an hour of a pull that dies out leaves no denormal numbers to slow its steps, nor ever more events") {
    for (Bound const& bound : bounds_of(law::hour))
        for (double const damping : {0.05, 0.7})
            for (bool const on_floor : {false, true}) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(damping);
                CAPTURE(on_floor);
                physics::Scene scene =
                    on_floor ? floor_with(disc_at({1, 0.5}), material(0.9)) : scene_of({}, {disc_at({1, 0})}, 0);
                scene.drag.damping = damping;
                Run run(coarser(bound.method), scene);
                run.pull(0, {0, on_floor ? 0.5 : 0});
                Hour const hour = hour_of(run);
                CHECK(run.world.time == span);
                CHECK(hour.events <= 64);
                CHECK(hour.legs <= static_cast<std::size_t>(span * rate));
                CHECK(hour.denormal <= bound.tolerance);
                CHECK(std::abs(run.state().position.x()) <= 1e-9);
            }
}
