// Piles of equal discs, and heapers: who can pile them up, with a setting.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench_engine.h"

namespace bench {

struct PileSolver {
    std::string method, setting;
    std::function<std::unique_ptr<Pile>(physics::Scene const&)> start;
};

std::vector<PileSolver> heapers();

physics::Scene pile_of(int balls);

// A pile of ours that has settled for so many seconds.
struct Settled {
    double cost = 0;     // ns per simulated second, kept awake
    double overlap = 0;  // m, the deepest
};
Settled settled(int balls, physics::Steps const& method, double settling);

}  // namespace bench
