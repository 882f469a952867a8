#include <cmath>

#include "bench_part.h"
#include "geometry/elementary.h"

namespace bench {

namespace {

constexpr double duration = 4;  // s

struct Needy {
    std::string name;
    Task task;
};

physics::Ball ball_at(Vec2 const& position, Vec2 const& velocity = Vec2::Zero(), double spin = 0) {
    physics::Ball ball;
    ball.start = {position, velocity, 0, spin};
    return ball;
}

physics::Ball rolling(double x, double speed) { return ball_at({x, 0.5}, {speed, 0}, -2 * speed); }

Needy needy(std::string const& name, std::vector<physics::Ball> balls, std::vector<physics::Piece> pieces = {}) {
    Needy made{name, {}};
    made.task.duration = duration;
    made.task.scene.balls = std::move(balls);
    if (!pieces.empty()) made.task.scene.terrain = physics::terrain_of(std::move(pieces));
    return made;
}

physics::Piece floor_of(physics::Material const& material) {
    return {geometry::Segment{{-200, 0}, {200, 0}}, material, 0};
}

// 60 degrees up an arc of 4 m about (0, 4), on the left or the right.
Vec2 high_on_the_arc(double side) { return {side * 3.5 * std::sqrt(0.75), 4 - 3.5 / 2}; }

// A floor that bends up into a quarter of a circle, down which a ball rolls at one that is dragged.
Needy everything() {
    physics::Material const rough{0.3, 0.5, 0.02};
    Needy all = needy("everything", {rolling(-3, 0), ball_at(high_on_the_arc(1)), ball_at({-1, 2})},
                      {{geometry::Segment{{-200, 0}, {0, 0}}, rough, 0},
                       {geometry::Arc{{0, 4}, 4, -geometry::pi / 2, geometry::pi / 2}, rough, 0}});
    all.task.pull = physics::Pull{0, {-6, 2}};
    return all;
}

std::vector<Needy> all_needs() {
    physics::Material const plain{0.9, 0, 0};
    std::vector<Needy> needs = {
        needy("flight alone", {ball_at({0, 0}, {2, 15})}),
        needy("a line", {rolling(0, 3)}, {floor_of(plain)}),
        needy("bounces", {ball_at({0, 1.5}, {1, 0})}, {floor_of({0.9, 0.8, 0})}),
        needy("slip", {ball_at({0, 0.5}, {8, 0})}, {floor_of({0.1, 0, 0})}),
        needy("resistance", {rolling(0, 3)}, {floor_of({0.9, 0, 0.02})}),
        needy("drag", {rolling(0, 0)}, {floor_of(plain)}),
        needy("an arc", {ball_at(high_on_the_arc(-1))},
              {{geometry::Arc{{0, 4}, 4, -geometry::pi, geometry::pi}, plain, 0}}),
        needy("a pair", {rolling(-3, 2), rolling(3, -2)}, {floor_of(plain)}),
        everything(),
    };
    needs[5].task.pull = physics::Pull{0, {3, 0.5}};
    return needs;
}

std::vector<Contestant> ours_but_article() {
    std::vector<Contestant> contestants;
    for (Contestant const& ours : our_methods({240}))
        if (ours.pieces == 0 && ours.method != "article") contestants.push_back(ours);
    return contestants;
}

}  // namespace

Part needs_part(Effort const& effort) {
    Part part;
    for (Needy const& need : all_needs())
        for (Contestant const& contestant : ours_but_article())
            part.benchmarks.push_back(sampled_run("needs/" + need.name, contestant, need.task, effort));
    part.write = [benchmarks = part.benchmarks](Times const& times, Tables const& tables) {
        std::ofstream to = tables.open("needs.tsv");
        to << "# ns per simulated second, asked 60 times a second; what needs a line has one\n# need";
        for (Contestant const& contestant : ours_but_article()) to << '\t' << contestant.method;
        std::size_t const methods = ours_but_article().size();
        for (std::size_t i = 0; i < benchmarks.size(); ++i) {
            if (i % methods == 0) to << '\n' << all_needs()[i / methods].name;
            to << '\t' << time_in(times, benchmarks[i].name);
        }
        to << '\n';
    };
    return part;
}

}  // namespace bench
