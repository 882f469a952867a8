#include <algorithm>

#include "bench_engine.h"

namespace bench {

namespace {

class Ours : public Engine {
public:
    Ours(physics::Method const& method, Task const& task) : method_(method), task_(task) {}

    std::vector<Vec2> positions_at(std::vector<double> const& times) override {
        return at<Vec2>(times, [](physics::State const& state) { return state.position; });
    }
    std::vector<physics::State> states_at(std::vector<double> const& times) override {
        return at<physics::State>(times, [](physics::State const& state) { return state; });
    }

private:
    template <typename Wanted, typename Part>
    std::vector<Wanted> at(std::vector<double> const& times, Part const& part) {
        physics::History history;
        physics::World world = physics::world_at_start(method_, task_.scene, history);
        if (task_.pull) physics::apply(method_, task_.scene, world, {0, task_.pull}, history);
        int const balls = static_cast<int>(task_.scene.balls.size());
        std::vector<Wanted> answers;
        answers.reserve(times.size() * task_.scene.balls.size());
        for (double const time : times) {
            if (physics::advance(method_, task_.scene, world, time, history)) return {};
            for (int ball = 0; ball < balls; ++ball) answers.push_back(part(physics::state_at(history, ball, time)));
            physics::forget_before(history, time);
        }
        return answers;
    }

    physics::Method method_;
    Task task_;
};

std::unique_ptr<Engine> our_engine(Contestant const& contestant, Task const& task) {
    Task ours = task;
    if (contestant.pieces > 0) ours.scene = in_pieces(task.scene, contestant.pieces);
    return std::make_unique<Ours>(method_of(contestant), ours);
}

class OurPile : public Pile {
public:
    OurPile(physics::Scene const& scene, physics::Steps const& method)
        : method_(method), scene_(scene), world_(physics::world_at_start(method_, scene_, history_)) {}

    void frame() override {
        // A pile that has gone to sleep would cost nothing and tell nothing.
        world_.still_steps.assign(world_.still_steps.size(), -1000000);
        ++frames_;
        physics::advance(method_, scene_, world_, frames_ / static_cast<double>(frames_per_second), history_);
        physics::forget_before(history_, world_.time);
    }
    std::vector<Vec2> positions() const override {
        std::vector<Vec2> positions;
        for (physics::Leg const& leg : world_.legs) positions.push_back(physics::at(leg, world_.time).position);
        return positions;
    }

private:
    physics::Method method_;
    physics::Scene scene_;
    physics::History history_;
    physics::World world_;
    int frames_ = 0;
};

}  // namespace

physics::Method method_of(Contestant const& contestant) {
    if (contestant.method == "article") return physics::Article{contestant.rate};
    if (contestant.method == "euler") return physics::Euler{contestant.rate};
    if (contestant.method == "steps") return physics::Steps{contestant.rate, 4};
    return physics::Exact{};
}

std::vector<Contestant> our_methods(std::vector<double> const& rates) {
    std::vector<Contestant> all;
    all.push_back({"exact", "as it is", 0, true, 0, our_engine});
    for (int const pieces : {32, 128, 512, 2048})
        all.push_back({"exact on pieces", std::to_string(pieces) + " pieces", 0, false, pieces, our_engine});
    for (char const* const method : {"steps", "euler", "article"})
        for (double const rate : rates)
            all.push_back({method, std::to_string(static_cast<int>(rate)) + " Hz", rate, rate == 240, 0, our_engine});
    return all;
}

std::unique_ptr<Pile> our_pile(physics::Scene const& scene, physics::Steps const& method) {
    return std::make_unique<OurPile>(scene, method);
}

}  // namespace bench
