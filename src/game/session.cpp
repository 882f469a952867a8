#include "game/session.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "game/method_choice.h"
#include "game/tolerance.h"
#include "level/hash.h"

namespace game {

namespace {

using physics::Event;
using physics::EventKind;
using physics::Forces;

bool has_ball(level::Level const& level, int ball) {
    return ball >= 0 && ball < static_cast<int>(level.scene.balls.size());
}

// The pointer, drawn in to at most the reach from where the ball is.
Vec2 drawn_in(Vec2 const& pointer, Vec2 const& centre, double reach) {
    Vec2 const way = pointer - centre;
    double const distance = geometry::length(way);
    return distance > reach ? Vec2(centre + way * (reach / distance)) : pointer;
}

Vec2 target_for(Session const& session, int ball, Vec2 const& pointer) {
    Vec2 const centre = physics::state_at(session.history, ball, session.world.time).position;
    return drawn_in(pointer, centre, session.level->drag_reach);
}

// What acts after the input; nothing where the input means nothing.
std::optional<Forces> forces_after(Session const& session, Action const& action) {
    Forces forces = session.world.forces;
    if (auto const* grab = std::get_if<Grab>(&action)) {
        if (!has_ball(*session.level, grab->ball) || session.level->drag_reach == 0) return std::nullopt;
        forces.pull = physics::Pull{grab->ball, target_for(session, grab->ball, grab->pointer)};
    } else if (auto const* move = std::get_if<Move>(&action)) {
        if (!forces.pull) return std::nullopt;
        forces.pull->target = target_for(session, forces.pull->ball, move->pointer);
    } else if (auto const* tilt = std::get_if<Tilt>(&action)) {
        forces.tilt = std::clamp(tilt->angle, -session.level->tilt_limit, session.level->tilt_limit);
    } else {
        if (!forces.pull) return std::nullopt;
        forces.pull.reset();
    }
    return forces;
}

// The event that a trace shows for an input; a move shows none.
std::optional<Event> event_of(Session const& session, Action const& action) {
    Event event;
    event.time = session.world.time;
    if (auto const* grab = std::get_if<Grab>(&action)) {
        event.kind = EventKind::grab;
        event.ball = grab->ball;
    } else if (std::holds_alternative<Release>(action)) {
        event.kind = EventKind::release;
        event.ball = session.world.forces.pull->ball;
    } else if (std::holds_alternative<Tilt>(action)) {
        event.kind = EventKind::tilt;
        event.ball = session.level->player;
    } else {
        return std::nullopt;
    }
    event.state = physics::state_at(session.history, event.ball, event.time);
    event.contact = physics::leg_at(session.history, event.ball, event.time).contact;
    return event;
}

[[noreturn]] void cannot_go_on(Session const& session, physics::Fault const& fault) {
    throw std::runtime_error(session.level->file + ": the simulation cannot go on at " +
                             std::to_string(session.world.time) + " s: " + fault.why);
}

void let_act(Session& session, Action const& action) {
    auto const forces = forces_after(session, action);
    if (!forces) return;
    // Before it is applied: what the input causes at once, such as a lift, comes after it in the trace.
    if (auto const event = event_of(session, action)) session.history.events.push_back(*event);
    auto const fault = physics::apply(session.method, session.level->scene, session.world, *forces, session.history);
    if (fault) cannot_go_on(session, *fault);
    session.forces.push_back({session.world.time, *forces});
    if (std::holds_alternative<Grab>(action)) session.pulled_at.push_back(session.world.time);
}

constexpr double moves_per_second = 60;

// Of several multiples within one step of a stepping method, one move is enough.
bool has_acted_now(Session const& session) {
    return session.acted > 0 && session.inputs[session.acted - 1].time == session.world.time;
}

// A move, where the target of the pull would be another for it or may become so as the ball goes on.
void move_along(Session& session, Vec2 const& pointer) {
    auto const& pull = session.world.forces.pull;
    if (!pull || has_acted_now(session)) return;
    bool const is_drawn_in = target_for(session, pull->ball, pointer) != pointer;
    if (is_drawn_in || pull->target != pointer) act(session, Move{pointer});
}

bool is_over(Session const& session, double time) {
    return session.goal_time || session.fall_time || (session.level->time_limit && time > *session.level->time_limit);
}

void judge(Session& session, Event const& event) {
    if (event.kind != EventKind::sensor) return;
    level::Meaning const meaning = session.level->meanings[event.other];
    if (meaning == level::Meaning::banana || event.ball == session.level->player) {
        double& noticed = session.noticed_at[event.other];
        noticed = std::min(noticed, event.time);
    }
    if (event.ball != session.level->player || is_over(session, event.time)) return;
    if (meaning == level::Meaning::goal) session.goal_time = event.time;
    if (meaning == level::Meaning::fall) session.fall_time = event.time;
}

// By time, not by place: a sensor's event stands before what else happened at its time. To judge one twice does
// nothing.
void judge_since(Session& session, double time) {
    auto const& events = session.history.events;
    auto const first =
        std::partition_point(events.begin(), events.end(), [&](Event const& e) { return e.time < time; });
    std::for_each(first, events.end(), [&](Event const& event) { judge(session, event); });
}

void advance_freely(Session& session, double until) {
    double const before = session.world.time;
    auto const fault = physics::advance(session.method, session.level->scene, session.world, until, session.history);
    if (fault) cannot_go_on(session, *fault);
    judge_since(session, before);
    if (session.watch) measure(*session.watch, session);
}

}  // namespace

Session session_of(std::shared_ptr<level::Level const> level, physics::Method const& method, std::vector<Input> inputs,
                   std::string const& run_file) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        auto const* grab = std::get_if<Grab>(&inputs[i].action);
        if (grab && !has_ball(*level, grab->ball))
            throw std::runtime_error(run_file + ": inputs[" + std::to_string(i) + "]: grab: there is no ball " +
                                     std::to_string(grab->ball) + ", the level has " +
                                     std::to_string(level->scene.balls.size()));
    }
    Session session;
    session.level = std::move(level);
    session.method = method;
    session.inputs = std::move(inputs);
    session.noticed_at.assign(session.level->scene.sensors.size(), physics::never);
    session.world = physics::world_at_start(method, session.level->scene, session.history);
    session.forces.push_back({0, session.world.forces});
    judge_since(session, 0);
    return session;
}

