// Measures: how far a contestant is from the truth, and what it costs.
#pragma once

#include "bench_engine.h"

namespace bench {

// How much is measured; noise only ever adds to a cost, so the least of `repeats` counts.
struct Effort {
    int starts = 32;
    int repeats = 20;
    double patience = 0.4;  // s, after which a cost is not measured again
};

// The largest distance from the truth over all frames and balls, m, over the starts. A start whose answer is not
// finite, or no nearer to the truth than the ball's first position, has failed; where that is one of the two numbers,
// it is NaN.
struct Errors {
    double median = 0, high = 0;  // m; high is the 95th percentile
    int failed = 0;               // starts
};
Errors errors_of(Contestant const& contestant, std::vector<Start> const& starts);

struct Costs {
    double sampled = 0;    // ns per simulated second, asked 60 times a second
    double unsampled = 0;  // asked once, at the end
};
Costs costs_of(Contestant const& contestant, Task const& task, Effort const& effort);

}  // namespace bench
