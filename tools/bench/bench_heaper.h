// Heapers: who can pile balls up, with a setting.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench_engine.h"

namespace bench {

struct Heaper {
    std::string method, setting;
    std::unique_ptr<Pile> (*start)(physics::Scene const&) = nullptr;
};

std::vector<Heaper> heapers();

}  // namespace bench
