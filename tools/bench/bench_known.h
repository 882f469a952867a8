// What a scene's balls truly do, as far as it is known, and how far a method is from that.
#pragma once

#include "bench_measure.h"
#include "bench_population.h"

namespace bench {

// Our method as a contestant.
Contestant contestant_of(physics::Method const& method);

// Where a scene's balls are, at frames and between them.
struct Known {
    std::vector<Vec2> at_frames, between_frames;
    double uncertainty = 0;  // m
};

// At frames the closed form where there is one; else and between them the exact method, doubted by as much as a fine
// stepping method, which shares no equation of motion in time with it, says otherwise.
Known known_of(Member const& member);

// m, the largest over frames, times between them and balls.
double error_of(physics::Method const& method, Task const& task, Known const& known);

// ns per simulated second, asked 60 times a second.
double cost_of(physics::Method const& method, Task const& task, Effort const& effort);

// The value below which this share of them lies; 0 of none.
double place_in(std::vector<double> values, double share);
double median_of(std::vector<double> const& values);

}  // namespace bench
