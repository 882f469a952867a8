#include "bench_timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <benchmark/benchmark.h>

namespace bench {

namespace {

constexpr double shortest = 2e-4;  // s: shorter runs are repeated until they have taken this long together
constexpr int most_at_once = 64;   // runs that are set up side by side
constexpr char least[] = "least";  // the name of the statistic that counts

std::string scene_of(std::string const& name) { return name.substr(0, name.find('/')); }

// Says on stderr how far the whole has come.
class Teller {
public:
    Teller(std::vector<Timed> const& all, Report report) : report_(report) {
        for (Timed const& timed : all) {
            whole_ += work_of(timed);
            if (scenes_.empty() || scenes_.back() != scene_of(timed.name)) scenes_.push_back(scene_of(timed.name));
        }
    }
    void begin(Timed const& timed) {
        done_ += under_way_;
        under_way_ = work_of(timed);
        auto const place = std::find(scenes_.begin(), scenes_.end(), scene_of(timed.name)) - scenes_.begin();
        auto const now = std::chrono::steady_clock::now();
        if (report_ == Report::nothing || scenes_.size() == 1 ||
            (place == place_ && now - told_at_ < std::chrono::seconds(10)))
            return;
        place_ = place;
        told_at_ = now;
        std::cerr << "scene " << place + 1 << " of " << scenes_.size() << ": " << scenes_[place] << time_left() << '\n';
    }

private:
    static double work_of(Timed const& timed) { return timed.work * timed.repeats; }
    std::string time_left() const {
        std::chrono::duration<double> const spent = std::chrono::steady_clock::now() - start_;
        if (done_ < 0.02 * whole_) return "";
        double const left = spent.count() * (whole_ - done_) / done_;
        return left < 60 ? ", less than a minute left"
                         : ", about " + std::to_string(std::lround(left / 60)) + " min left";
    }

    Report report_;
    std::vector<std::string> scenes_;
    double whole_ = 0, done_ = 0, under_way_ = 0;
    std::ptrdiff_t place_ = -1;
    std::chrono::steady_clock::time_point told_at_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Keeps the least times, and shows all to Google Benchmark's own reporter where its flags are used.
class Keeper : public benchmark::BenchmarkReporter {
public:
    explicit Keeper(Report report)
        : shown_(report == Report::table ? benchmark::CreateDefaultDisplayReporter() : nullptr) {}

    bool ReportContext(Context const& context) override { return !shown_ || shown_->ReportContext(context); }
    void ReportRuns(std::vector<Run> const& runs) override {
        for (Run const& run : runs)
            if (!run.error_occurred && (run.run_type == Run::RT_Iteration || run.aggregate_name == least)) {
                double const time = run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit) * 1e9;
                auto const kept = times.emplace(run.run_name.function_name, time).first;
                kept->second = std::min(kept->second, time);
            }
        if (shown_) shown_->ReportRuns(runs);
    }
    void Finalize() override {
        if (shown_) shown_->Finalize();
    }

    std::map<std::string, double> times;

private:
    std::unique_ptr<benchmark::BenchmarkReporter> shown_;
};

void time_it(benchmark::State& state, Timed const& timed, std::map<std::string, double> const& counters) {
    int const at_once = std::clamp<int>(static_cast<int>(state.max_iterations), 1, most_at_once);
    while (state.KeepRunningBatch(at_once)) state.SetIterationTime(timed.seconds(at_once) / timed.simulated);
    for (auto const& [name, value] : counters) state.counters[name] = value;
}

void add(Timed const& timed, Teller& teller) {
    auto const counters = std::make_shared<std::map<std::string, double>>();
    auto const begun = std::make_shared<bool>(false);
    auto const run = [&timed, &teller, counters, begun](benchmark::State& state) {
        if (!*begun) {
            teller.begin(timed);
            if (timed.counters) *counters = timed.counters();
            *begun = true;
        }
        time_it(state, timed, *counters);
    };
    benchmark::RegisterBenchmark(timed.name.c_str(), run)
        ->UseManualTime()
        ->MinTime(shortest / timed.simulated)
        ->Repetitions(timed.repeats)
        ->DisplayAggregatesOnly(true)
        ->Unit(benchmark::kNanosecond)
        ->ComputeStatistics(
            least, [](std::vector<double> const& times) { return *std::min_element(times.begin(), times.end()); });
}

}  // namespace

void heed_flags(std::vector<std::string> const& flags) {
    static char name[] = "smb2d_bench";  // is kept by its address
    std::vector<std::string> words = flags;
    std::vector<char*> arguments = {name};
    for (std::string& word : words) arguments.push_back(word.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (count > 1) throw std::invalid_argument(std::string(arguments[1]) + ": Google Benchmark has no such flag");
}

std::map<std::string, double> least_times(std::vector<Timed> const& all, Report report) {
    if (all.empty()) return {};
    benchmark::ClearRegisteredBenchmarks();
    Teller teller(all, report);
    for (Timed const& timed : all) add(timed, teller);
    Keeper keeper(report);
    benchmark::RunSpecifiedBenchmarks(&keeper);
    return keeper.times;
}

}  // namespace bench
