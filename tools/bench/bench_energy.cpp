#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "bench_maps.h"
#include "geometry/elementary.h"
#include "level/level.h"

namespace bench {

namespace {

// A scene whose energy stays as it is.
struct Swing {
    std::string name;
    Task task;
    double lowest = 0;  // m, the height from which energy is counted
};

Task task_from(std::string const& file, int seconds) {
    Task task;
    task.scene = level::read_level(file).scene;
    task.scene.sensors.clear();
    task.duration = seconds;
    return task;
}

Swing bouncing(std::string const& lab, int seconds) {
    Swing swing{"bounce", task_from(lab + "/bounce.svg", seconds)};
    for (physics::Piece& piece : swing.task.scene.terrain.pieces) piece.material = {0, 1, 0};
    physics::Ball const& ball = swing.task.scene.balls[0];
    swing.lowest = geometry::start_of(swing.task.scene.terrain.pieces[0].curve).y() + ball.radius;
    return swing;
}

Swing on_a_spring(std::string const& lab, int seconds) {
    Swing swing{"spring", task_from(lab + "/drag-soft.svg", seconds)};
    swing.task.scene.drag.damping = 0;
    swing.task.pull = physics::Pull{0, {8, 4.5}};
    return swing;
}

// Inside the scene's first arc, down to its lowest point.
Swing inside(std::string const& name, std::string const& file, int seconds) {
    Swing swing{name, task_from(file, seconds)};
    auto const arc = std::get<geometry::Arc>(swing.task.scene.terrain.pieces[0].curve);
    swing.lowest = arc.centre.y() - arc.radius + swing.task.scene.balls[0].radius;
    return swing;
}

// Per mass: of motion, of height, of turning, of the spring.
double energy_of(Swing const& swing, physics::State const& state) {
    physics::Scene const& scene = swing.task.scene;
    physics::Ball const& ball = scene.balls[0];
    double const rim = ball.radius * state.spin;
    double energy = (state.velocity.squaredNorm() + ball.inertia * rim * rim) / 2 +
                    scene.gravity * (state.position.y() - swing.lowest);
    if (swing.task.pull) {
        double const omega = 2 * geometry::pi * scene.drag.frequency;
        energy += omega * omega * (state.position - swing.task.pull->target).squaredNorm() / 2;
    }
    return energy;
}

void write_changes(Swing const& swing, Contestant const& contestant, std::ostream& to) {
    std::vector<double> const times = frame_times(swing.task.duration);
    auto const states = contestant.start(contestant, swing.task)->states_at(times);
    double const at_first = energy_of(swing, swing.task.scene.balls[0].start);
    for (int second = 0; second < swing.task.duration; ++second) {
        double most = states.size() < times.size() ? std::numeric_limits<double>::infinity() : 0;
        for (int frame = 0; std::isfinite(most) && frame < frames_per_second; ++frame) {
            double const energy = energy_of(swing, states[second * frames_per_second + frame]);
            most = std::max(most, std::abs(energy / at_first - 1));
        }
        to << swing.name << '\t' << contestant.method << '\t' << second + 1 << '\t' << most << '\n';
    }
    to << '\n';
}

}  // namespace

void chart_energy(std::string const& lab, std::vector<Contestant> const& contestants, int seconds, std::ostream& to) {
    to << "# energy that should stay: the largest change within each second, of what there was at first\n"
       << "# scene\tmethod\tsecond\tchange\n";
    for (Swing const& swing :
         {bouncing(lab, seconds), on_a_spring(lab, seconds), inside("valley", lab + "/valley.svg", seconds),
          inside("loop", lab + "/loop.svg", seconds)})
        for (Contestant const& contestant : contestants) {
            std::cerr << "energy, " << swing.name << ": " << contestant.method << '\n';
            write_changes(swing, contestant, to);
        }
}

}  // namespace bench
