#include "bench_population.h"

#include <cmath>
#include <random>

#include "bench_truth.h"
#include "geometry/elementary.h"

namespace bench {

namespace {

using geometry::Arc;
using geometry::pi;
using geometry::Segment;
using physics::Ball;
using physics::Material;
using physics::Piece;
using physics::Scene;

class Dice {
public:
    explicit Dice(unsigned seed) : source_(seed) {}
    double between(double low, double high) { return low + (high - low) * (source_() / 4294967296.0); }
    // Every order of magnitude is as likely as every other.
    double scale_between(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
    int count_between(int low, int high) { return static_cast<int>(between(low, high + 1.0)); }

private:
    std::mt19937 source_;
};

Ball ball_at(Vec2 const& position, double radius = 0.5) {
    Ball ball;
    ball.radius = radius;
    ball.start.position = position;
    return ball;
}

Scene scene_of(std::vector<Piece> pieces, std::vector<Ball> balls) {
    Scene scene;
    scene.terrain = physics::terrain_of(std::move(pieces));
    scene.balls = std::move(balls);
    return scene;
}

Member incline(Dice& dice) {
    double const slope = dice.between(0.03, 0.7), length = 2000;
    Vec2 const down(std::cos(slope), -std::sin(slope)), normal(std::sin(slope), std::cos(slope));
    Segment const line{-100 * down, length * down};
    Ball ball = ball_at(0.5 * normal);
    ball.inertia = dice.between(0.3, 1);
    ball.start.velocity = dice.between(0, 10) * down;
    ball.start.spin = dice.between(-10, 10);
    Member member{"incline", {scene_of({{line, {dice.between(0.05, 1.2), 0, 0}, 0}}, {ball}), {}, 6}, {}};
    member.truth = truth_on_line(member.task, line);
    return member;
}

Member bounces(Dice& dice) {
    double const e = dice.between(0.2, 0.95);
    Ball const ball = ball_at({0, 0.5 + dice.between(0.2, 5)});
    Member member{"bounces", {scene_of({{Segment{{-100, 0}, {100, 0}}, {0.9, e, 0}, 0}}, {ball}), {}, 6}, {}};
    member.truth = truth_of_bounces(member.task, 0, e);
    return member;
}

Member valley(Dice& dice) {
    Arc const arc{{0, 0}, dice.between(1.5, 8), pi, pi};
    double const phi = 1.5 * pi + dice.between(-1.2, 1.2);
    Ball ball = ball_at((arc.radius - 0.5) * Vec2(std::cos(phi), std::sin(phi)));
    ball.inertia = dice.between(0.3, 1);
    Member member{"valley", {scene_of({{arc, {INFINITY, 0, 0}, 0}}, {ball}), {}, 6}, {}};
    member.truth = truth_on_circle(member.task, arc);
    return member;
}

Member hill(Dice& dice) {
    Arc const arc{{0, 0}, dice.between(2, 10), pi, -pi};
    double const phi = pi / 2 - dice.between(0.05, 0.4);
    Ball const ball = ball_at((arc.radius + 0.5) * Vec2(std::cos(phi), std::sin(phi)));
    Member member{"hill", {scene_of({{arc, {INFINITY, 0, 0}, 0}}, {ball}), {}, 3}, {}};
    member.truth = truth_on_circle(member.task, arc);
    return member;
}

Member spring(Dice& dice) {
    Member member{"spring", {scene_of({}, {ball_at({0, 0})}), physics::Pull{0, {dice.between(0.2, 4), 0}}, 4}, {}};
    member.task.scene.drag = {dice.scale_between(0.5, 30), dice.between(0.02, 1.5)};
    member.truth = truth_on_spring(member.task);
    return member;
}

Member wall(Dice& dice) {
    double const speed = dice.scale_between(1, 1000);
    Ball ball = ball_at({0, 0});
    ball.start.velocity = {speed, 0};
    Member member{"wall", {scene_of({{Segment{{4, -9}, {4, 9}}, {0, 1, 0}, 0}}, {ball}), {}, 4}, {}};
    member.task.scene.gravity = 0;
    member.truth = truth_at_wall(member.task, 4);
    return member;
}

Member blows(Dice& dice) {
    int const count = dice.count_between(2, 6);
    double const e = dice.between(0.2, 1);
    Scene scene;
    scene.gravity = 0;
    for (int i = 0; i < count; ++i) {
        Ball ball = ball_at({i * 1.5, 0});
        ball.mass = dice.between(0.5, 2);
        ball.friction = 0;
        ball.restitution = e;
        if (i == 0) ball.start.velocity = {dice.between(1, 5), 0};
        scene.balls.push_back(ball);
    }
    Member member{"blows", {scene, {}, 4}, {}};
    member.truth = truth_of_blows(member.task, e);
    return member;
}

Member chords(Dice& dice) {
    Member member = valley(dice);
    int const pieces = static_cast<int>(dice.scale_between(16, 2048));
    member.kind = "chords";
    member.task.scene = in_pieces(member.task.scene, pieces);
    member.truth.reset();
    return member;
}

// Ground that goes up and down in straight pieces between two walls.
std::vector<Piece> ground(Dice& dice, Material const& material) {
    std::vector<Piece> pieces;
    Vec2 from(0, 8);
    for (double x = 0; x < 30;) {
        x += dice.between(0.5, 4);
        Vec2 const to(x, dice.between(0, 2));
        pieces.push_back({Segment{from, to}, material, 0});
        from = to;
    }
    pieces.push_back({Segment{from, from + Vec2(0, 8)}, material, 0});
    return pieces;
}

Material some_material(Dice& dice) {
    return {dice.between(0.2, 1.2), dice.between(0, 1) < 0.5 ? 0 : dice.between(0.1, 0.9),
            dice.between(0, 1) < 0.7 ? 0 : dice.between(0, 0.05)};
}

Member track(Dice& dice) {
    Ball ball = ball_at({dice.between(8, 20), 4});
    ball.start.velocity = {dice.between(-5, 5), 0};
    return {"track", {scene_of(ground(dice, some_material(dice)), {ball}), {}, 6}, {}};
}

Member pulled(Dice& dice) {
    Member member = track(dice);
    member.kind = "pulled";
    member.task.scene.drag = {dice.scale_between(0.5, 10), dice.between(0.1, 1.2)};
    member.task.pull = physics::Pull{0, {dice.between(8, 20), dice.between(1, 4)}};
    return member;
}

Member some_few(int count, Dice& dice) {
    Member member = track(dice);
    member.kind = "few";
    for (int i = 1; i < count; ++i) {
        Ball ball = ball_at({8 + 1.5 * i, 6 + 0.1 * i});
        ball.start.velocity = {dice.between(-5, 5), 0};
        member.task.scene.balls.push_back(ball);
    }
    return member;
}

Member few(Dice& dice) { return some_few(dice.count_between(2, 8), dice); }

Member some_gas(int side, Dice& dice) {
    double const width = 2.5 * side;
    Material const wall{0, 1, 0};
    Scene scene = scene_of({{Segment{{0, 0}, {width, 0}}, wall, 0},
                            {Segment{{width, 0}, {width, width}}, wall, 0},
                            {Segment{{width, width}, {0, width}}, wall, 0},
                            {Segment{{0, width}, {0, 0}}, wall, 0}},
                           {});
    scene.gravity = 0;
    for (int i = 0; i < side * side; ++i) {
        Ball ball = ball_at({1.25 + 2.5 * (i % side), 1.25 + 2.5 * (i / side)});
        ball.friction = 0;
        ball.restitution = 1;
        ball.start.velocity = {dice.between(-3, 3), dice.between(-3, 3)};
        scene.balls.push_back(ball);
    }
    return {"gas", {scene, {}, 4}, {}};
}

Member gas(Dice& dice) { return some_gas(dice.count_between(2, 8), dice); }

}  // namespace

Task without_idle_spring(Task task) {
    if (!task.pull) task.scene.drag.frequency = 0;
    return task;
}

Member few_of(int count, unsigned seed) {
    Dice dice(seed);
    Member member = some_few(count, dice);
    member.task = without_idle_spring(member.task);
    return member;
}

Member gas_of(int side, unsigned seed) {
    Dice dice(seed);
    Member member = some_gas(side, dice);
    member.task = without_idle_spring(member.task);
    return member;
}

std::vector<Member> population(unsigned seed, int count) {
    using Kind = Member (*)(Dice&);
    Kind const kinds[] = {incline, bounces, valley, hill, spring, wall, blows, chords, track, pulled, few, gas};
    Dice dice(seed);
    std::vector<Member> members;
    for (int i = 0; i < count; ++i) {
        members.push_back(kinds[static_cast<std::size_t>(i) % std::size(kinds)](dice));
        members.back().task = without_idle_spring(members.back().task);
    }
    return members;
}

}  // namespace bench
