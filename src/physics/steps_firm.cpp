#include "physics/steps_firm.h"

#include <algorithm>
#include <cmath>

#include "physics/exact.h"
#include "physics/steps_hit.h"
#include "physics/steps_plan.h"
#include "physics/steps_together.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr std::size_t most_balls = 24;  // in one crowd; those farther off are left for the next substep
constexpr double longest_move = 0.5;    // share of the radius, at once
constexpr int most_moves = 16;          // apart: each takes the normals as they stand then
constexpr double leeway = 1 + 5e-4;     // between `deepest` and `too_deep`
constexpr double near_by = 0.1;         // share of the radius: contacts nearer than this are minded

double gap_of(Stage const& stage, Neighbours const& e) {
    Traveller const& a = stage.travellers[e.first];
    Traveller const& b = stage.travellers[e.second];
    return length(b.state.position - a.state.position) - (a.ball->radius + b.ball->radius);
}

double smaller_radius(Stage const& stage, Neighbours const& e) {
    return std::min(stage.travellers[e.first].ball->radius, stage.travellers[e.second].ball->radius);
}

bool has(std::vector<int> const& balls, int ball) { return std::find(balls.begin(), balls.end(), ball) != balls.end(); }

// The balls that hang together with the first ones, ring by ring.
std::vector<int> crowd_about(Stage const& stage, std::vector<int> crowd) {
    for (std::size_t before = 0; before != crowd.size() && crowd.size() < most_balls;) {
        before = crowd.size();
        std::vector<int> ring;
        for (int const k : stage.live) {
            Neighbours const& e = stage.neighbours[k];
            bool const first = has(crowd, e.first), second = has(crowd, e.second);
            if (first == second) continue;
            if (!e.leaning && gap_of(stage, e) > near_by * smaller_radius(stage, e)) continue;
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

void add_terrain(Stage& stage, int ball, std::vector<FirmTouch>& contacts) {
    Traveller& traveller = stage.travellers[ball];
    double const radius = traveller.ball->radius;
    for (Shape const& shape : shapes_on_the_way(stage.scene.terrain, traveller.state.position,
                                                traveller.state.position, radius, traveller.near)) {
        Sight const sight = sight_of(stage.scene.terrain, shape, traveller.state.position);
        if (!sight.faces || sight.distance - radius > near_by * radius) continue;
        contacts.push_back(
            {{-1, ball, sight.normal, 0, 1 / traveller.ball->mass, 0}, sight.distance - radius, deepest * radius, -1});
    }
}

std::vector<FirmTouch> contacts_among(Stage& stage, std::vector<int> const& crowd) {
    std::vector<FirmTouch> contacts;
    for (int const k : stage.live) {
        Neighbours const& e = stage.neighbours[k];
        if (!has(crowd, e.first) || !has(crowd, e.second)) continue;
        double const gap = gap_of(stage, e), radius = smaller_radius(stage, e);
        if (gap > near_by * radius) continue;
        Traveller const& a = stage.travellers[e.first];
        Traveller const& b = stage.travellers[e.second];
        Vec2 const d = b.state.position - a.state.position;
        double const distance = length(d);
        Vec2 const normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
        contacts.push_back(
            {{e.first, e.second, normal, 1 / a.ball->mass, 1 / b.ball->mass, 0}, gap, deepest * radius, k});
    }
    for (int const ball : crowd) add_terrain(stage, ball, contacts);
    return contacts;
}

std::vector<ContactPush> pushes_of(std::vector<FirmTouch> const& contacts) {
    std::vector<ContactPush> pushes;
    for (FirmTouch const& contact : contacts) pushes.push_back(contact.push);
    return pushes;
}

double parting_speed(Stage const& stage, ContactPush const& push) {
    Vec2 const& second = stage.travellers[push.second].state.velocity;
    return dot(push.first < 0 ? second : Vec2(second - stage.travellers[push.first].state.velocity), push.normal);
}

// From now on no contact closes by more than its gap in `time`. What is pressed together leans.
void stop(Stage& stage, std::vector<FirmTouch>& contacts, double time) {
    for (FirmTouch& contact : contacts)
        contact.push.wanted = -std::max(0.0, contact.gap) / time - parting_speed(stage, contact.push);
    std::vector<double> const impulses = least_pushes(pushes_of(contacts));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        ContactPush const& push = contacts[i].push;
        Vec2 const impulse = impulses[i] * push.normal;
        stage.travellers[push.second].state.velocity += push.second_yield * impulse;
        if (push.first < 0) continue;
        stage.travellers[push.first].state.velocity -= push.first_yield * impulse;
        Neighbours& e = stage.neighbours[contacts[i].pair];
        if (impulses[i] <= 0 || e.leaning) continue;
        e.leaning = true;
        stage.regroup = stage.relist = true;
        stage.leaning[e.first] = stage.leaning[e.second] = 1;
    }
}

// Moves balls so that no contact overlaps by more than its slack, the light ones rather than the heavy ones; only part
// of the way if that is so long that it might lead through terrain.
void move_apart(Stage& stage, std::vector<int> const& crowd, std::vector<FirmTouch>& contacts) {
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
        double const most = longest_move * stage.travellers[crowd[i]].ball->radius;
        if (length(ways[i]) > most) share = std::min(share, most / length(ways[i]));
    }
    for (std::size_t i = 0; i < crowd.size(); ++i) stage.travellers[crowd[i]].state.position += share * ways[i];
}

bool any_deep(std::vector<FirmTouch> const& contacts) {
    return std::any_of(contacts.begin(), contacts.end(), [](FirmTouch const& c) { return c.gap < -c.slack * leeway; });
}

void wake(Stage& stage, int ball) {
    if (stage.asleep[ball]) stage.regroup = stage.relist = true;
    stage.asleep[ball] = 0;
    stage.travellers[ball].still = false;
}

// On to the end of the substep: who leans without the forces that would press the crowd together again.
void coast(Stage& stage, Substep const& substep, int ball, double time) {
    if (!stage.leaning[ball]) return go_on(stage, substep, ball, time);
    Traveller& traveller = stage.travellers[ball];
    double const left = substep.length - time;
    traveller.state.velocity -=
        left * acceleration_in(*traveller.field, traveller.state.position, traveller.state.velocity);
    go_on(stage, substep, ball, time);
}

// At the substep's end, from where a ball has been put.
void stay(Stage& stage, Substep const& substep, int ball) {
    if (is_stepped(stage.world, ball)) return;
    if (stage.leaning[ball]) return begin_chord(stage, ball, substep.end());
    set_out(stage.scene, stage.world, stage.history, ball, stage.travellers[ball].state, no_contact, substep.end());
    follow(stage, ball, substep.end());
}

}  // namespace

