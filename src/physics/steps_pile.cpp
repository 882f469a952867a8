#include "physics/steps_pile.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr double stiffest = 30;         // Hz, of a contact between balls
constexpr double damping = 10;          // of critical: overlaps are pushed out without a bounce
constexpr double push_out = 8;          // radii a second at which an overlap is pushed out at most
constexpr double near_ground = 0.02;    // share of the radius: nearer ground is watched beforehand
constexpr double standing = 1e-4;       // m/s: leaning balls slower than this are at rest
constexpr double longest_stride = 0.2;  // share of the radius: faster balls are swept through the terrain

// How soft a constraint is over a substep (E. Catto, Solver2D).
struct Softness {
    double bias_rate = 0;
    double mass_scale = 1;
    double impulse_scale = 0;
};
Softness softness_of(double frequency, double substep) {
    double const omega = 2 * geometry::pi * frequency;
    double const a1 = 2 * damping + substep * omega;
    double const a2 = substep * omega * a1;
    return {omega / a1, a2 / (1 + a2), 1 / (1 + a2)};
}

struct Constraint {
    Traveller* first = nullptr;   // null: terrain
    Traveller* second = nullptr;  // the normal points to it
    Vec2 normal = Vec2::Zero();
    double gap = 0;  // m
    double friction = 0;
    double normal_mass = 0;   // kg
    double tangent_mass = 0;  // kg
    double first_yield = 0;   // 1/kg, 0 for terrain and for balls left standing
    double second_yield = 0;
    double most_push = 0;  // m/s
    Softness softness;
    Impulse impulse;        // N s
    double resistance = 0;  // rolling, on terrain
    double* keep_normal = nullptr;
};

void push(Constraint const& c, double normal, double tangent) {
    Vec2 const impulse = normal * c.normal + tangent * geometry::turned_right(c.normal);
    c.second->state.velocity += c.second_yield * impulse;
    c.second->state.spin += tangent * c.second_yield / (c.second->ball->inertia * c.second->ball->radius);
    if (c.first == nullptr) return;
    c.first->state.velocity -= c.first_yield * impulse;
    c.first->state.spin += tangent * c.first_yield / (c.first->ball->inertia * c.first->ball->radius);
}

Vec2 relative_velocity(Constraint const& c) {
    return c.first == nullptr ? c.second->state.velocity : Vec2(c.second->state.velocity - c.first->state.velocity);
}

double slip_of(Constraint const& c) {
    double slip =
        dot(relative_velocity(c), geometry::turned_right(c.normal)) + c.second->ball->radius * c.second->state.spin;
    if (c.first != nullptr) slip += c.first->ball->radius * c.first->state.spin;
    return slip;
}

void complete(Constraint& c) {
    double const k2 = c.second->ball->inertia;
    double const k1 = c.first != nullptr ? c.first->ball->inertia : 1;
    c.normal_mass = 1 / (c.first_yield + c.second_yield);
    c.tangent_mass = 1 / (c.first_yield * (1 + 1 / k1) + c.second_yield * (1 + 1 / k2));
}

// What the solver does in one go over all constraints: with softness it also pushes out, without it only stops.
enum class Pass { soft, hard };

void solve(Constraint& c, Pass pass, double substep) {
    double const closing = dot(relative_velocity(c), c.normal);
    double bias = 0, mass_scale = 1, impulse_scale = 0;
    if (c.gap > 0) {
        bias = c.gap / substep;
    } else if (pass == Pass::soft) {
        bias = std::max(c.softness.bias_rate * c.gap, -c.most_push);
        mass_scale = c.softness.mass_scale;
        impulse_scale = c.softness.impulse_scale;
    }
    double const wanted = -c.normal_mass * mass_scale * (closing + bias) - impulse_scale * c.impulse.normal;
    double const normal = std::max(0.0, c.impulse.normal + wanted);
    push(c, normal - c.impulse.normal, 0);
    c.impulse.normal = normal;
    double const most = normal > 0 ? c.friction * normal : 0;
    double const tangent = std::clamp(c.impulse.tangent - c.tangent_mass * slip_of(c), -most, most);
    push(c, 0, tangent - c.impulse.tangent);
    c.impulse.tangent = tangent;
}

double yield_of(Stage const& stage, int ball) { return stage.asleep[ball] ? 0 : 1 / stage.travellers[ball].ball->mass; }

void add_pairs(Stage& stage, Softness const& softness, std::vector<Constraint>& constraints) {
    for (Encounter& e : stage.encounters) {
        if (!e.leaning || (stage.asleep[e.first] && stage.asleep[e.second])) continue;
        Traveller& a = stage.travellers[e.first];
        Traveller& b = stage.travellers[e.second];
        Vec2 const d = b.state.position - a.state.position;
        double const distance = length(d);
        Constraint c;
        c.first = &a;
        c.second = &b;
        c.normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
        c.gap = distance - a.ball->radius - b.ball->radius;
        c.friction = friction_between(*a.ball, *b.ball);
        c.first_yield = yield_of(stage, e.first);
        c.second_yield = yield_of(stage, e.second);
        c.most_push = push_out * std::min(a.ball->radius, b.ball->radius);
        c.softness = softness;
        c.impulse = e.impulse;
        complete(c);
        constraints.push_back(c);
    }
}

