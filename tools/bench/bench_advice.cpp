#include "bench_advice.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>

#include "bench_heaper.h"
#include "bench_population.h"
#include "level/level.h"

namespace bench {

namespace {

using physics::Experience;
using physics::Forecast;
using physics::PileExperience;
using physics::Sketch;

constexpr double between = 0.37;  // of a frame: where else than at frames an answer is compared

Contestant contestant_of(physics::Method const& method) {
    auto const* steps = std::get_if<physics::Steps>(&method);
    for (Contestant const& ours : our_methods({steps ? steps->rate : 60}))
        if (ours.pieces == 0 && ours.method == physics::name_of(method)) return ours;
    throw std::logic_error("no contestant for a method");
}

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

double cost_of(physics::Method const& method, Task const& task, Effort const& effort) {
    return costs_of(contestant_of(method), task, effort).sampled;
}

// Where a scene's balls are, at frames and between them.
struct Known {
    std::vector<Vec2> at_frames, between_frames;
    double uncertainty = 0;  // m
};

// At frames the closed form where there is one; else and between them the exact method, doubted by as much as a fine
// stepping method, which shares no equation of motion in time with it, says otherwise.
Known known_of(Member const& member) {
    constexpr double finest = 7680;
    Known known{answers_of(physics::Exact{}, member.task, 0), answers_of(physics::Exact{}, member.task, between), 0};
    if (member.truth) {
        std::vector<Vec2> const truth = rounded(*member.truth);
        known.uncertainty = largest_distance(known.at_frames, truth);
        known.at_frames = truth;
    } else {
        known.uncertainty = largest_distance(known.at_frames, answers_of(physics::Steps{finest}, member.task, 0));
    }
    return known;
}

double error_of(physics::Method const& method, Task const& task, Known const& known) {
    return std::max(largest_distance(answers_of(method, task, 0), known.at_frames),
                    largest_distance(answers_of(method, task, between), known.between_frames));
}

// The value below which this share of them lies.
double place_in(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    auto const last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::lround(share * last))];
}

double median_of(std::vector<double> const& values) { return place_in(values, 0.5); }

constexpr double slow = 60, fast = 960;  // steps/s, between which costs are taken to lie on a line
constexpr int starts_to_learn = 8;

struct Lessons {
    std::vector<Member> alone;    // the scenes of the lab, several starts of each
    std::vector<Member> pieces;   // arcs in pieces
    std::vector<Member> crowded;  // gases
    std::vector<Member> leaning;  // balls that come to rest on each other
};

// A spring that nobody pulls at is no part of a scene.
Task without_idle_spring(Task task) {
    if (!task.pull) task.scene.drag.frequency = 0;
    return task;
}

Lessons lessons_from(std::string const& lab) {
    Lessons lessons;
    for (Case const& scene : cases_in(lab)) {
        for (int i = 0; i < starts_to_learn; ++i) {
            Start const start = scene.start(i);
            lessons.alone.push_back({scene.name, without_idle_spring(start.task), start.truth});
        }
        if (!scene.arcs) continue;
        for (int const pieces : {32, 128, 512}) {
            Task task = without_idle_spring(scene.start(0).task);
            task.scene = in_pieces(task.scene, pieces);
            task.duration = std::min(task.duration, 4.0);
            lessons.pieces.push_back({scene.name, task, {}});
        }
    }
    for (int const side : {3, 5, 7}) lessons.crowded.push_back(gas_of(side, 1));
    for (int const count : {3, 4, 5, 6, 7, 8}) lessons.leaning.push_back(few_of(count, static_cast<unsigned>(count)));
    return lessons;
}

void learn_costs(Lessons const& lessons, Effort const& effort, Experience& seen) {
    std::vector<double> exact, frame, step, joint, crowd, pair, lean;
    for (std::size_t i = 0; i < lessons.alone.size(); i += starts_to_learn) {
        Task const& task = lessons.alone[i].task;
        double const balls = static_cast<double>(task.scene.balls.size());
        double const at_slow = cost_of(physics::Steps{slow}, task, effort) / balls;
        double const at_fast = cost_of(physics::Steps{fast}, task, effort) / balls;
        exact.push_back(cost_of(physics::Exact{}, task, effort) / balls);
        step.push_back((at_fast - at_slow) / (fast - slow));
        frame.push_back(std::max(0.0, at_slow - slow * step.back()) / frames_per_second);
    }
    seen.exact_ball = median_of(exact);
    seen.steps_frame = median_of(frame);
    seen.steps_step = median_of(step);
    for (Member const& lesson : lessons.pieces) {
        Sketch const sketch = physics::sketch_of(lesson.task.scene);
        double const plain = seen.steps_frame * frames_per_second + seen.steps_step * slow;
        joint.push_back((cost_of(physics::Exact{}, lesson.task, effort) - seen.exact_ball) /
                        (sketch.speed * sketch.ends));
        crowd.push_back((cost_of(physics::Steps{slow}, lesson.task, effort) / plain - 1) /
                        (sketch.radius * sketch.ends));
    }
    seen.exact_joint = std::max(0.0, median_of(joint));
    seen.steps_crowd = std::max(0.0, median_of(crowd));
    for (Member const& lesson : lessons.crowded) {
        double const balls = static_cast<double>(lesson.task.scene.balls.size());
        pair.push_back((cost_of(physics::Exact{}, lesson.task, effort) - balls * seen.exact_ball) /
                       (balls * (balls - 1) / 2));
    }
    seen.exact_pair = std::max(0.0, median_of(pair));
    seen.exact_lean = 0;
    for (Member const& lesson : lessons.leaning) {
        physics::Scene const& scene = lesson.task.scene;
        double const balls = static_cast<double>(scene.balls.size());
        lean.push_back((cost_of(physics::Exact{}, lesson.task, effort) - physics::forecasts_for(scene, seen)[0].cost) /
                       balls);
    }
    seen.exact_lean = std::max(0.0, median_of(lean));
}

