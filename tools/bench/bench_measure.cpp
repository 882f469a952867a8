#include "bench_measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace bench {

namespace {

constexpr double batch = 2e-4;  // s: shorter runs are timed several at a time
constexpr int largest_batch = 64;

double distance(Vec2 const& a, Point const& b) { return static_cast<double>(std::hypot(a.x() - b.x, a.y() - b.y)); }

// Infinite for a failure, so that it sorts last.
double error_of(Contestant const& contestant, Start const& start) {
    auto const& balls = start.task.scene.balls;
    auto const positions = contestant.start(contestant, start.task)->positions_at(frame_times(start.task.duration));
    if (positions.size() != start.truth.size() * balls.size()) return physics::never;
    double worst = 0, way = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        Point const& truth = start.truth[i / balls.size()][i % balls.size()];
        double const error = distance(positions[i], truth);
        if (!std::isfinite(error)) return physics::never;
        worst = std::max(worst, error);
        way = std::max(way, distance(balls[i % balls.size()].start.position, truth));
    }
    return worst < way ? worst : physics::never;
}

double or_nan(double error) { return std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN(); }

double seconds_for(Contestant const& contestant, Task const& task, std::vector<double> const& times, int runs) {
    std::vector<std::unique_ptr<Engine>> engines;
    for (int i = 0; i < runs; ++i) engines.push_back(contestant.start(contestant, task));
    auto const before = std::chrono::steady_clock::now();
    for (auto const& engine : engines) engine->positions_at(times);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count() / runs;
}

double least_seconds(Contestant const& contestant, Task const& task, std::vector<double> const& times,
                     Effort const& effort) {
    double least = seconds_for(contestant, task, times, 1);
    int const runs = std::clamp(static_cast<int>(batch / least), 1, largest_batch);
    double spent = least;
    for (int i = 1; i < effort.repeats && spent < effort.patience; ++i) {
        double const seconds = seconds_for(contestant, task, times, runs);
        least = std::min(least, seconds);
        spent += seconds * runs;
    }
    return least;
}

}  // namespace

Errors errors_of(Contestant const& contestant, std::vector<Start> const& starts) {
    std::vector<double> errors;
    for (Start const& start : starts) errors.push_back(error_of(contestant, start));
    std::sort(errors.begin(), errors.end());
    auto const place = [&](double share) {
        return errors[static_cast<std::size_t>(std::ceil(share * static_cast<double>(errors.size()))) - 1];
    };
    return {or_nan(place(0.5)), or_nan(place(0.95)),
            static_cast<int>(std::count(errors.begin(), errors.end(), physics::never))};
}

Costs costs_of(Contestant const& contestant, Task const& task, Effort const& effort) {
    double const scale = 1e9 / task.duration;
    return {least_seconds(contestant, task, frame_times(task.duration), effort) * scale,
            least_seconds(contestant, task, {frame_times(task.duration).back()}, effort) * scale};
}

}  // namespace bench
