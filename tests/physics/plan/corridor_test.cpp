// Corridors: what is known of the ground from one bounce or joint to the next changes nothing but the work.
#include <cmath>
#include <random>

#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;

namespace {

double in(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

// A chain of level and of sloping pieces of many lengths, with platforms and posts above it here and there.
std::vector<Piece> ground_of(std::mt19937& random, Material const& material) {
    std::vector<Piece> pieces;
    Vec2 at(-10, in(random, 0, 2));
    while (at.x() < 30) {
        double const slope = random() % 3 == 0 ? in(random, -0.3, 0.3) : 0;
        for (auto count = 1 + random() % 8; count > 0; --count) {
            double const width = std::ldexp(static_cast<double>(1 + random() % 8), -2);
            Vec2 const next = at + Vec2(width, slope * width);
            pieces.push_back(line(at, next, material));
            if (random() % 2 == 0)
                std::swap(std::get<geometry::Segment>(pieces.back().curve).start,
                          std::get<geometry::Segment>(pieces.back().curve).end);
            if (random() % 16 == 0) pieces.push_back(line(next, next + Vec2(0, in(random, -1, 1)), material));
            if (random() % 16 == 0) pieces.push_back(line(at + Vec2(0, 3), at + Vec2(2, 3.5), material));
            at = next;
        }
    }
    return pieces;
}

void forget_corridors(World& world) {
    for (BallPlan& plan : world.plans) plan.corridor = {};
}

// With what it knows of the ground forgotten at each event the ball takes the same way, to the growth of rounding.
void check_forgetful(std::vector<Piece> const& pieces, Ball const& ball, double end, double tolerance) {
    Run knowing = exact_run(pieces, {ball}), looking = knowing;
    // Stopped at each event, it never uses what it then knew.
    auto const next_event = [&] { return std::min(end, looking.world.legs[0].until); };
    for (double time = next_event(); time < end; time = next_event()) {
        forget_corridors(looking.world);
        looking.to(std::max(time, std::nextafter(looking.world.time, end)));
    }
    looking.to(end);
    knowing.to(end);
    REQUIRE(knowing.history.events.size() == looking.history.events.size());
    for (std::size_t i = 0; i < looking.history.events.size(); ++i) {
        Event const& a = knowing.history.events[i];
        Event const& b = looking.history.events[i];
        REQUIRE(a.kind == b.kind);
        REQUIRE(a.contact == b.contact);
        // What is rounding at first has grown at corners by then.
        REQUIRE(a.time == doctest::Approx(b.time).epsilon(tolerance));
    }
    REQUIRE(geometry::length(knowing.state().position - looking.state().position) < 1e-8);
}

}  // namespace

TEST_CASE("with its corridors forgotten all the time a ball takes the same way") {
    std::mt19937 random(7);
    for (int scene = 0; scene < 300; ++scene) {
        Material const material{random() % 4 == 0 ? full_grip : in(random, 0, 1),
                                random() % 2 == 0 ? 0 : in(random, 0, 1), 0};
        Ball const ball = disc(in(random, 0.1, 0.6), {in(random, 0, 15), in(random, 3, 4)},
                               {in(random, -5, 5), in(random, -2, 2)}, in(random, -10, 10));
        check_forgetful(ground_of(random, material), ball, 3, 1e-9);
    }
}

TEST_CASE("so it does in a channel that it all but fills, whose far wall its hops come near or do not") {
    std::mt19937 random(11);
    for (int scene = 0; scene < 200; ++scene) {
        // One after the other, for the same scenes on every compiler.
        double const friction = in(random, 0, 1), restitution = in(random, 0.5, 0.98), angle = in(random, -0.6, 0.6);
        double const radius = in(random, 0.1, 0.6), play = std::pow(10, in(random, -6, -1)),
                     height = in(random, 0, 1) * play;
        double const forwards = in(random, -3, 3), upwards = in(random, 0, 0.1), spin = in(random, -10, 10);
        Material const material{friction, restitution, 0};
        Vec2 const along(std::cos(angle), std::sin(angle)), normal(-std::sin(angle), std::cos(angle));
        Vec2 const far = (2 * radius + play) * normal;
        // A hop that closes at 1e-6 m/s begins earlier or later by 1e-9 s, as its place is rounded.
        check_forgetful({line(-20 * along, 20 * along, material), line(far - 20 * along, far + 20 * along, material)},
                        disc(radius, (radius + height) * normal, forwards * along + upwards * normal, spin), 0.5, 1e-7);
    }
}

TEST_CASE("a ball that rolls up over joints turns and comes back over the same ones") {
    // 20 pieces of a quarter of a metre on a slope of 3:4; v^2/2 (1 + k) = g h, so 3 m/s climb 1.5 * 9 / (2 * 9.81) m.
    Vec2 const along(0.8, 0.6), normal(-0.6, 0.8);
    std::vector<Vec2> joints;
    for (int i = 0; i <= 20; ++i) joints.push_back(0.25 * i * along);
    double const start = 0.125, way = 1.5 * 9 / (2 * 9.81 * 0.6);  // m, along the slope
    Run run = exact_run(chain(joints), {disc(0.5, start * along + 0.5 * normal, 3 * along, -6)});
    run.to(2 * 2 * way / 3);  // up and down again, each at a mean of 1.5 m/s
    int const passed = static_cast<int>(std::floor((start + way) / 0.25));
    CHECK(run.count(EventKind::joint) == 2 * passed);
    CHECK(geometry::length(run.state().position - (start * along + 0.5 * normal)) < 1e-12);
    CHECK(geometry::length(run.state().velocity + 3 * along) < 1e-12);
}
