#include <algorithm>
#include <cmath>
#include <iostream>

#include "bench_heaper.h"
#include "bench_maps.h"

namespace bench {

namespace {

constexpr double ball_radius = 0.5;  // m
constexpr int watched_frames = 60;   // at the end

// `height` equal discs on a floor and one on top that is `ratio` times as heavy, all touching.
physics::Scene column_of(int height, double ratio) {
    physics::Scene scene;
    scene.terrain = physics::terrain_of({{geometry::Segment{{-100, 0}, {100, 0}}, {}, 0}});
    for (int i = 0; i <= height; ++i) {
        physics::Ball ball;
        ball.radius = ball_radius;
        ball.start.position = {0, ball_radius + 2 * ball_radius * i};
        if (i == height) ball.mass = ratio;
        scene.balls.push_back(ball);
    }
    return scene;
}

// m; infinite where a ball has left the column or passed the one below it.
double deepest_in(std::vector<Vec2> const& positions) {
    double deepest = ball_radius - positions[0].y();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!(std::abs(positions[i].x()) < ball_radius)) return physics::never;
        if (i == 0) continue;
        double const rise = positions[i].y() - positions[i - 1].y();
        if (!(rise > 0)) return physics::never;
        deepest = std::max(deepest, 2 * ball_radius - rise);
    }
    return positions[0].y() > 0 ? deepest : physics::never;
}

double deepest_after(PileSolver const& heaper, physics::Scene const& scene, double settling) {
    auto const column = heaper.start(scene);
    int const frames = static_cast<int>(settling * frames_per_second);
    double deepest = 0;
    for (int i = 0; i < frames; ++i) {
        column->frame();
        if (i >= frames - watched_frames) deepest = std::max(deepest, deepest_in(column->positions()));
    }
    return deepest;
}

}  // namespace

void map_stacks(std::vector<int> const& heights, std::vector<double> const& ratios, double settling, std::ostream& to) {
    to << "# columns of equal discs below a heavier one after " << settling
       << " s: deepest overlap in diameters, inf where\n"
       << "# one has fallen through or off\n"
       << "# method\tsetting\theight\tratio\toverlap\tcolumn\trow\n";
    for (PileSolver const& heaper : heapers()) {
        std::cerr << "stack map: " << heaper.method << ", " << heaper.setting << '\n';
        for (std::size_t column = 0; column < heights.size(); ++column) {
            for (std::size_t row = 0; row < ratios.size(); ++row)
                to << heaper.method << '\t' << heaper.setting << '\t' << heights[column] << '\t' << ratios[row] << '\t'
                   << deepest_after(heaper, column_of(heights[column], ratios[row]), settling) / (2 * ball_radius)
                   << '\t' << column << '\t' << row << '\n';
            to << '\n';
        }
        to << '\n';
    }
}

}  // namespace bench
