// Measures: how far a contestant is from the truth, and what it costs.
#pragma once

#include "bench_engine.h"
#include "bench_timing.h"

namespace bench {

// How much is measured; noise only ever adds to a cost, so the least of `repeats` counts.
struct Effort {
    int starts = 32;
    int repeats = 20;
    double most_steps = 2e5;  // in all repeats of a cost: long runs are repeated less often, but never less than
    int fewest_repeats = 3;   // so many times
};

// The largest distance from the truth over all frames and balls, m, over the starts. A start whose answer is not
// finite, or no nearer to the truth than the ball's first position, has failed; where that is one of the two numbers,
// it is NaN.
struct Errors {
    double median = 0, high = 0;  // m; high is the 95th percentile
    int failed = 0;               // starts
};
Errors errors_of(Contestant const& contestant, std::vector<Start> const& starts);

// Largest distance over all frames and balls, m; infinite for a failure.
double error_of(Contestant const& contestant, Start const& start);

struct Costs {
    double sampled = 0;    // ns per simulated second, asked 60 times a second
    double unsampled = 0;  // asked once, at the end
};
Costs costs_of(Contestant const& contestant, Task const& task, Effort const& effort);

// The same as benchmarks, asked 60 times a second or once, at the end.
Timed sampled_run(std::string const& scene, Contestant const& contestant, Task const& task, Effort const& effort);
Timed unsampled_run(std::string const& scene, Contestant const& contestant, Task const& task, Effort const& effort);

}  // namespace bench