void advance(Session& session, double until) {
    while (session.acted < session.inputs.size() && session.inputs[session.acted].time <= until) {
        Input const& input = session.inputs[session.acted];
        advance_freely(session, input.time);
        let_act(session, input.action);
        ++session.acted;
    }
    advance_freely(session, until);
}

void act(Session& session, Action const& action) {
    session.inputs.resize(session.acted);
    if (!forces_after(session, action)) return;
    session.inputs.push_back({session.world.time, action});
    let_act(session, action);
    ++session.acted;
}

void advance_held(Session& session, double from, double until, Pointer const& pointer) {
    double i = std::floor(from * moves_per_second);
    while (i / moves_per_second <= from) ++i;
    for (; i / moves_per_second <= until; ++i) {
        double const time = i / moves_per_second;
        advance(session, time);
        move_along(session, pointer(time));
    }
    advance(session, until);
}

Session rewound(Session const& session, double time) {
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < session.acted && session.inputs[i].time <= time; ++i)
        inputs.push_back(session.inputs[i]);
    Session earlier = session_of(session.level, session.method, std::move(inputs));
    advance(earlier, time);
    return earlier;
}

Session without_past(Session const& session) {
    Session bare;
    bare.level = session.level;
    bare.method = session.method;
    bare.world = session.world;
    bare.history.from = session.world.time;
    for (physics::Leg const& leg : session.world.legs) bare.history.legs.push_back({leg});
    bare.forces.push_back({session.world.time, session.world.forces});
    bare.noticed_at = session.noticed_at;
    bare.pulled_at = session.pulled_at;
    bare.goal_time = session.goal_time;
    bare.fall_time = session.fall_time;
    return bare;
}

void forget_before(Session& session, double time) {
    physics::forget_before(session.history, time);
    // A change at that very time is one that has just begun.
    while (session.forces.size() > 1 && session.forces[1].time < time) session.forces.pop_front();
}

Forces const& forces_at(Session const& session, double time) {
    auto const after = std::upper_bound(session.forces.begin(), session.forces.end(), time,
                                        [](double t, ForcesSince const& since) { return t < since.time; });
    return after == session.forces.begin() ? after->forces : (after - 1)->forces;
}

Status status_at(Session const& session, double time) {
    Status status;
    for (std::size_t i = 0; i < session.noticed_at.size(); ++i)
        if (session.level->meanings[i] == level::Meaning::banana && session.noticed_at[i] <= time) ++status.bananas;
    auto const& pulled_at = session.pulled_at;
    status.pulls = static_cast<int>(std::upper_bound(pulled_at.begin(), pulled_at.end(), time) - pulled_at.begin());
    if (session.goal_time && *session.goal_time <= time) status.goal_time = session.goal_time;
    if (session.fall_time && *session.fall_time <= time) status.fall_time = session.fall_time;
    auto const& limit = session.level->time_limit;
    status.out_of_time = limit && time > *limit && !status.goal_time && !status.fall_time;
    return status;
}

std::string state_hash(std::vector<physics::State> const& balls) {
    std::string bytes;
    for (physics::State const& ball : balls)
        for (double const value :
             {ball.position.x(), ball.position.y(), ball.velocity.x(), ball.velocity.y(), ball.angle, ball.spin}) {
            auto const bits = std::bit_cast<std::uint64_t>(value);
            for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>((bits >> shift) & 0xff);
        }
    return level::fnv1a_hex(std::as_bytes(std::span(bytes)));
}

std::string state_hash(Session const& session, double time) {
    std::vector<physics::State> balls;
    for (int i = 0; i < static_cast<int>(session.level->scene.balls.size()); ++i)
        balls.push_back(physics::state_at(session.history, i, time));
    return state_hash(balls);
}

Run run_of(Session const& session) {
    Run run;
    run.level_file = session.level->file;
    run.level_hash = session.level->hash;
    run.method_name = physics::name_of(session.method);
    run.rate = rate_of(session.method);
    run.duration = session.world.time;
    run.inputs.assign(session.inputs.begin(), session.inputs.begin() + static_cast<std::ptrdiff_t>(session.acted));
    run.final = Run::Final{session.world.time, state_hash(session, session.world.time)};
    return run;
}

}  // namespace game