Impulse remembered(std::vector<Touch> const& ground, int ball, Contact contact) {
    auto const first =
        std::lower_bound(ground.begin(), ground.end(), ball, [](Touch const& touch, int b) { return touch.ball < b; });
    for (auto touch = first; touch != ground.end() && touch->ball == ball; ++touch)
        if (touch->contact == contact) return {touch->normal_impulse, touch->tangent_impulse};
    return {};
}

void add_ground(Stage& stage, Traveller& traveller, Softness const& softness, double substep,
                std::vector<Constraint>& constraints, std::vector<Touch>& touched) {
    Terrain const& terrain = stage.scene.terrain;
    double const radius = traveller.ball->radius;
    double const watch = near_ground * radius + substep * length(traveller.state.velocity);
    Vec2 const to = traveller.state.position + substep * traveller.state.velocity;
    for (Shape const& shape : shapes_on_the_way(terrain, traveller, to)) {
        Sight const sight = sight_of(terrain, shape, traveller.state.position);
        double const gap = sight.distance - radius;
        if (!sight.faces || gap > watch) continue;
        Constraint c;
        c.second = &traveller;
        c.normal = sight.normal;
        c.gap = gap;
        c.friction = shape.material->friction;
        c.resistance = shape.material->rolling_resistance;
        c.second_yield = 1 / traveller.ball->mass;
        c.most_push = push_out * radius;
        c.softness = softness;
        c.impulse = remembered(stage.ground, traveller.index, {shape.feature, sight.side});
        complete(c);
        constraints.push_back(c);
        touched.push_back({traveller.index, -1, {shape.feature, sight.side}, 0, 0});
    }
}

void resist_rolling(Constraint const& c) {
    double const k = c.second->ball->inertia, radius = c.second->ball->radius;
    double const most = c.resistance * c.impulse.normal / (c.second->ball->mass * k * radius);
    double& spin = c.second->state.spin;
    spin = spin < 0 ? std::min(0.0, spin + most) : std::max(0.0, spin - most);
}

void move_on(Substep const& substep, Traveller& traveller, Vec2 const& way) {
    if (length(way) > longest_stride * traveller.ball->radius) {
        // Not the soft way: through the air, with every line on it met.
        traveller.contact = no_contact;
        travel(substep, traveller, 0);
        return;
    }
    traveller.state.position += way;
    traveller.state.angle += substep.length * traveller.state.spin;
}

// Which surface bears each leaning ball, and whether it stands.
void note_ground(Stage& stage) {
    for (Traveller& traveller : stage.travellers) {
        if (!stage.leaning[traveller.index] || stage.asleep[traveller.index]) continue;
        traveller.contact = no_contact;
        traveller.still = length(traveller.state.velocity) <= standing &&
                          std::abs(traveller.state.spin) * traveller.ball->radius <= standing;
    }
    double most = 0;
    int last = -1;
    for (Touch const& touch : stage.ground) {
        if (touch.ball != last) most = 0;
        last = touch.ball;
        if (touch.normal_impulse <= most) continue;
        most = touch.normal_impulse;
        stage.travellers[touch.ball].contact = touch.contact;
    }
}

}  // namespace

void move_pile(Stage& stage, Substep const& substep) {
    double const h = substep.length;
    double const frequency = std::min(stiffest, 0.25 / substep.pace);
    std::vector<Constraint> constraints;
    std::vector<Touch> ground;
    Softness const firm = softness_of(2 * frequency, h);
    for (Traveller& traveller : stage.travellers) {
        if (!stage.leaning[traveller.index] || stage.asleep[traveller.index]) continue;
        State& state = traveller.state;
        state.velocity = flight_in(traveller.field, state.position, state.velocity, h).velocity;
        add_ground(stage, traveller, firm, h, constraints, ground);
    }
    add_pairs(stage, softness_of(frequency, h), constraints);
    for (Constraint const& c : constraints) push(c, c.impulse.normal, c.impulse.tangent);
    for (Constraint& c : constraints) solve(c, Pass::soft, h);
    for (Traveller& traveller : stage.travellers)
        if (stage.leaning[traveller.index] && !stage.asleep[traveller.index])
            move_on(substep, traveller, h * traveller.state.velocity);
    for (Constraint& c : constraints) solve(c, Pass::hard, h);
    auto touch = ground.begin();
    for (Constraint const& c : constraints) {
        if (c.first != nullptr) break;
        resist_rolling(c);
        touch->normal_impulse = c.impulse.normal;
        touch->tangent_impulse = c.impulse.tangent;
        ++touch;
    }
    stage.ground = std::move(ground);
    auto pair = constraints.begin() + static_cast<std::ptrdiff_t>(stage.ground.size());
    for (Encounter& e : stage.encounters)
        if (e.leaning && !(stage.asleep[e.first] && stage.asleep[e.second])) e.impulse = (pair++)->impulse;
    note_ground(stage);
}

}  // namespace physics
