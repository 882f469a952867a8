#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include "bench_maps.h"

namespace bench {

namespace {

constexpr double radius = 0.5;                 // m
constexpr int timed_frames = 20, batches = 4;  // of which the least counts

physics::Piece wall(Vec2 const& from, Vec2 const& to) { return {geometry::Segment{from, to}, {}, 0}; }

// Discs in a bin twice as wide as high, every other row set off so that they do not stand on each other's tops.
physics::Scene pile_of(int count) {
    int const columns = std::max(2, static_cast<int>(std::sqrt(count * 2.0)));
    double const width = 1.05 * columns + 1, height = 2.0 * count / columns + 20;
    physics::Scene scene;
    for (int i = 0; i < count; ++i) {
        physics::Ball ball;
        ball.radius = radius;
        ball.start.position = {1 + 1.05 * (i % columns) + 0.02 * (i / columns % 3), 0.6 + 1.02 * (i / columns)};
        scene.balls.push_back(ball);
    }
    scene.terrain =
        physics::terrain_of({wall({0, 0}, {width, 0}), wall({0, 0}, {0, height}), wall({width, 0}, {width, height})});
    return scene;
}

double deepest_overlap(std::vector<Vec2> positions) {
    std::sort(positions.begin(), positions.end(), [](Vec2 const& a, Vec2 const& b) { return a.x() < b.x(); });
    double deepest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        deepest = std::max(deepest, radius - positions[i].y());
        for (std::size_t j = i; j-- > 0 && positions[i].x() - positions[j].x() < 2 * radius;)
            deepest = std::max(deepest, 2 * radius - geometry::length(positions[i] - positions[j]));
    }
    return deepest;
}

double frame_milliseconds(Pile& pile) {
    double least = physics::never;
    for (int i = 0; i < batches; ++i) {
        auto const before = std::chrono::steady_clock::now();
        for (int frame = 0; frame < timed_frames; ++frame) pile.frame();
        std::chrono::duration<double, std::milli> const span = std::chrono::steady_clock::now() - before;
        least = std::min(least, span.count() / timed_frames);
    }
    return least;
}

struct Heaper {
    std::string method, setting;
    std::unique_ptr<Pile> (*start)(physics::Scene const&) = nullptr;
};

std::vector<Heaper> heapers() {
    return {
        {"steps", "60 Hz",
         [](physics::Scene const& scene) {
             return our_pile(scene, {60, 4});
         }},
        {"steps", "240 Hz",
         [](physics::Scene const& scene) {
             return our_pile(scene, {240, 4});
         }},
#ifdef SMB2D_BOX2D
        {"Box2D", "8 iterations", [](physics::Scene const& scene) { return box2d_pile(scene, 8); }},
        {"Box2D", "32 iterations", [](physics::Scene const& scene) { return box2d_pile(scene, 32); }},
#endif
#ifdef SMB2D_CHIPMUNK
        {"Chipmunk", "10 iterations", [](physics::Scene const& scene) { return chipmunk_pile(scene, 10); }},
        {"Chipmunk", "40 iterations", [](physics::Scene const& scene) { return chipmunk_pile(scene, 40); }},
#endif
    };
}

}  // namespace

void chart_piles(std::vector<int> const& counts, double settling, std::ostream& to) {
    to << "# piles after " << settling << " s, kept awake: milliseconds for 1/60 s, deepest overlap in radii\n"
       << "# method\tsetting\tballs\tmilliseconds\toverlap\n";
    for (Heaper const& heaper : heapers())
        for (int const count : counts) {
            std::cerr << "pile of " << count << ": " << heaper.method << ", " << heaper.setting << '\n';
            auto const pile = heaper.start(pile_of(count));
            for (int i = 0; i < settling * frames_per_second; ++i) pile->frame();
            double const milliseconds = frame_milliseconds(*pile);
            to << heaper.method << '\t' << heaper.setting << '\t' << count << '\t' << milliseconds << '\t'
               << deepest_overlap(pile->positions()) / radius << std::endl;
        }
}

}  // namespace bench
