#include "physics/steps/firm_contacts.h"

#include <algorithm>
#include <cmath>

#include "physics/plan/planned_balls.h"
#include "physics/steps/hits.h"
#include "physics/steps/lone_balls.h"
#include "physics/steps/simultaneous.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr std::size_t most_balls = 24;  // in one crowd; those farther off are left for the next substep
constexpr double longest_move = 0.5;    // share of the radius, at once
constexpr int most_moves = 16;          // apart: each takes the normals as they stand then
constexpr double leeway = 1 + 5e-4;     // between `deepest` and `too_deep`
constexpr double near_by = 0.1;         // share of the radius: contacts nearer than this are minded

double gap_of(StepContext const& context, BallPair const& e) {
    BodyState const& a = context.body_states[e.first];
    BodyState const& b = context.body_states[e.second];
    return length(b.state.position - a.state.position) - (a.ball->radius + b.ball->radius);
}

double smaller_radius(StepContext const& context, BallPair const& e) {
    return std::min(context.body_states[e.first].ball->radius, context.body_states[e.second].ball->radius);
}

bool has(std::vector<int> const& balls, int ball) { return std::find(balls.begin(), balls.end(), ball) != balls.end(); }

// The balls that hang together with the first ones, ring by ring.
std::vector<int> crowd_about(StepContext const& context, std::vector<int> crowd) {
    for (std::size_t before = 0; before != crowd.size() && crowd.size() < most_balls;) {
        before = crowd.size();
        std::vector<int> ring;
        for (int const k : context.live) {
            BallPair const& e = context.ball_pairs[k];
            bool const first = has(crowd, e.first), second = has(crowd, e.second);
            if (first == second) continue;
            if (!e.leaning && gap_of(context, e) > near_by * smaller_radius(context, e)) continue;
            ring.push_back(first ? e.second : e.first);
        }
        for (int const ball : ring)
            if (!has(crowd, ball)) crowd.push_back(ball);
    }
    return crowd;
}

// A contact among the crowd, or of one of it with terrain.
struct FirmTouch {
    ContactPush push;
    double gap = 0;    // m
    double slack = 0;  // m, by which it may overlap
    int pair = -1;
};

void add_terrain(StepContext& context, int ball, std::vector<FirmTouch>& contacts) {
    BodyState& body_state = context.body_states[ball];
    double const radius = body_state.ball->radius;
    for (Shape const& shape : shapes_on_the_way(context.scene.terrain, body_state.state.position,
                                                body_state.state.position, radius, body_state.near)) {
        Proximity const proximity = proximity_of(context.scene.terrain, shape, body_state.state.position);
        if (!proximity.faces || proximity.distance - radius > near_by * radius) continue;
        contacts.push_back({{-1, ball, proximity.normal, 0, 1 / body_state.ball->mass, 0},
                            proximity.distance - radius,
                            deepest * radius,
                            -1});
    }
}

std::vector<FirmTouch> contacts_among(StepContext& context, std::vector<int> const& crowd) {
    std::vector<FirmTouch> contacts;
    for (int const k : context.live) {
        BallPair const& e = context.ball_pairs[k];
        if (!has(crowd, e.first) || !has(crowd, e.second)) continue;
        double const gap = gap_of(context, e), radius = smaller_radius(context, e);
        if (gap > near_by * radius) continue;
        BodyState const& a = context.body_states[e.first];
        BodyState const& b = context.body_states[e.second];
        Vec2 const d = b.state.position - a.state.position;
        double const distance = length(d);
        Vec2 const normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
        contacts.push_back(
            {{e.first, e.second, normal, 1 / a.ball->mass, 1 / b.ball->mass, 0}, gap, deepest * radius, k});
    }
    for (int const ball : crowd) add_terrain(context, ball, contacts);
    return contacts;
}

std::vector<ContactPush> pushes_of(std::vector<FirmTouch> const& contacts) {
    std::vector<ContactPush> pushes;
    for (FirmTouch const& contact : contacts) pushes.push_back(contact.push);
    return pushes;
}

double parting_speed(StepContext const& context, ContactPush const& push) {
    Vec2 const& second = context.body_states[push.second].state.velocity;
    return dot(push.first < 0 ? second : Vec2(second - context.body_states[push.first].state.velocity), push.normal);
}

