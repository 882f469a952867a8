#include "heaps.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace laws {

namespace {

constexpr double half_width = 4, height = 9;  // m

// The same numbers from every library, unlike its distributions.
struct Dice {
    std::mt19937_64 engine;
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
    }
    bool chance(double share) { return between(0, 1) < share; }
};

double floor_height(double x, double rise) { return rise * std::abs(x); }

std::vector<physics::Piece> room(Dice& dice, double rise) {
    physics::Material const of =
        material(dice.chance(0.2) ? full_grip : dice.between(0, 1), dice.chance(0.5) ? 0 : dice.between(0, 1));
    double const corner = floor_height(half_width, rise);
    std::vector<Vec2> points{{-half_width, height}, {-half_width, corner}};
    if (rise > 0) points.push_back({0, 0});
    points.insert(points.end(), {{half_width, corner}, {half_width, height}});
    return ring(points, of);
}

bool is_free(physics::Scene const& scene, Vec2 const& place, double radius, double rise) {
    double const slope = std::sqrt(1 + rise * rise);
    if (std::abs(place.x()) > half_width - radius || place.y() > height - radius) return false;
    if ((place.y() - floor_height(place.x(), rise)) / slope < radius) return false;
    return std::all_of(scene.balls.begin(), scene.balls.end(), [&](physics::Ball const& other) {
        return geometry::length(other.start.position - place) >= other.radius + radius;
    });
}

physics::Ball ball_of(Dice& dice, HeapKind const& kind) {
    physics::Ball ball;
    ball.radius = dice.chance(0.5) ? 0.5 : dice.between(0.2, 0.7);
    ball.mass = std::pow(kind.largest_ratio, dice.chance(0.5) ? std::floor(dice.between(0, 2)) : dice.between(0, 1));
    ball.friction = dice.chance(0.3) ? 0 : dice.between(0, 1);
    ball.restitution = dice.chance(0.3) ? 0 : dice.between(0, 1);
    return ball;
}

// A column on the floor, that touches or stands a little apart, or balls anywhere.
void add_balls(Dice& dice, HeapKind const& kind, double rise, physics::Scene& scene) {
    int const count = kind.most_balls < 2 ? 1 : 2 + static_cast<int>(dice.between(0, kind.most_balls - 1));
    bool const column = dice.chance(0.4), thrown = dice.chance(0.4);
    double const apart = dice.chance(0.5) ? 0 : dice.between(0, 1), lean = dice.chance(0.5) ? 0 : 0.1;
    double top = 0;
    for (int tries = 0; tries < 200 && static_cast<int>(scene.balls.size()) < count; ++tries) {
        physics::Ball ball = ball_of(dice, kind);
        Vec2& place = ball.start.position;
        double const slope = std::sqrt(1 + rise * rise);
        place = {dice.between(-half_width, half_width), dice.between(0, height)};
        if (column) {
            bool const first = scene.balls.empty();
            place = {first ? 0 : dice.between(-lean, lean), top + ball.radius * (first ? slope : 1)};
        }
        if (!is_free(scene, place, ball.radius * (1 - 1e-12), rise)) {
            if (column) top += 0.01;
            continue;
        }
        top = place.y() + ball.radius + apart;
        if (thrown) ball.start.velocity = {dice.between(-15, 15), dice.between(-15, 15)};
        scene.balls.push_back(ball);
    }
}

}  // namespace

Heap heap_of(std::uint64_t seed, HeapKind const& kind) {
    Dice dice{std::mt19937_64(seed)};
    double const rise = dice.chance(0.5) ? 0 : dice.between(0.1, 1.5);
    Heap heap;
    heap.scene = scene_of(room(dice, rise), {});
    add_balls(dice, kind, rise, heap.scene);
    if (!kind.pulled) return heap;
    if (dice.chance(0.5)) heap.scene.drag = {std::pow(10, dice.between(-0.5, 1.5)), dice.between(0, 2)};
    double const reach = dice.chance(0.5) ? 4 : dice.between(0.5, 50);
    int const ball = static_cast<int>(dice.between(0, static_cast<double>(heap.scene.balls.size())));
    for (double time = 0.1; time < 2; time += dice.between(0.05, 0.4)) {
        double const angle = dice.between(0, 2 * pi);
        heap.tugs.push_back({time, ball, Vec2(0, 4) + reach * Vec2(std::cos(angle), std::sin(angle))});
    }
    heap.tugs.push_back({2.2, -1, {}});
    return heap;
}

Heap mirrored(Heap const& heap) {
    auto const over = [](Vec2 const& p) { return Vec2(-p.x(), p.y()); };
    Heap image = heap;
    std::vector<physics::Piece> pieces = heap.scene.terrain.pieces;
    for (physics::Piece& piece : pieces) {
        geometry::Segment& segment = std::get<geometry::Segment>(piece.curve);
        segment = {over(segment.start), over(segment.end)};
    }
    image.scene.terrain = physics::terrain_of(pieces);
    for (physics::Ball& ball : image.scene.balls) {
        ball.start.position = over(ball.start.position);
        ball.start.velocity = over(ball.start.velocity);
        ball.start.spin = -ball.start.spin;
    }
    for (Tug& tug : image.tugs) tug.target = over(tug.target);
    return image;
}

namespace {

// How deep a disc is in the straight walls of a room to whose inside, to the left of each, it belongs, m.
double depth_in(physics::Scene const& scene, Vec2 const& place, double radius) {
    double deepest = 0;
    for (physics::Piece const& piece : scene.terrain.pieces) {
        auto const& [start, end] = std::get<geometry::Segment>(piece.curve);
        Vec2 const along = (end - start) / geometry::length(end - start);
        deepest = std::max(deepest, radius - geometry::cross(along, place - start));
    }
    return deepest;
}

void look(Run const& run, Worst& worst) {
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        double const r = run.scene.balls[i].radius;
        physics::State const state = run.state(static_cast<int>(i));
        worst.finite = worst.finite && is_finite(state);
        worst.depth = std::max(worst.depth, depth_in(run.scene, state.position, r) / r);
        for (std::size_t j = 0; j < i; ++j) {
            double const other = run.scene.balls[j].radius;
            double const apart = geometry::length(state.position - run.state(static_cast<int>(j)).position);
            worst.overlap = std::max(worst.overlap, (r + other - apart) / std::min(r, other));
        }
    }
}

}  // namespace

Worst worst_of(physics::Method const& method, Heap const& heap, double until) {
    Run run(method, heap.scene);
    Worst worst;
    std::size_t next = 0;
    for (int step = 1; step <= until * 240 && worst.finite; ++step) {
        while (next < heap.tugs.size() && heap.tugs[next].time <= run.world.time) {
            Tug const& tug = heap.tugs[next++];
            if (tug.ball < 0)
                run.release();
            else
                run.pull(tug.ball, tug.target);
        }
        run.to(step / 240.0);
        look(run, worst);
        physics::forget_before(run.history, run.world.time);
        run.history.events.clear();
    }
    return worst;
}

}  // namespace laws