constexpr double kept = 0.95;  // the share of what was seen, in the scene that is hardest, that a forecast covers

void learn_errors(Lessons const& lessons, Experience& seen) {
    seen.exact_error = seen.sag_error = seen.kink_error = 0;
    std::map<std::string, std::vector<double>> sags, kinks;
    for (bool const meeting : {false, true}) {
        for (Member const& lesson : lessons.alone) {
            Sketch const sketch = physics::sketch_of(lesson.task.scene);
            if (sketch.meets != meeting) continue;
            Known const known = known_of(lesson);
            seen.exact_error = std::max(seen.exact_error, known.uncertainty);
            for (double const rate : {60.0, 240.0, 960.0}) {
                double const error = error_of(physics::Steps{rate}, lesson.task, known);
                double const bent = sketch.acceleration / (rate * rate);
                if (meeting)
                    kinks[lesson.kind].push_back(std::max(0.0, error - seen.sag_error * bent) * rate / sketch.speed);
                else
                    sags[lesson.kind].push_back(error / bent);
            }
        }
        for (auto const& [kind, values] : meeting ? kinks : sags) {
            double& worst = meeting ? seen.kink_error : seen.sag_error;
            worst = std::max(worst, place_in(values, kept));
        }
    }
}

constexpr double settling = 6;  // s

std::vector<PileExperience> learnt_piles() {
    std::vector<PileExperience> all;
    for (double const rate : {60.0, 240.0})
        for (int const balls : {10, 100, 1000}) {
            Settled const pile = settled(balls, {rate, 4}, settling);
            double const radius = pile_of(balls).balls[0].radius;
            all.push_back({rate, static_cast<double>(balls), pile.overlap / radius, pile.cost / balls});
        }
    return all;
}

}  // namespace

Experience experience_from(std::string const& lab, Effort const& effort) {
    Experience seen;
    Lessons const lessons = lessons_from(lab);
    learn_costs(lessons, effort, seen);
    learn_errors(lessons, seen);
    seen.piles = learnt_piles();
    return seen;
}

void write_experience(Experience const& seen, std::ostream& to) {
    to << "// Written by the benchmark, `./tools/charts`; meanings and units are in advice.h.\n"
       << std::setprecision(3)  // costs are no better known
       << ".exact_error = " << seen.exact_error << ",\n.exact_ball = " << seen.exact_ball
       << ",\n.exact_pair = " << seen.exact_pair << ",\n.exact_lean = " << seen.exact_lean
       << ",\n.exact_joint = " << seen.exact_joint << ",\n.steps_frame = " << seen.steps_frame
       << ",\n.steps_step = " << seen.steps_step << ",\n.steps_crowd = " << seen.steps_crowd
       << ",\n.kink_error = " << seen.kink_error << ",\n.sag_error = " << seen.sag_error << ",\n.piles = {\n";
    for (PileExperience const& pile : seen.piles)
        to << "    {" << pile.rate << ", " << pile.balls << ", " << pile.overlap << ", " << pile.cost << "},\n";
    to << "},\n";
}

namespace {

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
        if (steps && steps->rate > 4000) continue;  // dearer than any that the cheapest could be
        double const error = steps ? error_of(forecast.method, member.task, known) : known.uncertainty;
        tried.push_back({forecast.method, error, cost_of(forecast.method, member.task, {1, 5, 2e4})});
    }
    return verdicts_on(member.kind, tried, known.uncertainty, [&](double tolerance) {
        return physics::advice_for(member.task.scene, tolerance, seen).method;
    });
}

std::vector<Verdict> verdicts_on_pile(int balls, Experience const& seen) {
    physics::Scene const scene = pile_of(balls);
    std::vector<Tried> tried;
    for (double const rate : {60.0, 240.0}) {
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
