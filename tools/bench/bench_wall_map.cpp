#include <cmath>
#include <iostream>

#include "bench_maps.h"

namespace bench {

namespace {

constexpr double near_face = 10;              // m
constexpr double clearance = 3;               // m, from the ball's rim to the wall
constexpr double slowest = 1, fastest = 1e5;  // m/s
constexpr double thickest = 2;                // m
constexpr int phases = 8;                     // starts that reach the wall at different parts of a step
constexpr int frames_after = 20;

physics::Piece face_at(double x) { return {geometry::Segment{{x, -50}, {x, 50}}, {0.9, 0, 0}, 0}; }

// A ball on its way to a wall of two faces; a wall without thickness has one.
Task task_of(double speed, double thickness, int phase) {
    Task task;
    task.scene.gravity = 0;
    std::vector<physics::Piece> faces = {face_at(near_face)};
    if (thickness > 0) faces.push_back(face_at(near_face + thickness));
    task.scene.terrain = physics::terrain_of(std::move(faces));
    physics::Ball ball;
    double const head_start = speed / frames_per_second * phase / phases;
    ball.start.position = {near_face - ball.radius - clearance - head_start, 0};
    ball.start.velocity = {speed, 0};
    task.scene.balls = {ball};
    task.duration = std::ceil((clearance + head_start) / speed * frames_per_second + frames_after) / frames_per_second;
    return task;
}

bool gets_through(Contestant const& contestant, Task const& task) {
    auto const positions = contestant.start(contestant, task)->positions_at({frame_times(task.duration).back()});
    return positions.empty() || !(positions.back().x() < near_face);
}

}  // namespace

void map_walls(std::vector<Contestant> const& contestants, int columns, int rows, std::ostream& to) {
    to << "# share of " << phases << " balls that get into or through a wall, at 60 steps a second\n"
       << "# method\tspeed\tthickness\tshare\n";
    for (Contestant const& contestant : contestants) {
        std::cerr << "wall map: " << contestant.method << '\n';
        for (int column = 0; column < columns; ++column) {
            double const speed = slowest * std::pow(fastest / slowest, (column + 0.5) / columns);
            for (int row = 0; row < rows; ++row) {
                double const thickness = thickest * row / (rows - 1);
                int through = 0;
                for (int phase = 0; phase < phases; ++phase)
                    through += gets_through(contestant, task_of(speed, thickness, phase)) ? 1 : 0;
                to << contestant.method << '\t' << speed << '\t' << thickness << '\t'
                   << static_cast<double>(through) / phases << '\n';
            }
            to << '\n';
        }
        to << '\n';
    }
}

}  // namespace bench
