#include "bench_level.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "game/run_file.h"
#include "game/session.h"
#include "level/level.h"
#include "physics/needs.h"

namespace bench {

namespace {

// The best answer that can be had where there is no closed form.
struct Reference {
    std::string method, text;
    double uncertainty = 0;  // m
    std::vector<Moment> truth;
};

// The game without its window.
class Played : public Engine {
public:
    Played(Contestant const& contestant, Task const& task)
        : session_(game::session_of(task.play->level, method_of(contestant), task.play->inputs)) {}

    std::vector<Vec2> positions_at(std::vector<double> const& times) override {
        std::vector<Vec2> positions;
        for (physics::State const& state : states_at(times)) positions.push_back(state.position);
        return positions;
    }
    std::vector<physics::State> states_at(std::vector<double> const& times) override {
        std::vector<physics::State> states;
        int const balls = static_cast<int>(session_.level->scene.balls.size());
        for (double const time : times) {
            game::advance(session_, time);
            for (int ball = 0; ball < balls; ++ball) states.push_back(physics::state_at(session_.history, ball, time));
            game::forget_before(session_, time);
        }
        return states;
    }

private:
    game::Session session_;
};

std::unique_ptr<Engine> played(Contestant const& contestant, Task const& task) {
    return std::make_unique<Played>(contestant, task);
}

Task task_of(LevelWish const& wish) {
    game::Run run;
    run.level_file = wish.file;
    if (game::is_run_file(wish.file)) run = game::read_run(wish.file);
    auto const level = std::make_shared<level::Level const>(level::read_level(run.level_file));
    double const seconds = wish.duration.value_or(run.duration.value_or(10));
    Task task;
    task.scene = level->scene;
    task.duration = std::max(1.0, std::round(seconds * frames_per_second)) / frames_per_second;
    task.play = std::make_shared<Play const>(Play{level, run.inputs});
    return task;
}

std::vector<Contestant> methods_at(std::vector<double> const& rates) {
    std::vector<Contestant> methods;
    for (Contestant const& ours : our_methods(rates))
        if (ours.pieces == 0) methods.push_back(ours);
    for (Contestant& method : methods) method.start = played;
    return methods;
}

Contestant contestant_called(std::string const& method, double rate) {
    for (Contestant const& ours : methods_at({rate}))
        if (ours.method == method) return ours;
    throw std::logic_error(method);
}

std::vector<Moment> answer_of(Contestant const& contestant, Task const& task) {
    auto const positions = contestant.start(contestant, task)->positions_at(frame_times(task.duration));
    std::vector<Moment> answer;
    std::size_t const balls = task.scene.balls.size();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (i % balls == 0) answer.emplace_back();
        answer.back().push_back({positions[i].x(), positions[i].y()});
    }
    return answer;
}

// m; infinite where one of the two gave no answer.
double largest_distance(std::vector<Moment> const& a, std::vector<Moment> const& b) {
    if (a.size() != b.size()) return physics::never;
    long double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a[i].size(); ++k)
            largest = std::max(largest, std::hypot(a[i][k].x - b[i][k].x, a[i][k].y - b[i][k].y));
    return static_cast<double>(largest);
}

// Whether the exact method goes through all of it by itself, and never lets `steps` help it out.
bool exact_suffices(Task const& task) {
    for (physics::Reason const& reason : physics::needs_of(task.scene))
        if (!physics::exact_covers(reason.need)) return false;
    game::Session session = game::session_of(task.play->level, physics::Exact{}, task.play->inputs);
    game::advance(session, task.duration);
    return std::none_of(session.history.events.begin(), session.history.events.end(),
                        [](physics::Event const& event) { return event.kind == physics::EventKind::handover; });
}

std::string metres(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g m", length);
    return text;
}

Reference reference_of(Task const& task) {
    auto const fine = answer_of(contestant_called("steps", finest_rate), task);
    std::string const rate = std::to_string(static_cast<int>(finest_rate)) + " Hz";
    if (exact_suffices(task)) {
        Reference reference{"exact", "", 0, answer_of(contestant_called("exact", 0), task)};
        reference.uncertainty = largest_distance(reference.truth, fine);
        reference.text = "the exact method, with which steps at " + rate + " agree to " + metres(reference.uncertainty);
        return reference;
    }
    Reference reference{"steps", "", 0, fine};
    reference.uncertainty = largest_distance(fine, answer_of(contestant_called("steps", finest_rate / 2), task));
    reference.text = "steps at " + rate + ", as balls lean on each other; half the rate moves it by " +
                     metres(reference.uncertainty);
    return reference;
}

struct Measured {
    Contestant contestant;
    double error = 0;      // m
    bool at_most = false;  // the reference itself: no more is known of its error
    Timed sampled, once;
};

std::vector<Measured> measured_on(Task const& task, Reference const& reference, LevelWish const& wish) {
    Start const start{task, reference.truth};
    std::vector<Measured> all;
    for (Contestant const& contestant : methods_at(wish.rates)) {
        bool const is_reference =
            contestant.method == reference.method && (contestant.rate == 0 || contestant.rate == finest_rate);
        double const error = is_reference ? reference.uncertainty : error_of(contestant, start);
        all.push_back({contestant, error, is_reference, sampled_run("level", contestant, task, wish.effort),
                       unsampled_run("level", contestant, task, wish.effort)});
    }
    return all;
}

void print(Measured const& measured, double nanoseconds, std::ostream& to) {
    char text[160];
    std::string const error = std::isfinite(measured.error)
                                  ? (measured.at_most ? "at most " : "") + metres(measured.error)
                                  : std::string("failed");
    std::snprintf(text, sizeof text, "%-8s %-9s %18s %12.2f\n", measured.contestant.method.c_str(),
                  measured.contestant.setting.c_str(), error.c_str(), nanoseconds / 1e3);
    to << text;
}

}  // namespace

void measure_level(LevelWish const& wish, Tables const& tables, std::ostream& to) {
    Task const task = task_of(wish);
    Reference const reference = reference_of(task);
    std::vector<Measured> const all = measured_on(task, reference, wish);
    std::vector<Timed> benchmarks;
    for (Measured const& measured : all) benchmarks.insert(benchmarks.end(), {measured.sampled, measured.once});
    Times const times = least_times(benchmarks, wish.report);

    std::ofstream about = tables.open("level_reference.tsv"), table = tables.open("level.tsv");
    about << "# title\treference\tuncertainty in m\tseconds\n"
          << (task.play->level->title.empty() ? wish.file : task.play->level->title) << '\t' << reference.text << '\t'
          << reference.uncertainty << '\t' << task.duration << '\n';
    table << "# largest error in m (nan: failed; of the reference itself: its uncertainty), costs in ns per simulated "
             "second\n# method\tsetting\trate\terror\tsampled\tunsampled\n";
    to << task.duration << " s of " << wish.file << "\nreference: " << reference.text
       << "\nmethod   setting       largest error   µs a second\n";
    for (Measured const& measured : all) {
        double const sampled = time_in(times, measured.sampled.name);
        table << measured.contestant.method << '\t' << measured.contestant.setting << '\t' << measured.contestant.rate
              << '\t' << (std::isfinite(measured.error) ? measured.error : std::nan("")) << '\t' << sampled << '\t'
              << time_in(times, measured.once.name) << '\n';
        print(measured, sampled, to);
    }
}

}  // namespace bench
