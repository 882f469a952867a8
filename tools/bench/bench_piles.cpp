#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "bench_heaper.h"
#include "bench_part.h"

namespace bench {

namespace {

constexpr double radius = 0.5;               // m
constexpr double settling_of_a_ball = 6e-3;  // s: a large pile takes longer to come to rest
constexpr int timed_frames = 20;             // of a run
constexpr int repeats = 3;

physics::Piece wall(Vec2 const& from, Vec2 const& to) { return {geometry::Segment{from, to}, {}, 0}; }

}  // namespace

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

namespace {

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

double seconds_of_frames(Pile& pile, int frames) {
    auto const before = std::chrono::steady_clock::now();
    for (int frame = 0; frame < frames; ++frame) pile.frame();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

// A pile that is made and settles when it is first needed.
struct Heap {
    PileSolver heaper;
    int count = 0;
    double settling = 0;  // s
    std::unique_ptr<Pile> pile;
    double overlap = 0;  // m

    std::string name() const { return "piles/" + std::to_string(count) + '/' + heaper.method + '/' + heaper.setting; }
    std::map<std::string, double> settle() {
        pile = heaper.start(pile_of(count));
        for (int i = 0; i < settling * frames_per_second; ++i) pile->frame();
        overlap = deepest_overlap(pile->positions());
        return {{"overlap_m", overlap}};
    }
    double seconds(int runs) { return seconds_of_frames(*pile, runs * timed_frames); }
};

Timed benchmark_of(std::shared_ptr<Heap> const& heap) {
    constexpr double simulated = timed_frames / double(frames_per_second);
    // A ball in a frame takes longer than a step of a lonely one.
    double const work = heap->count * (heap->settling / simulated / repeats + 1) * timed_frames;
    return {heap->name(),
            simulated,
            repeats,
            work,
            [heap](int runs) { return heap->seconds(runs); },
            [heap] { return heap->settle(); }};
}

}  // namespace

std::vector<PileSolver> heapers() {
    std::vector<PileSolver> all;
    for (double const rate : {60.0, 240.0})
        all.push_back({"steps", std::to_string(static_cast<int>(rate)) + " Hz",
                       [rate](physics::Scene const& scene) { return our_pile(scene, {rate, 4}); }});
    for (Peer const& peer : known_peers())
        for (Peer::PileSetting const& pile : peer.pile_settings)
            all.push_back({peer.name, pile.setting,
                           [&](physics::Scene const& scene) { return peer.pile(scene, pile.iterations); }});
    return all;
}

Part piles_part(std::vector<int> const& counts, double settling) {
    Part part;
    std::vector<std::shared_ptr<Heap>> heaps;
    for (int const count : counts)
        for (PileSolver const& heaper : heapers()) {
            double const seconds = std::max(settling, count * settling_of_a_ball);
            heaps.push_back(std::make_shared<Heap>(Heap{heaper, count, seconds, nullptr}));
            part.benchmarks.push_back(benchmark_of(heaps.back()));
        }
    part.write = [heaps, settling](Times const& times, Tables const& tables) {
        std::ofstream to = tables.open("piles.tsv");
        to << "# piles after " << settling
           << " s, large ones later, kept awake: milliseconds for 1/60 s, deepest overlap in radii\n"
           << "# method\tsetting\tballs\tmilliseconds\toverlap\n";
        std::size_t const kinds = heapers().size();
        for (std::size_t i = 0; i < heaps.size(); ++i) {
            auto const& heap = heaps[i % (heaps.size() / kinds) * kinds + i / (heaps.size() / kinds)];
            double const time = time_in(times, heap->name());
            if (std::isnan(time)) continue;
            to << heap->heaper.method << '\t' << heap->heaper.setting << '\t' << heap->count << '\t'
               << time * 1e-6 / frames_per_second << '\t' << heap->overlap / radius << '\n';
        }
    };
    return part;
}

}  // namespace bench
