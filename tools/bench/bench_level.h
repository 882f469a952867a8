// A level or a run of the user's own: every method at every rate on it, against the best answer that can be had.
#pragma once

#include "bench_part.h"

namespace bench {

struct LevelWish {
    std::string file;
    std::optional<double> duration;  // s; none = the run's, else 10
    std::vector<double> rates;
    Effort effort;
    Report report = Report::progress;
};

// Writes level.tsv and level_reference.tsv, and prints the same for people. Throws std::runtime_error for a file that
// cannot be read.
void measure_level(LevelWish const& wish, Tables const& tables, std::ostream& to);

}  // namespace bench
