#include "physics/plan/leg_plan.h"

#include <algorithm>
#include <cmath>

#include "physics/contact/first_contact.h"

namespace physics {

using geometry::dot;

namespace {

State state_at_place(MotionContext const& context, SurfaceState const& on_track, TrackPlace const& place) {
    State state;
    state.position = place.position;
    state.velocity = on_track.speed * geometry::turned_right(place.normal);
    state.angle = on_track.angle;
    state.spin = -on_track.rim / context.ball.radius;
    return state;
}

}  // namespace

State state_of(MotionContext const& context, SurfaceState const& on_track) {
    return state_at_place(context, on_track, place_at(on_track.track, on_track.q));
}

double sway_speed(MotionContext const& context, State const& state) {
    double const pull = geometry::length(acceleration_in(context.field, state.position, state.velocity));
    return std::sqrt(2 * pull * lowest_hop * context.ball.radius);
}

SurfaceState held_by_full_grip(MotionContext const& context, SurfaceState on_track) {
    double const k = context.ball.inertia;
    if (on_track.slip() == 0 || std::isfinite(material_of(context.terrain, on_track.contact.feature).friction))
        return on_track;
    on_track.speed = on_track.rim = (on_track.speed + k * on_track.rim) / (1 + k);
    return on_track;
}

namespace {

// Components smaller than this share of the field are rounding of its direction: a level floor is level.
constexpr double level_share = 4e-16;

// The field where the ball is, and the normal there.
struct Push {
    Vec2 field = Vec2::Zero();   // m/s^2
    Vec2 normal = Vec2::Zero();  // unit
};
Push push_at(MotionContext const& context, SurfaceState const& on_track) {
    TrackPlace const place = place_at(on_track.track, on_track.q);
    State const state = state_at_place(context, on_track, place);
    return {acceleration_in(context.field, state.position, state.velocity), place.normal};
}

double normal_force_of(Push const& push, SurfaceState const& on_track) {
    double const pressing = -dot(push.field, push.normal);
    if (on_track.track.straight) return pressing;
    return pressing - on_track.track.sense * on_track.speed * on_track.speed / on_track.track.rho;
}

void add(ContactMode& mode, Limit const& limit) { mode.limits[mode.limit_count++] = limit; }

ContactMode slide_law(MotionContext const& context, Material const& material, double sign) {
    ContactMode mode;
    mode.phase = Phase::slide;
    mode.sign = sign;
    mode.beta = -material.friction * sign;
    mode.gamma = material.friction * sign / context.ball.inertia;
    return mode;
}

// Rolling without resistance: grip carries k|a_t|/(1+k) <= mu N.
ContactMode free_roll_law(MotionContext const& context, Material const& material) {
    double const k = context.ball.inertia;
    ContactMode mode;
    mode.alpha = 1 / (1 + k);
    if (std::isinf(material.friction)) return mode;
    double const grip = material.friction * (1 + k);
    add(mode, {-k, grip, LegEndCause::slips, ModeHint::slipping_forwards});
    add(mode, {k, grip, LegEndCause::slips, ModeHint::slipping_backwards});
    return mode;
}

// The couple of resistance is c N r, as long as grip carries it (physics.md 4.2).
ContactMode resisted_roll_law(MotionContext const& context, Material const& material, double sign) {
    double const k = context.ball.inertia;
    ContactMode mode;
    mode.alpha = 1 / (1 + k);
    mode.beta = -material.rolling_resistance * sign / (1 + k);
    mode.sign = sign;
    if (std::isinf(material.friction)) return mode;
    double const spare = material.friction * (1 + k) - material.rolling_resistance;
    add(mode, {-k, spare, LegEndCause::goes_on, ModeHint::resisting_at_the_limit});
    add(mode, {k, spare, LegEndCause::goes_on, ModeHint::resisting_at_the_limit});
    return mode;
}

// The couple is what grip leaves for it: friction acts in full.
ContactMode limited_roll_law(MotionContext const& context, Material const& material, double sign, double pull) {
    double const k = context.ball.inertia;
    double const grip = material.friction * (1 + k);
    double const spare = grip - material.rolling_resistance;
    ContactMode mode;
    mode.alpha = (1 + sign * pull * k) / (1 + k);
    mode.beta = -material.friction * sign;
    mode.sign = sign;
    add(mode,
        {-pull * k, grip, LegEndCause::slips, pull > 0 ? ModeHint::slipping_forwards : ModeHint::slipping_backwards});
    if (spare > 0)
        add(mode, {pull * k, -spare, LegEndCause::goes_on, ModeHint::resisting_fully});
    else
        add(mode, {pull, 0, LegEndCause::goes_on, pull > 0 ? ModeHint::pulled_backwards : ModeHint::pulled_forwards});
    return mode;
}

// Displacements below this share of the radius, and the speeds that would reach no farther on the spring, are rounding.
constexpr double spent_share = 1e-13;

// A ball on the spring that neither moves nor is driven by more than rounding rests until the pull changes: what is
// left takes it nowhere, and would slip and grip for ever.
bool is_spent(MotionContext const& context, SurfaceState const& on_track) {
    if (!context.field.pulled) return false;
    double const reach = spent_share * context.ball.radius, stiffness = context.field.spring.stiffness;
    double const fastest = std::max(std::abs(on_track.speed), std::abs(on_track.rim));
    return fastest <= reach * std::sqrt(stiffness) &&
           std::abs(tangent_acceleration(context, on_track)) <= reach * stiffness;
}

ContactMode rest_law() {
    ContactMode mode;
    mode.phase = Phase::rest;
    return mode;
}

double sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

double tangent_acceleration(MotionContext const& context, SurfaceState const& on_track) {
    Push const push = push_at(context, on_track);
    double const along = dot(push.field, geometry::turned_right(push.normal));
    return std::abs(along) <= level_share * geometry::length(push.field) ? 0 : along;
}

double normal_force(MotionContext const& context, SurfaceState const& on_track) {
    return normal_force_of(push_at(context, on_track), on_track);
}

bool is_pressed(MotionContext const& context, SurfaceState const& on_track) {
    Push const push = push_at(context, on_track);
    Vec2 const place = position_at(on_track.track, on_track.q);
    // Half of what a search for contacts takes for none (stand_at): what the one finds to close, the other presses.
    double const rounding = (bend_rounding + place_rounding(place, context.ball.radius)) / 2;
    return normal_force_of(push, on_track) > rounding * geometry::length(push.field);
}

ContactMode contact_mode_for(MotionContext const& context, SurfaceState const& on_track, ModeHint hint) {
    Material const& material = material_of(context.terrain, on_track.contact.feature);
    if (is_spent(context, on_track)) return rest_law();
    if (hint == ModeHint::slipping_forwards) return slide_law(context, material, 1);
    if (hint == ModeHint::slipping_backwards) return slide_law(context, material, -1);
    if (on_track.slip() != 0) return slide_law(context, material, sign_of(on_track.slip()));
    double const k = context.ball.inertia;
    double const a = tangent_acceleration(context, on_track);
    double const force = normal_force(context, on_track);
    double const c = material.rolling_resistance;
    // At rest friction alone holds against the pull, and its couple is at most that of the resistance.
    if (on_track.speed == 0 && std::abs(a) <= std::min(c, material.friction) * force) return rest_law();
    double const way = on_track.speed != 0 ? sign_of(on_track.speed) : sign_of(a);
    if (std::isinf(material.friction))
        return c > 0 ? resisted_roll_law(context, material, way) : free_roll_law(context, material);
    double const grip = material.friction * (1 + k) * force;
    bool const at_limit = hint == ModeHint::resisting_at_the_limit || hint == ModeHint::resisting_fully;
    if (!at_limit && k * std::abs(a) > grip) return slide_law(context, material, sign_of(a));
    if (c == 0) return free_roll_law(context, material);
    bool const limited = hint == ModeHint::resisting_at_the_limit ||
                         (hint != ModeHint::resisting_fully && k * std::abs(a) > grip - c * force);
    double const pull = hint == ModeHint::pulled_forwards ? 1 : hint == ModeHint::pulled_backwards ? -1 : sign_of(a);
    return limited ? limited_roll_law(context, material, way, pull) : resisted_roll_law(context, material, way);
}

LegPlan plan_standing(State const& state, Contact contact, double spin_rate, double since) {
    LegPlan plan;
    plan.leg.since = since;
    plan.leg.contact = contact;
    plan.leg.phase = state.spin == 0 ? Phase::rest : Phase::slide;
    plan.leg.motion = Ballistic{state, Vec2::Zero(), spin_rate};
    if (state.spin == 0 || spin_rate == 0) return plan;
    plan.end.cause = LegEndCause::spun_out;
    plan.end.time = -state.spin / spin_rate;
    plan.leg.until = since + plan.end.time;
    return plan;
}

}  // namespace physics
