#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "bench_part.h"
#include "geometry/elementary.h"
#include "level/level.h"

namespace bench {

namespace {

// What grows, and one run of somebody at one size.
struct Size {
    std::string what;
    int count = 0;
    Contestant contestant;
    std::string benchmark;
};

// Evenly spread in [-1, 1), the same on every machine.
class Shuffle {
public:
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) / (1ull << 52) - 1;
    }

private:
    std::uint64_t state_ = 1;
};

physics::Piece side(Vec2 const& from, Vec2 const& to) { return {geometry::Segment{from, to}, {0, 1, 0}, 0}; }

// Balls that fly about in a box, 9 m^2 to each, and lose nothing.
Task gas_of(int count) {
    constexpr double room = 3, most_speed = 3;  // m, m/s
    int const columns = static_cast<int>(std::ceil(std::sqrt(count)));
    double const edge = room * columns;
    Task task;
    task.duration = 2;
    task.scene.gravity = 0;
    task.scene.terrain = physics::terrain_of({side({0, 0}, {edge, 0}), side({edge, 0}, {edge, edge}),
                                              side({edge, edge}, {0, edge}), side({0, edge}, {0, 0})});
    Shuffle shuffle;
    for (int i = 0; i < count; ++i) {
        physics::Ball ball;
        ball.friction = 0;
        ball.restitution = 1;
        double const x = room * (i % columns + 0.5 + 0.2 * shuffle.next()), y = room * (i / columns + 0.5);
        double const across = most_speed * shuffle.next();
        ball.start.position = {x, y};
        ball.start.velocity = {across, most_speed * shuffle.next()};
        task.scene.balls.push_back(ball);
    }
    return task;
}

// A ball that flies high above a floor of many pieces.
Task flight_over(int count) {
    constexpr double width = 1000, height = 50;  // m
    Task task;
    task.duration = 2;
    std::vector<physics::Piece> pieces;
    for (int i = 0; i < count; ++i)
        pieces.push_back({geometry::Segment{{width * i / count, 0}, {width * (i + 1) / count, 0}}, {}, i});
    task.scene.terrain = physics::terrain_of(std::move(pieces));
    task.scene.balls.resize(1);
    task.scene.balls[0].start.position = {width / 2, height};
    task.scene.balls[0].start.velocity = {20, 0};
    return task;
}

// The exact method, and who steps, as advised.
std::vector<Contestant> ours_and_peers() {
    std::vector<Contestant> contestants;
    for (Contestant const& ours : our_methods({240}))
        if (ours.pieces == 0 && ours.method != "article") contestants.push_back(ours);
    for (Contestant const& peer : peers({60})) contestants.push_back(peer);
    return contestants;
}

struct Point2 {
    double count = 0, time = 0;
};
using Curve = std::vector<Point2>;

// Where the two cost the same, read off between the sizes on logarithmic scales.
std::optional<Point2> crossing(Curve const& a, Curve const& b) {
    for (std::size_t i = 1; i < std::min(a.size(), b.size()); ++i) {
        double const before = std::log(a[i - 1].time / b[i - 1].time), after = std::log(a[i].time / b[i].time);
        if (!(before * after < 0)) continue;
        double const share = before / (before - after);
        return Point2{a[i - 1].count * std::pow(a[i].count / a[i - 1].count, share),
                      a[i - 1].time * std::pow(a[i].time / a[i - 1].time, share)};
    }
    return {};
}

void write_numbers(std::vector<Size> const& sizes, Times const& times, Tables const& tables) {
    std::ofstream to = tables.open("numbers.tsv"), crossings = tables.open("crossings.tsv");
    to << "# ns per simulated second, asked 60 times a second; chords 0: the arc itself\n# what\tmethod\tcount\ttime\n";
    crossings << "# where the exact method and another cost the same\n# what\tmethod\tcount\ttime\n";
    for (char const* const what : {"balls", "surfaces", "chords"}) {
        std::map<std::string, Curve> curves;
        for (Contestant const& contestant : ours_and_peers()) {
            for (Size const& size : sizes) {
                double const time = time_in(times, size.benchmark);
                if (size.what != what || size.contestant.method != contestant.method || std::isnan(time)) continue;
                to << what << '\t' << contestant.method << '\t' << size.count << '\t' << time << '\n';
                if (size.count > 0) curves[contestant.method].push_back({double(size.count), time});
            }
            to << '\n';
        }
        for (auto const& [method, curve] : curves)
            if (auto const point = method == "exact" ? std::nullopt : crossing(curves["exact"], curve))
                crossings << what << '\t' << method << '\t' << point->count << '\t' << point->time << '\n';
    }
}

}  // namespace

Part numbers_part(std::string const& lab, std::vector<int> const& balls, std::vector<int> const& surfaces,
                  std::vector<int> const& chords, Effort const& effort) {
    Part part;
    std::vector<Size> sizes;
    auto const add = [&](std::string const& what, int count, Contestant const& contestant, Task const& task,
                         double work) {
        part.benchmarks.push_back(sampled_run(what + '/' + std::to_string(count), contestant, task, effort));
        part.benchmarks.back().work *= work;
        sizes.push_back({what, count, contestant, part.benchmarks.back().name});
    };
    for (int const count : balls)
        for (Contestant const& contestant : ours_and_peers()) add("balls", count, contestant, gas_of(count), count);
    for (int const count : surfaces)
        for (Contestant const& contestant : ours_and_peers()) add("surfaces", count, contestant, flight_over(count), 1);
    Task valley;
    valley.scene = level::read_level(lab + "/valley.svg").scene;
    valley.scene.sensors.clear();  // who falls out of the frame is the game's business
    valley.duration = 5;
    for (Contestant contestant : ours_and_peers()) {
        bool const knows_arcs = contestant.pieces == 0;
        if (knows_arcs) add("chords", 0, contestant, valley, 1);
        for (int const count : chords) {
            contestant.pieces = count;
            add("chords", count, contestant, valley, 10);
        }
    }
    part.write = [sizes](Times const& times, Tables const& tables) { write_numbers(sizes, times, tables); };
    return part;
}

}  // namespace bench
