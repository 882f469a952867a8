#include "view/overlay.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry/elementary.h"
#include "view/overlay_parts.h"
#include "view/palette.h"

namespace view {

namespace {

// Which surface the figures are about: the one touched, else the nearest.
struct Meeting {
    Vec2 point = Vec2::Zero();
    double distance = never_near;
    static constexpr double never_near = 1e300;
};

Meeting nearest_ground(physics::Terrain const& terrain, Vec2 const& centre, double reach) {
    Meeting meeting;
    terrain.tree.each_overlapping(geometry::grown({centre, centre}, reach), [&](int piece) {
        geometry::Nearest const nearest =
            geometry::nearest_point(terrain.pieces[static_cast<std::size_t>(piece)].curve, centre);
        if (nearest.distance < meeting.distance) meeting = {nearest.point, nearest.distance};
    });
    return meeting;
}

}  // namespace

std::optional<Overlays> overlays_from(std::string const& list) {
    Overlays overlays;
    std::istringstream words(list);
    std::string word;
    bool any = false;
    while (std::getline(words, word, ',')) {
        any = true;
        if (word == "figures")
            overlays.figures = true;
        else if (word == "forces")
            overlays.forces = true;
        else if (word == "energy")
            overlays.energy = true;
        else if (word == "all")
            overlays = {true, true, true};
        else
            return std::nullopt;
    }
    if (!any || list.back() == ',') return std::nullopt;
    return overlays;
}

std::optional<Figures> figures_of(level::Level const& level, Moment const& moment, int ball) {
    auto const index = static_cast<std::size_t>(ball);
    physics::State const& state = moment.balls[index];
    double const radius = level.scene.balls[index].radius;
    Meeting const meeting = nearest_ground(level.scene.terrain, state.position, 4 * radius);
    if (meeting.distance > 4 * radius || meeting.distance <= 0) return std::nullopt;
    Figures figures;
    figures.contact = meeting.point;
    figures.normal = (state.position - meeting.point) / meeting.distance;
    figures.velocity = state.velocity;
    figures.kept = state.velocity - geometry::dot(state.velocity, figures.normal) * figures.normal;
    figures.length = geometry::cross(state.velocity, figures.normal);
    figures.roll = figures.length / radius;
    figures.touching = moment.contacts[index].feature >= 0;
    return figures;
}

Energy energy_of(level::Level const& level, std::vector<physics::State> const& balls, physics::Forces const& forces) {
    Energy energy;
    Vec2 const gravity = physics::gravity_of(level.scene, forces);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        physics::Ball const& ball = level.scene.balls[i];
        physics::State const& state = balls[i];
        energy.motion += ball.mass / 2 * geometry::dot(state.velocity, state.velocity);
        energy.rotation += ball.mass / 2 * ball.inertia * ball.radius * ball.radius * state.spin * state.spin;
        energy.height -= ball.mass * geometry::dot(gravity, state.position);
        if (!forces.pull || forces.pull->ball != static_cast<int>(i)) continue;
        double const omega = 2 * geometry::pi * level.scene.drag.frequency;
        Vec2 const stretch = forces.pull->target - state.position;
        energy.spring += ball.mass / 2 * omega * omega * geometry::dot(stretch, stretch);
    }
    return energy;
}

std::vector<Shape> overlay_shapes(level::Level const& level, Moment const& moment, Camera const& camera,
                                  Overlays const& overlays, game::Language language) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(camera.size);
    // In columns from the upper right corner: they stay where they are, whatever the ball does.
    Slate slate{&shapes, &camera, camera.size.x() - (table_width + 16) * unit, 64 * unit, {}, language};
    auto const draw = [&](bool wanted, void (*part)(Slate&, level::Level const&, Moment const&)) {
        if (!wanted) return;
        part(slate, level, moment);
        slate.table_left -= (table_width + 8) * unit;
        slate.next_table = 64 * unit;
    };
    draw(overlays.energy, draw_energy);
    draw(overlays.figures, draw_figures);
    draw(overlays.forces, draw_forces);
    return shapes;
}

}  // namespace view