// From now on no contact closes by more than its gap in `time`. What is pressed together leans.
void stop(StepContext& context, std::vector<FirmTouch>& contacts, double time) {
    for (FirmTouch& contact : contacts)
        contact.push.wanted = -std::max(0.0, contact.gap) / time - parting_speed(context, contact.push);
    std::vector<double> const impulses = least_pushes(pushes_of(contacts));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        ContactPush const& push = contacts[i].push;
        Vec2 const impulse = impulses[i] * push.normal;
        context.body_states[push.second].state.velocity += push.second_yield * impulse;
        if (push.first < 0) continue;
        context.body_states[push.first].state.velocity -= push.first_yield * impulse;
        BallPair& e = context.ball_pairs[contacts[i].pair];
        if (impulses[i] <= 0 || e.leaning) continue;
        e.leaning = true;
        context.regroup = context.relist = true;
        context.leaning[e.first] = context.leaning[e.second] = 1;
    }
}

// Moves balls so that no contact overlaps by more than its slack, the light ones rather than the heavy ones; only part
// of the way if that is so long that it might lead through terrain.
void move_apart(StepContext& context, std::vector<int> const& crowd, std::vector<FirmTouch>& contacts) {
    for (FirmTouch& contact : contacts) contact.push.wanted = -(contact.gap + contact.slack);
    std::vector<double> const pushes = least_pushes(pushes_of(contacts));
    std::vector<Vec2> ways(crowd.size(), Vec2::Zero());
    auto const add = [&](int ball, Vec2 const& way) {
        ways[static_cast<std::size_t>(std::find(crowd.begin(), crowd.end(), ball) - crowd.begin())] += way;
    };
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        ContactPush const& push = contacts[i].push;
        add(push.second, (push.second_yield * pushes[i]) * push.normal);
        if (push.first >= 0) add(push.first, (-push.first_yield * pushes[i]) * push.normal);
    }
    double share = 1;
    for (std::size_t i = 0; i < crowd.size(); ++i) {
        double const most = longest_move * context.body_states[crowd[i]].ball->radius;
        if (length(ways[i]) > most) share = std::min(share, most / length(ways[i]));
    }
    for (std::size_t i = 0; i < crowd.size(); ++i) context.body_states[crowd[i]].state.position += share * ways[i];
}

bool any_deep(std::vector<FirmTouch> const& contacts) {
    return std::any_of(contacts.begin(), contacts.end(), [](FirmTouch const& c) { return c.gap < -c.slack * leeway; });
}

void wake(StepContext& context, int ball) {
    if (context.asleep[ball]) context.regroup = context.relist = true;
    context.asleep[ball] = 0;
    context.body_states[ball].still = false;
}

// On to the end of the substep: who leans without the forces that would press the crowd together again.
void coast(StepContext& context, Substep const& substep, int ball, double time) {
    if (!context.leaning[ball]) return go_on(context, substep, ball, time);
    BodyState& body_state = context.body_states[ball];
    double const left = substep.length - time;
    body_state.state.velocity -=
        left * acceleration_in(*body_state.field, body_state.state.position, body_state.state.velocity);
    go_on(context, substep, ball, time);
}

// At the substep's end, from where a ball has been put.
void stay(StepContext& context, Substep const& substep, int ball) {
    if (is_stepped(context.world, ball)) return;
    if (context.leaning[ball]) return begin_chord(context, ball, substep.end());
    set_out(context.scene, context.world, context.history, ball, context.body_states[ball].state, no_contact,
            substep.end());
    follow(context, ball, substep.end());
}

}  // namespace

void stop_crowd(StepContext& context, Substep const& substep, int pair, double time) {
    BallPair const& e = context.ball_pairs[pair];
    std::vector<int> const crowd = crowd_about(context, {e.first, e.second});
    for (int const ball : crowd) {
        go_back(context, substep, ball, std::max(time, context.departures[ball].time));
        wake(context, ball);
        mark_struck(context, ball);
    }
    std::vector<FirmTouch> contacts = contacts_among(context, crowd);
    double const left = substep.length - time;
    stop(context, contacts, std::max(left, substep.length / 16));
    for (int const ball : crowd) coast(context, substep, ball, std::max(time, context.departures[ball].time));
}

void part_deep(StepContext& context, Substep const& substep, int ball, int other) {
    std::vector<int> const crowd =
        crowd_about(context, ball == other ? std::vector<int>{ball} : std::vector<int>{ball, other});
    std::vector<FirmTouch> contacts = contacts_among(context, crowd);
    if (!any_deep(contacts)) return;  // another of the crowd was parted before
    for (int const i : crowd) wake(context, i);
    for (int i = 0; i < most_moves && any_deep(contacts); ++i) {
        move_apart(context, crowd, contacts);
        contacts = contacts_among(context, crowd);
    }
    stop(context, contacts, substep.length);
    for (int const i : crowd) stay(context, substep, i);
}

}  // namespace physics
