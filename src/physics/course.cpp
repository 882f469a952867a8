#include "physics/course.h"

#include <algorithm>
#include <cmath>

namespace physics {

using geometry::dot;

namespace {

State state_at_place(Setting const& setting, Rider const& rider, TrackPlace const& place) {
    State state;
    state.position = place.position;
    state.velocity = rider.speed * geometry::turned_right(place.normal);
    state.angle = rider.angle;
    state.spin = -rider.rim / setting.ball.radius;
    return state;
}

}  // namespace

State state_of(Setting const& setting, Rider const& rider) {
    return state_at_place(setting, rider, place_at(rider.track, rider.q));
}

double sway_speed(Setting const& setting, State const& state) {
    double const pull = geometry::length(acceleration_in(setting.field, state.position, state.velocity));
    return std::sqrt(2 * pull * lowest_hop * setting.ball.radius);
}

Rider held_by_full_grip(Setting const& setting, Rider rider) {
    double const k = setting.ball.inertia;
    if (rider.slip() == 0 || std::isfinite(material_of(setting.terrain, rider.contact.feature).friction)) return rider;
    rider.speed = rider.rim = (rider.speed + k * rider.rim) / (1 + k);
    return rider;
}

namespace {

// Components smaller than this share of the field are rounding of its direction: a level floor is level.
constexpr double level_share = 4e-16;

// The field where the rider is, and the normal there.
struct Push {
    Vec2 field = Vec2::Zero();   // m/s^2
    Vec2 normal = Vec2::Zero();  // unit
};
Push push_at(Setting const& setting, Rider const& rider) {
    TrackPlace const place = place_at(rider.track, rider.q);
    State const state = state_at_place(setting, rider, place);
    return {acceleration_in(setting.field, state.position, state.velocity), place.normal};
}

double normal_force_of(Push const& push, Rider const& rider) {
    double const pressing = -dot(push.field, push.normal);
    if (rider.track.straight) return pressing;
    return pressing - rider.track.sense * rider.speed * rider.speed / rider.track.rho;
}

void add(Law& law, Limit const& limit) { law.limits[law.limit_count++] = limit; }

Law slide_law(Setting const& setting, Material const& material, double sign) {
    Law law;
    law.phase = Phase::slide;
    law.sign = sign;
    law.beta = -material.friction * sign;
    law.gamma = material.friction * sign / setting.ball.inertia;
    return law;
}

// Rolling without resistance: grip carries k|a_t|/(1+k) <= mu N.
Law free_roll_law(Setting const& setting, Material const& material) {
    double const k = setting.ball.inertia;
    Law law;
    law.alpha = 1 / (1 + k);
    if (std::isinf(material.friction)) return law;
    double const grip = material.friction * (1 + k);
    add(law, {-k, grip, Ending::slips, Onset::slipping_forwards});
    add(law, {k, grip, Ending::slips, Onset::slipping_backwards});
    return law;
}

// The couple of resistance is c N r, as long as grip carries it (physics.md 2.5).
Law resisted_roll_law(Setting const& setting, Material const& material, double sign) {
    double const k = setting.ball.inertia;
    Law law;
    law.alpha = 1 / (1 + k);
    law.beta = -material.rolling_resistance * sign / (1 + k);
    law.sign = sign;
    if (std::isinf(material.friction)) return law;
    double const spare = material.friction * (1 + k) - material.rolling_resistance;
    add(law, {-k, spare, Ending::goes_on, Onset::resisting_at_the_limit});
    add(law, {k, spare, Ending::goes_on, Onset::resisting_at_the_limit});
    return law;
}

// The couple is what grip leaves for it: friction acts in full.
Law limited_roll_law(Setting const& setting, Material const& material, double sign, double pull) {
    double const k = setting.ball.inertia;
    double const grip = material.friction * (1 + k);
    double const spare = grip - material.rolling_resistance;
    Law law;
    law.alpha = (1 + sign * pull * k) / (1 + k);
    law.beta = -material.friction * sign;
    law.sign = sign;
    add(law, {-pull * k, grip, Ending::slips, pull > 0 ? Onset::slipping_forwards : Onset::slipping_backwards});
    if (spare > 0)
        add(law, {pull * k, -spare, Ending::goes_on, Onset::resisting_fully});
    else
        add(law, {pull, 0, Ending::goes_on, Onset::none});
    return law;
}

// Displacements below this share of the radius, and the speeds that would reach no farther on the spring, are rounding.
constexpr double spent_share = 1e-13;

// A ball on the spring that neither moves nor is driven by more than rounding rests until the pull changes: what is left
// takes it nowhere, and would slip and grip for ever.
bool is_spent(Setting const& setting, Rider const& rider) {
    if (!setting.field.pulled) return false;
    double const reach = spent_share * setting.ball.radius, stiffness = setting.field.spring.stiffness;
    double const fastest = std::max(std::abs(rider.speed), std::abs(rider.rim));
    return fastest <= reach * std::sqrt(stiffness) && std::abs(tangent_acceleration(setting, rider)) <= reach * stiffness;
}

Law rest_law() {
    Law law;
    law.phase = Phase::rest;
    return law;
}

double sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

double tangent_acceleration(Setting const& setting, Rider const& rider) {
    Push const push = push_at(setting, rider);
    double const along = dot(push.field, geometry::turned_right(push.normal));
    return std::abs(along) <= level_share * geometry::length(push.field) ? 0 : along;
}

double normal_force(Setting const& setting, Rider const& rider) {
    return normal_force_of(push_at(setting, rider), rider);
}

bool is_pressed(Setting const& setting, Rider const& rider) {
    Push const push = push_at(setting, rider);
    return normal_force_of(push, rider) > level_share * geometry::length(push.field);
}

Law law_for(Setting const& setting, Rider const& rider, Onset onset) {
    Material const& material = material_of(setting.terrain, rider.contact.feature);
    if (is_spent(setting, rider)) return rest_law();
    if (onset == Onset::slipping_forwards) return slide_law(setting, material, 1);
    if (onset == Onset::slipping_backwards) return slide_law(setting, material, -1);
    if (rider.slip() != 0) return slide_law(setting, material, sign_of(rider.slip()));
    double const k = setting.ball.inertia;
    double const a = tangent_acceleration(setting, rider);
    double const force = normal_force(setting, rider);
    double const c = material.rolling_resistance;
    // At rest friction alone holds against the pull, and its couple is at most that of the resistance.
    if (rider.speed == 0 && std::abs(a) <= std::min(c, material.friction) * force)
        return rest_law();
    double const way = rider.speed != 0 ? sign_of(rider.speed) : sign_of(a);
    if (std::isinf(material.friction))
        return c > 0 ? resisted_roll_law(setting, material, way) : free_roll_law(setting, material);
    double const grip = material.friction * (1 + k) * force;
    bool const at_limit = onset == Onset::resisting_at_the_limit || onset == Onset::resisting_fully;
    if (!at_limit && k * std::abs(a) > grip) return slide_law(setting, material, sign_of(a));
    if (c == 0) return free_roll_law(setting, material);
    bool const limited = onset == Onset::resisting_at_the_limit ||
                         (onset != Onset::resisting_fully && k * std::abs(a) > grip - c * force);
    return limited ? limited_roll_law(setting, material, way, sign_of(a)) : resisted_roll_law(setting, material, way);
}

Course standing_course(State const& state, Contact contact, double spin_rate, double since) {
    Course course;
    course.leg.since = since;
    course.leg.contact = contact;
    course.leg.phase = state.spin == 0 ? Phase::rest : Phase::slide;
    course.leg.motion = Ballistic{state, Vec2::Zero(), spin_rate};
    if (state.spin == 0 || spin_rate == 0) return course;
    course.ending = Ending::spun_out;
    course.duration = -state.spin / spin_rate;
    course.leg.until = since + course.duration;
    return course;
}

}  // namespace physics