void stop_crowd(Stage& stage, Substep const& substep, int pair, double time) {
    Neighbours const& e = stage.neighbours[pair];
    std::vector<int> const crowd = crowd_about(stage, {e.first, e.second});
    for (int const ball : crowd) {
        go_back(stage, substep, ball, std::max(time, stage.departures[ball].time));
        wake(stage, ball);
        stage.struck[ball] = 1;
    }
    std::vector<FirmTouch> contacts = contacts_among(stage, crowd);
    double const left = substep.length - time;
    stop(stage, contacts, std::max(left, substep.length / 16));
    for (int const ball : crowd) coast(stage, substep, ball, std::max(time, stage.departures[ball].time));
}

void part_deep(Stage& stage, Substep const& substep, int ball, int other) {
    std::vector<int> const crowd =
        crowd_about(stage, ball == other ? std::vector<int>{ball} : std::vector<int>{ball, other});
    std::vector<FirmTouch> contacts = contacts_among(stage, crowd);
    if (!any_deep(contacts)) return;  // another of the crowd was parted before
    for (int const i : crowd) wake(stage, i);
    for (int i = 0; i < most_moves && any_deep(contacts); ++i) {
        move_apart(stage, crowd, contacts);
        contacts = contacts_among(stage, crowd);
    }
    stop(stage, contacts, substep.length);
    for (int const i : crowd) stay(stage, substep, i);
}

}  // namespace physics
