#include <cmath>
#include <iostream>

#include "bench_maps.h"
#include "bench_truth.h"
#include "geometry/elementary.h"

namespace bench {

namespace {

constexpr int frames = 1000;
constexpr double step_height = 0.1;                             // m: small, as Box2D allows no more than 2 m a step
constexpr double run_away = 10;                                 // times the step's height: no stable spring goes there
constexpr double lowest = 0.5, highest = 60, most_damping = 2;  // Hz, Hz, of critical

// The plain rule that game loops begin with: the spring's force first, then the position. Its bound is known:
// 2 pi f dt < 2 (sqrt(1 + z^2) - z).
class SymplecticEuler : public Engine {
public:
    explicit SymplecticEuler(Task const& task) : task_(task) {}
    std::vector<physics::State> states_at(std::vector<double> const& times) override {
        double const omega = 2 * geometry::pi * task_.scene.drag.frequency, dt = 1.0 / frames_per_second;
        physics::State ball = task_.scene.balls[0].start;
        std::vector<physics::State> states;
        for (std::size_t i = 0; i < times.size(); ++i) {
            ball.velocity += dt * (omega * omega * (task_.pull->target - ball.position) -
                                   2 * task_.scene.drag.damping * omega * ball.velocity);
            ball.position += dt * ball.velocity;
            states.push_back(ball);
        }
        return states;
    }
    std::vector<Vec2> positions_at(std::vector<double> const& times) override {
        std::vector<Vec2> positions;
        for (physics::State const& state : states_at(times)) positions.push_back(state.position);
        return positions;
    }

private:
    Task task_;
};

std::unique_ptr<Engine> symplectic_euler(Contestant const&, Task const& task) {
    return std::make_unique<SymplecticEuler>(task);
}

Task unit_step(double frequency, double damping) {
    Task task;
    task.duration = frames / static_cast<double>(frames_per_second);
    task.scene.gravity = 0;
    task.scene.drag = {frequency, damping};
    task.scene.balls.resize(1);
    task.pull = physics::Pull{0, {step_height, 0}};
    return task;
}

struct Cell {
    double error = 0;  // of the step's height
    bool stable = true;
};
Cell cell_of(Contestant const& contestant, Task const& task, std::vector<Moment> const& truth) {
    auto const positions = contestant.start(contestant, task)->positions_at(frame_times(task.duration));
    Cell cell{1e9, false};
    if (positions.size() != truth.size()) return cell;
    double worst = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        double const error = static_cast<double>(std::abs(positions[i].x() - truth[i][0].x)) / step_height;
        if (!(error < run_away)) return cell;
        worst = std::max(worst, error);
    }
    return {worst, true};
}

}  // namespace

void map_drag(std::vector<Contestant> const& contestants, int columns, int rows, std::ostream& to) {
    std::vector<Contestant> all = contestants;
    all.insert(all.begin(), {"symplectic Euler", "60 Hz", 60, true, 0, symplectic_euler});
    to << "# error of a unit step over " << frames << " frames of 1/60 s, in parts of its height; stable 1 or 0\n"
       << "# method\tfrequency\tdamping\terror\tstable\n";
    for (Contestant const& contestant : all) {
        std::cerr << "drag map: " << contestant.method << '\n';
        for (int column = 0; column < columns; ++column) {
            double const frequency = lowest * std::pow(highest / lowest, (column + 0.5) / columns);
            for (int row = 0; row < rows; ++row) {
                double const damping = most_damping * row / (rows - 1);
                Task const task = unit_step(frequency, damping);
                Cell const cell = cell_of(contestant, task, truth_on_spring(task));
                to << contestant.method << '\t' << frequency << '\t' << damping << '\t' << cell.error << '\t'
                   << cell.stable << '\n';
            }
            to << '\n';
        }
        to << '\n';
    }
}

}  // namespace bench
