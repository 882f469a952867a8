#include "physics/world/overlap.h"

#include <algorithm>
#include <numeric>

namespace physics {

namespace {

double overlap_with_terrain(Terrain const& terrain, double radius, Vec2 const& centre) {
    double deepest = 0;
    Vec2 const reach = Vec2::Constant(radius);
    terrain.tree.each_overlapping({centre - reach, centre + reach}, [&](int piece) {
        deepest = std::max(deepest, radius - nearest_point(terrain.pieces[piece].curve, centre).distance);
    });
    return deepest;
}

// From left to right: a ball meets those that begin before it ends.
double overlap_of_balls(std::vector<Ball> const& balls, std::vector<Vec2> const& centres) {
    auto const left = [&](int i) { return centres[i].x() - balls[i].radius; };
    std::vector<int> order(balls.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
    double deepest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        int const a = order[i];
        double const right = centres[a].x() + balls[a].radius;
        for (std::size_t j = i + 1; j < order.size() && left(order[j]) < right; ++j) {
            int const b = order[j];
            double const distance = geometry::length(centres[b] - centres[a]);
            deepest = std::max(deepest, balls[a].radius + balls[b].radius - distance);
        }
    }
    return deepest;
}

}  // namespace

double deepest_overlap(Scene const& scene, std::vector<Vec2> const& centres) {
    double deepest = overlap_of_balls(scene.balls, centres);
    for (std::size_t i = 0; i < centres.size(); ++i)
        deepest = std::max(deepest, overlap_with_terrain(scene.terrain, scene.balls[i].radius, centres[i]));
    return deepest;
}

}  // namespace physics
