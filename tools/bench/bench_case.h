// Cases: the scenes of assets/lab, 32 starts of each, and where the balls then truly are.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/game.h"
#include "physics/world/world.h"

namespace bench {

using geometry::Vec2;

inline constexpr int frames_per_second = 60;  // the grid on which answers are compared

// A level as the game runs it, with what the player does.
struct Play {
    std::shared_ptr<level::Level const> level;
    std::vector<game::Input> inputs;
};

struct Task {
    physics::Scene scene;
    std::optional<physics::Pull> pull;      // from the start on
    double duration = 0;                    // s, a whole number of frames
    std::shared_ptr<Play const> play = {};  // in place of the pull; the scene is the level's
};

// A position in more digits than any method has.
struct Point {
    long double x = 0, y = 0;  // m
};
using Moment = std::vector<Point>;  // by ball

struct Start {
    Task task;
    std::vector<Moment> truth;  // by frame, from frame 1 on
};

struct Case {
    std::string name;
    std::string reference;            // how the truth is known
    std::function<Start(int)> start;  // by number; 0 is the one that is drawn
    bool arcs = false;                // worth a run on pieces in place of arcs
};

std::vector<double> frame_times(double duration);  // s

// The scenes of the folder `lab`. Throws std::runtime_error where one cannot be read.
std::vector<Case> cases_in(std::string const& lab);

// Every arc of the scene as `pieces` chords with their ends on it.
physics::Scene in_pieces(physics::Scene const& scene, int pieces);
std::vector<Vec2> corners_of(geometry::Curve const& curve, int pieces_of_an_arc);

// How far a reference that is integrated, not closed, moves when its step is halved: the largest over the starts, m.
double uncertainty_of_integration(std::string const& lab);

}  // namespace bench
