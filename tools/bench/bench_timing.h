// Timing: Google Benchmark behind one call. Its own flags (--benchmark_filter, --benchmark_out, ...) hold.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace bench {

// One benchmark.
struct Timed {
    std::string name;      // scene/method/setting, as a filter sees it
    double simulated = 1;  // s of the world in a run
    int repeats = 20;      // the least counts: noise only ever adds
    double work = 1;       // of a run, in steps or the like: for the time that is left
    // How many seconds so many runs take, setting up apart.
    std::function<double(int runs)> seconds;
    // Written beside the time by Google Benchmark; asked for once, before the first run.
    std::function<std::map<std::string, double>()> counters = {};
};

// Reads the flags of Google Benchmark; they hold until the program ends. Throws std::invalid_argument for one that it
// does not know.
void heed_flags(std::vector<std::string> const& flags);

enum class Report {
    nothing,
    progress,  // scene by scene with the time left, on stderr
    table,     // that, and Google Benchmark's own table on stdout
};

// Nanoseconds for a simulated second by name, the least of the repeats. What a filter leaves out is missing.
std::map<std::string, double> least_times(std::vector<Timed> const& all, Report report);

}  // namespace bench
