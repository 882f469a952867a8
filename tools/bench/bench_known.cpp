#include "bench_known.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bench {

namespace {

constexpr double between = 0.37;  // of a frame: where else than at frames an answer is compared

std::vector<Vec2> answers_of(physics::Method const& method, Task const& task, double shift) {
    std::vector<double> times = frame_times(task.duration);
    for (double& time : times) time -= shift / frames_per_second;
    Contestant const contestant = contestant_of(method);
    return contestant.start(contestant, task)->positions_at(times);
}

double largest_distance(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    if (a.size() != b.size()) return physics::never;
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, geometry::length(a[i] - b[i]));
    return std::isfinite(most) ? most : physics::never;
}

std::vector<Vec2> rounded(std::vector<Moment> const& truth) {
    std::vector<Vec2> all;
    for (Moment const& moment : truth)
        for (Point const& point : moment) all.push_back({static_cast<double>(point.x), static_cast<double>(point.y)});
    return all;
}

}  // namespace

Contestant contestant_of(physics::Method const& method) {
    auto const* steps = std::get_if<physics::Steps>(&method);
    for (Contestant const& ours : our_methods({steps ? steps->rate : 60}))
        if (ours.pieces == 0 && ours.method == physics::name_of(method)) return ours;
    throw std::logic_error("no contestant for a method");
}

double cost_of(physics::Method const& method, Task const& task, Effort const& effort) {
    return costs_of(contestant_of(method), task, effort).sampled;
}

Known known_of(Member const& member) {
    Known known{answers_of(physics::Exact{}, member.task, 0), answers_of(physics::Exact{}, member.task, between), 0};
    if (member.truth) {
        std::vector<Vec2> const truth = rounded(*member.truth);
        known.uncertainty = largest_distance(known.at_frames, truth);
        known.at_frames = truth;
    } else {
        known.uncertainty = largest_distance(known.at_frames, answers_of(physics::Steps{finest_rate}, member.task, 0));
    }
    return known;
}

double error_of(physics::Method const& method, Task const& task, Known const& known) {
    return std::max(largest_distance(answers_of(method, task, 0), known.at_frames),
                    largest_distance(answers_of(method, task, between), known.between_frames));
}

double place_in(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    auto const last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::lround(share * last))];
}

double median_of(std::vector<double> const& values) { return place_in(values, 0.5); }

}  // namespace bench
