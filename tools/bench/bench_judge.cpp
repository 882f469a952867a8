#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>

#include "bench_advice.h"
#include "bench_heaper.h"
#include "bench_known.h"
#include "level/level.h"

namespace bench {

namespace {

using physics::Experience;
using physics::Forecast;

constexpr Effort hasty{1, 5, 2e4};      // many scenes are timed, and ratios of a few per cent are no matter
constexpr double highest_tried = 4000;  // steps/s: dearer than any that could be the cheapest
constexpr double tolerances[] = {1e-2, 1e-4, 1e-6, 1e-9};  // m

struct Tried {
    physics::Method method;
    double error = 0;  // m
    double cost = 0;   // ns per simulated second
};

struct Verdict {
    std::string scene;
    double tolerance = 0;
    physics::Method advised;
    bool decidable = true, kept = true;
    double regret = 1;  // cost over that of the cheapest that keeps the tolerance
};

std::vector<Verdict> verdicts_on(std::string const& scene, std::vector<Tried> const& tried, double uncertainty,
                                 std::function<physics::Method(double)> const& advised) {
    std::vector<Verdict> verdicts;
    for (double const tolerance : tolerances) {
        Verdict verdict{scene, tolerance, advised(tolerance)};
        auto const same = [&](Tried const& one) {
            return contestant_of(one.method).setting == contestant_of(verdict.advised).setting;
        };
        auto const chosen = std::find_if(tried.begin(), tried.end(), same);
        double least = physics::never;
        for (Tried const& one : tried)
            if (one.error <= tolerance) least = std::min(least, one.cost);
        verdict.decidable = uncertainty <= tolerance / 2 && std::isfinite(least) && chosen != tried.end();
        if (verdict.decidable) {
            verdict.kept = chosen->error <= tolerance;
            verdict.regret = chosen->cost / least;
        }
        verdicts.push_back(verdict);
    }
    return verdicts;
}

std::vector<Verdict> verdicts_on(Member const& member, Experience const& seen) {
    Known const known = known_of(member);
    std::vector<Tried> tried;
    for (Forecast const& forecast : physics::forecasts_for(member.task.scene, seen)) {
        auto const* steps = std::get_if<physics::Steps>(&forecast.method);
        if (steps && steps->rate > highest_tried) continue;
        double const error = steps ? error_of(forecast.method, member.task, known) : known.uncertainty;
        tried.push_back({forecast.method, error, cost_of(forecast.method, member.task, hasty)});
    }
    return verdicts_on(member.kind, tried, known.uncertainty, [&](double tolerance) {
        return physics::advice_for(member.task.scene, tolerance, seen).method;
    });
}

std::vector<Verdict> verdicts_on_pile(int balls, Experience const& seen) {
    physics::Scene const scene = pile_of(balls);
    std::vector<Tried> tried;
    for (double const rate : pile_rates) {
        Settled const pile = settled(balls, {rate, 4}, settling);
        tried.push_back({physics::Steps{rate}, pile.overlap, pile.cost});
    }
    return verdicts_on("pile", tried, 0,
                       [&](double tolerance) { return physics::advice_for(scene, tolerance, seen).method; });
}

std::vector<Member> levels_in(std::string const& folder) {
    std::vector<Member> members;
    for (auto const& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".svg") continue;
        physics::Scene scene = level::read_level(entry.path().string()).scene;
        scene.sensors.clear();
        members.push_back({"level", without_idle_spring({scene, {}, 6}), {}});
    }
    return members;
}

}  // namespace

void judge_advice(Experience const& seen, std::string const& levels, int scenes, std::ostream& to) {
    constexpr unsigned seed = 2;
    std::vector<Member> members = population(seed, scenes);
    for (Member const& level : levels_in(levels)) members.push_back(level);
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (i % 20 == 0) std::cerr << "advice: scene " << i + 1 << " of " << members.size() << '\n';
        for (Verdict const& verdict : verdicts_on(members[i], seen)) verdicts.push_back(verdict);
    }
    for (int const balls : {20, 60, 400})
        for (Verdict const& verdict : verdicts_on_pile(balls, seen)) verdicts.push_back(verdict);
    to << "# advice on scenes that it was not fitted on; regret: cost over that of the cheapest that keeps the "
          "tolerance\n"
       << "# scene\ttolerance\tadvised\tsetting\tdecidable\tkept\tregret\n";
    std::vector<double> regrets;
    int decided = 0, kept = 0;
    for (Verdict const& verdict : verdicts) {
        to << verdict.scene << '\t' << verdict.tolerance << '\t' << physics::name_of(verdict.advised) << '\t'
           << contestant_of(verdict.advised).setting << '\t' << verdict.decidable << '\t' << verdict.kept << '\t'
           << verdict.regret << '\n';
        if (!verdict.decidable) continue;
        ++decided;
        kept += verdict.kept;
        regrets.push_back(verdict.regret);
    }
    to << "# kept\t" << kept << " of " << decided << "\tundecidable\t" << verdicts.size() - regrets.size()
       << "\tmedian regret\t" << median_of(regrets) << "\t95th percentile\t" << place_in(regrets, 0.95) << '\n';
}

}  // namespace bench
