// Overlays: the article's figures, the forces and the energy, drawn over the scene while it moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/texts.h"
#include "view/camera.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

struct Overlays {
    bool figures = false;
    bool forces = false;
    bool energy = false;
    bool operator==(Overlays const&) const = default;
};

// How much of the past the overlays show.
inline Recall recall_for(Overlays const& overlays) { return overlays.energy ? Recall::chart : Recall::nothing; }

// "figures", "forces", "energy", "all", or several with commas; nothing for a word that is none of them.
std::optional<Overlays> overlays_from(std::string const& list);

// The article's quantities where the ball touches the ground, or above the ground that is nearest to it.
struct Figures {
    Vec2 contact = Vec2::Zero();   // m
    Vec2 normal = Vec2::UnitY();   // n, from the ground to the ball
    Vec2 velocity = Vec2::Zero();  // v, m/s
    Vec2 kept = Vec2::Zero();      // t = v - (v.n) n, m/s
    double length = 0;             // L = v ^ n, m/s
    double roll = 0;               // theta = L / r, rad/s
    bool touching = false;
};
// Nothing where no ground lies within four radii.
std::optional<Figures> figures_of(level::Level const& level, Moment const& moment, int ball);

struct Energy {  // J
    double motion = 0, rotation = 0, height = 0, spring = 0;
    double total() const { return motion + rotation + height + spring; }
};
Energy energy_of(level::Level const& level, std::vector<physics::State> const& balls, physics::Forces const& forces);

std::vector<Shape> overlay_shapes(level::Level const& level, Moment const& moment, Camera const& camera,
                                  Overlays const& overlays, game::Language language = game::Language::english);

}  // namespace view
