#include "bench_advice.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>

#include "bench_heaper.h"
#include "bench_known.h"

namespace bench {

namespace {

using physics::Experience;
using physics::PileExperience;
using physics::Sketch;

constexpr double slow = 60, fast = 960;  // steps/s, between which costs are taken to lie on a line
constexpr int starts_to_learn = 8;

struct Lessons {
    std::vector<Member> alone;    // the scenes of the lab, several starts of each
    std::vector<Member> pieces;   // arcs in pieces
    std::vector<Member> crowded;  // gases
    std::vector<Member> leaning;  // balls that come to rest on each other
};

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

std::vector<PileExperience> learnt_piles() {
    std::vector<PileExperience> all;
    for (double const rate : pile_rates)
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

}  // namespace bench
