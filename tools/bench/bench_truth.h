// Truth: the motion of a disc in closed form, or integrated in long double. Shares no code with the methods under test.
#pragma once

#include "bench_case.h"

namespace bench {

// Straight line, rolling or sliding as friction has it (physics.md 3.3); gravity alone acts.
std::vector<Moment> truth_on_line(Task const& task, geometry::Segment const& line);

// Straight up and down over a level floor until it lies still (physics.md 6.1).
std::vector<Moment> truth_of_bounces(Task const& task, double floor, double restitution);

// On the drag spring, free (physics.md 3.2).
std::vector<Moment> truth_on_spring(Task const& task);

// Rolling with full grip inside or outside a circle, then in flight once nothing presses (physics.md 3.5): Runge-Kutta
// of order 4 with this many steps a frame; the time of lift-off by bisection.
inline constexpr int integration_steps = 192;
std::vector<Moment> truth_on_circle(Task const& task, geometry::Arc const& arc,
                                    int steps_per_frame = integration_steps);

// Without forces: thrown back by an upright wall at x.
std::vector<Moment> truth_at_wall(Task const& task, double wall);

// Without forces, all on a level line and going right: the first ball strikes the others; after each blow, its pair
// exchanges impulse with restitution e.
std::vector<Moment> truth_of_blows(Task const& task, double restitution);

}  // namespace bench
