// The witness: looks at what happened closely enough to see a ball go through a line, and puts down what is wrong.
#pragma once

#include <vector>

#include "game/session.h"
#include "hunt/ground.h"
#include "hunt/judge.h"

namespace hunt {

struct Limits {
    double depth = 1e-9;   // m
    double drawn = 1e-5;   // m: vertices take ends that are up to 1e-6 m apart to one place
    double jump = 1e-8;    // m
    double energy = 1e-9;  // of 1 J/kg, or of what there is
    double hover = 3e-6;   // m
};
Limits limits_of(Sketch const& sketch, physics::Method const& method);

// The first of each kind; of depths the deepest.
class Findings {
public:
    void note(Wrong wrong, double measured, double time, std::string const& words = "");
    std::vector<Finding> by_weight() const;

private:
    std::vector<Finding> findings_;
};

void look(Sketch const& sketch, game::Session const& session, double end, Limits const& limits, Findings& findings);

}  // namespace hunt
