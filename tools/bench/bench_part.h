// Parts: what is measured together, as benchmarks, and the tables that come of it.
#pragma once

#include <fstream>

#include "bench_measure.h"

namespace bench {

using Times = std::map<std::string, double>;  // ns per simulated second by name of the benchmark

// Of a name that was not measured: not a number.
double time_in(Times const& times, std::string const& name);

struct Tables {
    std::string folder;
    std::ofstream open(std::string const& name) const;  // throws std::runtime_error
};

struct Part {
    std::vector<Timed> benchmarks;
    std::function<void(Times const&, Tables const&)> write;
};

// Every contestant on every scene: errors and costs, who is best, the least cost of an accuracy, ours against peers.
struct Contest {
    std::vector<Case> cases;
    std::vector<Contestant> contestants;
    Effort effort;
    double uncertainty = 0;  // m, of references that are integrated
};
Part contest_part(Contest const& contest);

// Piles of so many discs, settled for `settling` seconds at least and kept awake: cost of a frame and deepest overlap.
Part piles_part(std::vector<int> const& counts, double settling);

// What each need of a scene adds to its cost.
Part needs_part(Effort const& effort);

// Cost against the number of balls that fly about in a box, of surfaces that are never reached, and of chords that an
// arc is drawn as; and where two methods cost the same.
Part numbers_part(std::string const& lab, std::vector<int> const& balls, std::vector<int> const& surfaces,
                  std::vector<int> const& chords, Effort const& effort);

}  // namespace bench
