// A moment: everything that a picture shows of one time, read from a history and from the game.
#pragma once

#include <vector>

#include "game/session.h"
#include "physics/world/world.h"
#include "view/camera.h"
#include "view/trajectory_preview.h"
#include "view/wake.h"

namespace view {

// Over how long accelerations are measured for the overlay of forces.
inline constexpr double force_interval = 1.0 / 60;  // s
// How long a chart of energies looks back, and how often.
inline constexpr double chart_length = 2;          // s
inline constexpr double chart_spacing = 1.0 / 30;  // s
static_assert(chart_length + chart_spacing <= camera_memory);

struct Moment {
    double time = 0;
    std::vector<physics::State> balls;
    std::vector<physics::State> before;  // the balls force_interval earlier
    std::vector<physics::Phase> phases;
    std::vector<physics::Contact> contacts;
    std::vector<Wake> wakes;                          // by ball
    std::vector<std::vector<physics::State>> recent;  // the last chart_length, oldest first, by time and ball

    // What the game adds.
    physics::Forces forces;          // that act at this time
    std::vector<double> noticed_at;  // s, by sensor: when it first fired; never, or missing, = it has not
    game::Status status;
    std::vector<TrajectoryPreview> coming;  // the window's own, while the player aims
};

enum class Recall { nothing, chart };  // whether `recent` is filled: only the overlay of energy shows it
Moment moment_at(level::Level const& level, physics::History const& history, double time,
                 Recall recall = Recall::nothing);

// The same completed: all that the window and films show of a game at a time that is not forgotten.
Moment moment_of(game::Session const& session, double time, Recall recall);

inline bool has_fired(Moment const& moment, std::size_t sensor) {
    return sensor < moment.noticed_at.size() && moment.noticed_at[sensor] <= moment.time;
}

}  // namespace view
