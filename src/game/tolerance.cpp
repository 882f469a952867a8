#include "game/tolerance.h"

#include <algorithm>
#include <cstdio>

#include "physics/world/overlap.h"

namespace game {

std::string in_metres(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g m", length);
    return text;
}

namespace {

std::string in_seconds(double time) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f s", time);
    return text;
}

// When legs began that have not been measured yet, and the present: every step is among them.
std::vector<double> times_to_measure(ToleranceWatch const& watch, Session const& session) {
    std::vector<double> times{session.world.time};
    for (physics::Trail<physics::Leg> const& legs : session.history.legs)
        for (auto leg = legs.end(); leg != legs.begin() && (leg - 1)->since > watch.until; --leg)
            times.push_back((leg - 1)->since);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

void note(ToleranceWatch& watch, double error, double time) {
    if (error <= watch.reached) return;
    watch.reached = error;
    watch.reached_at = time;
}

double overlap_at(Session const& session, double time) {
    std::vector<Vec2> centres;
    for (int ball = 0; ball < static_cast<int>(session.level->scene.balls.size()); ++ball)
        centres.push_back(physics::state_at(session.history, ball, time).position);
    return physics::deepest_overlap(session.level->scene, centres);
}

double distance_at(Session const& one, Session const& other, double time) {
    return geometry::length(physics::state_at(one.history, 0, time).position -
                            physics::state_at(other.history, 0, time).position);
}

void measure_beside_exact(ToleranceWatch& watch, Session const& session, std::vector<double> const& times) {
    Session& exact = *watch.exact;
    advance(exact, session.world.time);
    double before = std::max(watch.until, session.history.from);
    for (double const time : times) {
        double const halfway = before + (time - before) / 2;
        note(watch, distance_at(session, exact, halfway), halfway);
        note(watch, distance_at(session, exact, time), time);
        before = time;
    }
    forget_before(exact, session.world.time);
}

}  // namespace

bool is_promised(physics::Method const& method, physics::Scene const& scene) {
    bool const keeps_to_legs =
        std::holds_alternative<physics::Exact>(method) || std::holds_alternative<physics::Steps>(method);
    return keeps_to_legs && scene.balls.size() == 1;
}

std::string doubt_about(physics::Method const& method, physics::Scene const& scene) {
    if (is_promised(method, scene)) return "";
    if (scene.balls.size() == 1) return "an estimate: a step errs by more where the ball meets something";
    return "an estimate: balls may come to lean on each other, and are then stepped and overlap";
}

void watch_tolerance(Session& session, double tolerance) {
    physics::Scene const& scene = session.level->scene;
    if (is_promised(session.method, scene)) return;
    session.watch = std::make_shared<ToleranceWatch>();
    session.watch->tolerance = tolerance;
    if (scene.balls.size() == 1)
        session.watch->exact = std::make_unique<Session>(session_of(session.level, physics::Exact{}, session.inputs));
    measure(*session.watch, session);
}

void measure(ToleranceWatch& watch, Session const& session) {
    if (session.world.time <= watch.until) return;
    std::vector<double> const times = times_to_measure(watch, session);
    if (watch.exact)
        measure_beside_exact(watch, session, times);
    else
        for (double const time : times) note(watch, overlap_at(session, time), time);
    if (session.world.handed_over && !watch.handed_over) watch.handed_over = session.world.handover_time;
    watch.until = session.world.time;
}

std::optional<std::string> missed_tolerance(Session const& session) {
    if (!session.watch || session.watch->reached <= session.watch->tolerance) return std::nullopt;
    ToleranceWatch const& watch = *session.watch;
    std::string text = "the tolerance of " + in_metres(watch.tolerance) + " was missed: " + in_metres(watch.reached) +
                       (watch.exact ? " from the exact path" : " of overlap") + " at " + in_seconds(watch.reached_at);
    if (watch.handed_over) text += ", stepped since " + in_seconds(*watch.handed_over);
    return text;
}

}  // namespace game
