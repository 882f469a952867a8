#include "bench_measure.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace bench {

namespace {

double distance(Vec2 const& a, Point const& b) { return static_cast<double>(std::hypot(a.x() - b.x, a.y() - b.y)); }

double or_nan(double error) { return std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN(); }

double seconds_for(Contestant const& contestant, Task const& task, std::vector<double> const& times, int runs) {
    std::vector<std::unique_ptr<Engine>> engines;
    for (int i = 0; i < runs; ++i) engines.push_back(contestant.start(contestant, task));
    auto const before = std::chrono::steady_clock::now();
    for (auto const& engine : engines) engine->positions_at(times);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

Timed run_of(std::string const& name, Contestant const& contestant, Task const& task, std::vector<double> const& times,
             Effort const& effort) {
    double const steps = std::max<double>(contestant.rate, frames_per_second) * task.duration;
    int const repeats = std::clamp(static_cast<int>(effort.most_steps / steps),
                                   std::min(effort.fewest_repeats, effort.repeats), effort.repeats);
    auto const kept = std::make_shared<Task const>(task);
    return {name + '/' + contestant.method + '/' + contestant.setting, task.duration, repeats, steps,
            [contestant, kept, times](int runs) { return seconds_for(contestant, *kept, times, runs); }};
}

// Of all starts. Measuring errors takes no times, so every core may help; the first start goes alone, as engines set up
// what they share then.
std::vector<double> each_error(Contestant const& contestant, std::vector<Start> const& starts) {
    std::vector<double> errors(starts.size());
    errors[0] = error_of(contestant, starts[0]);
    std::atomic<std::size_t> next = 1;
    auto const work = [&] {
        for (std::size_t i = next++; i < starts.size(); i = next++) errors[i] = error_of(contestant, starts[i]);
    };
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
    work();
    helpers.clear();
    return errors;
}

}  // namespace

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
    return worst < way || worst == 0 ? worst : physics::never;
}

Errors errors_of(Contestant const& contestant, std::vector<Start> const& starts) {
    std::vector<double> errors = each_error(contestant, starts);
    std::sort(errors.begin(), errors.end());
    auto const place = [&](double share) {
        return errors[static_cast<std::size_t>(std::ceil(share * static_cast<double>(errors.size()))) - 1];
    };
    return {or_nan(place(0.5)), or_nan(place(0.95)),
            static_cast<int>(std::count(errors.begin(), errors.end(), physics::never))};
}

Timed sampled_run(std::string const& scene, Contestant const& contestant, Task const& task, Effort const& effort) {
    return run_of(scene, contestant, task, frame_times(task.duration), effort);
}

Timed unsampled_run(std::string const& scene, Contestant const& contestant, Task const& task, Effort const& effort) {
    Timed timed = run_of(scene, contestant, task, {frame_times(task.duration).back()}, effort);
    timed.name += "/asked once";
    return timed;
}

Costs costs_of(Contestant const& contestant, Task const& task, Effort const& effort) {
    Timed const sampled = sampled_run("", contestant, task, effort), once = unsampled_run("", contestant, task, effort);
    auto const least = least_times({sampled, once}, Report::nothing);
    return {least.at(sampled.name), least.at(once.name)};
}

}  // namespace bench
