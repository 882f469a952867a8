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
    to << "# error of a unit step over " << frames << " frames of 1/60 s, in parts of its height; stable 1 or 0\n"
       << "# method\tfrequency\tdamping\terror\tstable\n";
    for (Contestant const& contestant : contestants) {
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
