#include "level/starts.h"

#include <algorithm>
#include <cmath>

namespace level {

using geometry::Box;
using geometry::Vec2;
using physics::Ball;

namespace {

constexpr double rounding = 1e-9;    // of a depth: five per cent as drawn is five per cent
constexpr int enough_faults = 1000;  // thousands of balls in one place have millions of pairs

Box box_around(Ball const& ball, double margin) {
    Vec2 const reach = Vec2::Constant(ball.radius + margin);
    return {ball.start.position - reach, ball.start.position + reach};
}

// The point of the terrain nearest to a ball's centre among what lies within its radius.
geometry::Nearest nearest_terrain(physics::Terrain const& terrain, Ball const& ball) {
    geometry::Nearest nearest;
    nearest.distance = ball.radius;
    terrain.tree.each_overlapping(box_around(ball, 0), [&](int piece) {
        auto const here = geometry::nearest_point(terrain.pieces[piece].curve, ball.start.position);
        if (here.distance < nearest.distance) nearest = here;
    });
    return nearest;
}

// Every ball's neighbours: those within reach even after slight moves.
std::vector<std::vector<int>> neighbours_of(std::vector<Ball> const& balls) {
    std::vector<Box> boxes;
    for (Ball const& ball : balls) boxes.push_back(box_around(ball, 2 * slight_overlap * ball.radius));
    geometry::BoxTree const tree(boxes);
    std::vector<std::vector<int>> neighbours(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        tree.each_overlapping(boxes[i], [&](int j) {
            if (j != static_cast<int>(i)) neighbours[i].push_back(j);
        });
        std::sort(neighbours[i].begin(), neighbours[i].end());
    }
    return neighbours;
}

double depth_between(Ball const& a, Ball const& b) {
    return a.radius + b.radius - geometry::length(a.start.position - b.start.position);
}

class Mover {
public:
    explicit Mover(physics::Scene const& scene)
        : terrain_(scene.terrain), balls_(scene.balls), neighbours_(neighbours_of(balls_)) {}

    std::vector<Ball> moved(std::vector<Overlap> const& overlaps) {
        std::vector<bool> restless(balls_.size());
        for (Overlap const& overlap : overlaps) restless[overlap.ball] = true;
        // Between two walls at an angle a each move leaves cos(a) of the depth, and between parallel ones all of it:
        // a notch of two degrees takes 3e4 moves, a second at most is spent.
        constexpr int usual_rounds = 500;
        constexpr std::ptrdiff_t most_moves = 1'000'000;
        std::ptrdiff_t moves = 0;
        for (int round = 0; round < usual_rounds || moves < most_moves; ++round) {
            std::ptrdiff_t const restless_balls = std::count(restless.begin(), restless.end(), true);
            if (restless_balls == 0) break;
            moves += restless_balls;
            restless = next_round(restless);
        }
        return std::move(balls_);
    }

private:
    std::vector<bool> next_round(std::vector<bool> const& restless) {
        std::vector<bool> next(balls_.size());
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (!restless[i]) continue;
            Vec2 const before = balls_[i].start.position;
            leave_balls(static_cast<int>(i), next);
            leave_terrain(balls_[i]);
            if (balls_[i].start.position == before) continue;
            next[i] = true;
            for (int const j : neighbours_[i]) next[j] = true;
        }
        return next;
    }

    void leave_terrain(Ball& ball) const {
        geometry::Nearest const nearest = nearest_terrain(terrain_, ball);
        bool const overlaps = ball.radius - nearest.distance > touching && nearest.distance > 0;
        if (!overlaps) return;
        Vec2 const normal = (ball.start.position - nearest.point) / nearest.distance;
        ball.start.position = nearest.point + ball.radius * normal;
    }

    void leave_balls(int i, std::vector<bool>& next) {
        for (int const j : neighbours_[i]) {
            double const depth = depth_between(balls_[i], balls_[j]);
            Vec2 const apart = balls_[i].start.position - balls_[j].start.position;
            double const distance = geometry::length(apart);
            if (depth <= touching || distance == 0) continue;
            Vec2 const move = apart * (depth / 2 / distance);
            balls_[i].start.position += move;
            balls_[j].start.position -= move;
            next[j] = true;
        }
    }

    physics::Terrain const& terrain_;
    std::vector<Ball> balls_;
    std::vector<std::vector<int>> neighbours_;
};

}  // namespace

std::vector<Overlap> overlaps_in(physics::Scene const& scene) {
    std::vector<Overlap> overlaps;
    std::vector<Ball> const& balls = scene.balls;
    int deep = 0;
    auto const note = [&](int ball, int other, double depth, double radius) {
        if (!(depth > touching)) return;
        overlaps.push_back({ball, other, depth, depth <= slight_overlap * radius * (1 + rounding)});
        deep += !overlaps.back().slight;
    };
    int const count = static_cast<int>(balls.size());
    for (int i = 0; i < count && deep < enough_faults; ++i)
        note(i, -1, balls[i].radius - nearest_terrain(scene.terrain, balls[i]).distance, balls[i].radius);
    std::vector<Box> boxes;
    for (Ball const& ball : balls) boxes.push_back(box_around(ball, 0));
    geometry::BoxTree const tree(boxes);
    for (int i = 0; i < count && deep < enough_faults; ++i)
        tree.each_overlapping(boxes[i], [&](int j) {
            if (j < i) note(i, j, depth_between(balls[i], balls[j]), std::min(balls[i].radius, balls[j].radius));
        });
    return overlaps;
}

std::vector<Ball> moved_out(physics::Scene const& scene, std::vector<Overlap> const& overlaps) {
    return Mover(scene).moved(overlaps);
}

}  // namespace level
