// Advice: the cheapest method and setting that keeps a tolerance, foretold from what the benchmark has measured.
#pragma once

#include <vector>

#include "physics/needs.h"

namespace physics {

// A settled pile of discs under `steps`, kept awake.
struct PileExperience {
    double rate = 0;     // steps/s
    double balls = 0;    // how many
    double overlap = 0;  // radii, the deepest
    double cost = 0;     // ns per ball and simulated second
};

// What was measured, once and for all scenes; advice_table.inc holds it, written by the benchmark. Costs are ns of
// processor time per simulated second, asked for 60 times.
struct Experience {
    double exact_error = 0;  // m, the largest ever seen
    double exact_ball = 0;   // of each ball
    double exact_pair = 0;   // of each pair of balls
    double exact_lean = 0;   // of each ball that comes to lean on others, where the world is handed over
    double exact_joint = 0;  // of each end of a piece that is passed
    double steps_frame = 0;  // of each ball and each 1/60 s
    double steps_step = 0;   // of each ball and step
    double steps_crowd = 0;  // the share by which a step costs more for every piece that lies within a radius
    double kink_error = 0;   // of the way in a step, where a ball meets something: it moves straight from step to step
    double sag_error = 0;    // of acceleration times step squared, always
    std::vector<PileExperience> piles;
};
Experience const& experience();

// What a scene shows of itself before it is run.
struct Sketch {
    double balls = 0;         // how many
    double leaning = 0;       // how many balls can come to lean on each other
    double speed = 0;         // m/s, the most that a ball can fall to or be pulled to
    double acceleration = 0;  // m/s^2, of gravity and of the drag spring drawn out
    double radius = 0;        // m, of the smallest ball
    double ends = 0;          // 1/m: how many pieces there are to a metre of terrain
    bool meets = false;       // whether a ball has anything to run into
};
Sketch sketch_of(Scene const& scene);

struct Forecast {
    Method method;
    double error = 0;  // m, which 19 of 20 scenes keep; in piles the deepest overlap
    double cost = 0;   // ns per simulated second
};
// Every method and setting that covers the scene's needs, as the benchmark's experience has it.
std::vector<Forecast> forecasts_for(Scene const& scene, Experience const& experience);

// The cheapest of them that promises half the tolerance, m; where none does, the most accurate, and it says so.
Choice advice_for(Scene const& scene, double tolerance, Experience const& experience);
inline Choice advice_for(Scene const& scene, double tolerance) { return advice_for(scene, tolerance, experience()); }

}  // namespace physics
