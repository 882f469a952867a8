// A game: a level's world under a method, what the player has done to it, and what the rules make of it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "level/level.h"
#include "physics/method.h"

namespace game {

using geometry::Vec2;

// What the player does at one moment (docs/runs-and-traces.md).
struct Grab {
    int ball = 0;
    Vec2 pointer = Vec2::Zero();  // m
};
struct Move {
    Vec2 pointer = Vec2::Zero();
};
struct Release {};
struct Tilt {
    double angle = 0;  // rad
};
using Action = std::variant<Grab, Move, Release, Tilt>;
struct Input {
    double time = 0;  // s
    Action action;
};

struct Run {
    std::string file;        // the path it was read from; empty for one that the window makes
    std::string level_file;  // as it can be opened from here
    std::optional<std::string> level_hash;
    std::optional<std::string> method_name;  // "article", "euler", "steps", "exact"; none = auto
    std::optional<double> rate;              // steps/s
    std::optional<double> duration;          // s
    std::vector<Input> inputs;
    struct Final {
        double time = 0;
        std::optional<std::string> state_hash;
    };
    std::optional<Final> final;
};

struct Status {
    int bananas = 0;                  // picked up
    int pulls = 0;                    // how often the player took a ball
    std::optional<double> goal_time;  // s
    std::optional<double> fall_time;  // s, the player's
    bool out_of_time = false;
};

}  // namespace game
