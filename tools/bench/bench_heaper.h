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

}  // namespace bench
