#include "physics/article.h"

#include "physics/steps/stepping.h"

namespace physics {

namespace {

constexpr double still = 1e-9;  // m/s, kept velocity below which a touching ball counts as at rest

struct Touched {
    Contact contact;
    Vec2 normal = Vec2::Zero();
    double overlap = 0;  // m
};

// What the ball overlaps at `centre` on one piece, or a contact of no feature.
Touched touched_on(Terrain const& terrain, int piece, Vec2 const& centre, double radius) {
    geometry::Nearest const nearest = geometry::nearest_point(terrain.pieces[piece].curve, centre);
    if (nearest.distance > radius || nearest.distance == 0) return {};
    Touched touched;
    touched.normal = (centre - nearest.point) / nearest.distance;
    touched.overlap = radius - nearest.distance;
    if (!nearest.inside) {
        geometry::Curve const& curve = terrain.pieces[piece].curve;
        bool const at_start = geometry::length(nearest.point - geometry::start_of(curve)) <=
                              geometry::length(nearest.point - geometry::end_of(curve));
        int const vertex = at_start ? terrain.start_vertex[piece] : terrain.end_vertex[piece];
        touched.contact = {terrain.feature_of_vertex(vertex), 1};
        return touched;
    }
    Track const track = track_of(terrain, {piece, 1}, radius);
    Vec2 const left = normal_at(track, nearest_coordinate(track, centre));
    touched.contact = {piece, geometry::dot(left, touched.normal) >= 0 ? 1 : -1};
    return touched;
}

// t = v - (v.n) n, and the spin that L = v ^ n asks for, whatever the spin was.
State article_rule(State state, Vec2 const& normal, double radius) {
    double const length = geometry::cross(state.velocity, normal);
    state.velocity -= geometry::dot(state.velocity, normal) * normal;
    state.spin = -length / radius;
    return state;
}

}  // namespace

ArticleStep article_step(Scene const& scene, Forces const& forces, int ball, State const& state, double dt) {
    double const radius = scene.balls[ball].radius;
    Field const field = field_on(scene, forces, ball);
    ArticleStep step{state, {}};
    // Velocity first, then position with the new velocity; under the drag spring, stiff as it may be, by its closed
    // form.
    Flight const flight = flight_in(field, state.position, state.velocity, dt);
    step.state.velocity = flight.velocity;
    step.state.position = field.pulled ? flight.position : Vec2(state.position + dt * flight.velocity);
    geometry::Box const reach{step.state.position - Vec2::Constant(radius),
                              step.state.position + Vec2::Constant(radius)};
    // Feet within pieces first: a ball lifted out of a flat joint's pieces no longer overlaps their ends.
    for (bool const at_ends : {false, true})
        scene.terrain.tree.each_overlapping(reach, [&](int piece) {
            Touched const touched = touched_on(scene.terrain, piece, step.state.position, radius);
            if (touched.contact.feature < 0 || scene.terrain.is_vertex(touched.contact.feature) != at_ends) return;
            step.state.position += touched.overlap * touched.normal;
            if (geometry::dot(step.state.velocity, touched.normal) > 0) return;
            step.contact = touched.contact;
            step.state = article_rule(step.state, touched.normal, radius);
        });
    // In the air the ball turns on by itself; in contact by the arc its centre runs through, L dt / r.
    step.state.angle += dt * step.state.spin;
    return step;
}

void advance_with(Article const& method, Scene const& scene, World& world, double until, History& history) {
    std::size_t const first_event = history.events.size();
    while (world.time < until) {
        double const then = time_of_step(world, method.rate, world.steps_taken + 1);
        for (int ball = 0; ball < static_cast<int>(scene.balls.size()); ++ball) {
            open_leg(world, history, ball, world.time);
            Leg const before = world.legs[ball];
            State const& state = std::get<Straight>(before.motion).from;
            ArticleStep const step = article_step(scene, world.forces, ball, state, 1 / method.rate);
            bool const rests = step.contact.feature >= 0 && geometry::length(step.state.velocity) < still;
            Phase const phase = step.contact.feature < 0 ? Phase::flight : rests ? Phase::rest : Phase::roll;
            write_leg(world, history, ball, then, {step.state, phase, step.contact});
            tell_contact_change(scene.terrain, before, world.legs[ball], ball, history);
            tell_phase_change(before, world.legs[ball], ball, history);
        }
        ++world.steps_taken;
        world.time = then;
    }
    sort_events(history, first_event);
}

}  // namespace physics
