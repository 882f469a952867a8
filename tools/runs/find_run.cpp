// Finds a run that wins a level with all of its bananas and within its pars: explores from what it has reached before
// (Go-Explore: Ecoffet et al., "First return, then explore", Nature 590, 2021), one short action at a time.
//
//     find_run LEVEL RUN [SECONDS [SEED]]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <tuple>

#include "game/method_choice.h"
#include "game/run_file.h"
#include "game/session.h"

namespace {

using game::Session;
using geometry::Vec2;

constexpr double ticks_per_second = 20;  // how often the pointer moves
constexpr int longest = 40 * 20;         // ticks, of a run
constexpr int trials = 40;               // of a run that was found, each a little off
constexpr double clumsiness = 0.004;     // s and m, by how much

struct Node {
    Session session;
    int parent = -1;
    std::vector<game::Input> inputs;  // since the parent
    int tick = 0;
    int bananas = 0;
    int visits = 0;
};

// Where nodes are alike, the earlier one is kept.
using Cell = std::tuple<int, int, bool, int, int, int, int>;

class Search {
public:
    Search(std::shared_ptr<level::Level const> level, unsigned seed)
        : level_(std::move(level)), method_(game::method_for({}, level_->scene)), dice_(seed) {
        for (level::Meaning const meaning : level_->meanings) all_bananas_ += meaning == level::Meaning::banana;
        keep({without_past(game::session_of(level_, method_)), -1, {}, 0, 0, 0});
    }

    void explore() {
        int const from = chosen();
        ++nodes_[static_cast<std::size_t>(from)].visits;
        Node next = nodes_[static_cast<std::size_t>(from)];
        next.parent = from;
        next.inputs.clear();
        next.visits = 0;
        play_on(next);
        if (next.session.fall_time || next.tick > longest) return;
        game::Status const status = game::status_at(next.session, next.session.world.time);
        next.bananas = status.bananas;
        if (level_->pars.pulls && status.pulls > *level_->pars.pulls) return;
        next.session = without_past(next.session);
        if (next.session.goal_time) {
            if (status.bananas == all_bananas_) judge(next);
            return;
        }
        keep(std::move(next));
    }

    std::optional<game::Run> best() const { return best_; }
    std::string report() const {
        int most = 0;
        for (Node const& node : nodes_) most = std::max(most, node.bananas);
        char text[160];
        std::snprintf(text, sizeof text, "%zu cells, %d of %d bananas, won %d times, best %.2f s, kept by %d of %d",
                      cells_.size(), most, all_bananas_, won_, best_time_, best_kept_, trials);
        return text;
    }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(dice_); }
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(dice_); }

    Cell cell_of(Node const& node) const {
        physics::State const ball = physics::state_at(node.session.history, level_->player, node.session.world.time);
        auto const part = [](double x, double size) { return static_cast<int>(std::floor(x / size)); };
        return {node.bananas,
                static_cast<int>(node.session.pulled_at.size()),
                node.session.world.forces.pull.has_value(),
                part(ball.position.x(), 0.5),
                part(ball.position.y(), 0.5),
                part(ball.velocity.x(), 2.5),
                part(ball.velocity.y(), 2.5)};
    }

    void keep(Node node) {
        auto const [place, fresh] = cells_.try_emplace(cell_of(node), static_cast<int>(nodes_.size()));
        if (!fresh && nodes_[static_cast<std::size_t>(place->second)].tick <= node.tick) return;
        place->second = static_cast<int>(nodes_.size());
        order_.push_back(place->second);
        by_bananas_[node.bananas].push_back(place->second);
        nodes_.push_back(std::move(node));
    }

    // Mostly from where most bananas have been reached; of a few by chance, the one with the fewest visits.
    int chosen() {
        std::vector<int> const* from = &order_;
        double const what = uniform(0, 1);
        auto const top = by_bananas_.rbegin();
        if (what < 0.5)
            from = &top->second;
        else if (what < 0.75 && by_bananas_.size() > 1)
            from = &std::next(top)->second;
        int best = (*from)[below(from->size())];
        for (int i = 0; i < 3; ++i) {
            int const other = (*from)[below(from->size())];
            if (nodes_[static_cast<std::size_t>(other)].visits < nodes_[static_cast<std::size_t>(best)].visits)
                best = other;
        }
        return best;
    }

    void act(Node& node, game::Action const& action) {
        std::size_t const before = node.session.inputs.size();
        game::act(node.session, action);
        if (node.session.inputs.size() > before) node.inputs.push_back(node.session.inputs.back());
    }

    void pass(Node& node, int ticks) {
        node.tick += ticks;
        game::advance(node.session, node.tick / ticks_per_second);
    }

    bool over(Node const& node) const { return node.session.goal_time || node.session.fall_time; }

    void pull(Node& node, int ticks) {
        double const angle = uniform(-3.1416, 3.1416);
        double const far = uniform(0, 1) < 0.7 ? 1.0 : uniform(0.2, 1.0);
        for (int i = 0; i < ticks && !over(node); ++i) {
            physics::State const ball =
                physics::state_at(node.session.history, level_->player, node.session.world.time);
            Vec2 pointer = ball.position + far * level_->drag_reach * Vec2(std::cos(angle), std::sin(angle));
            pointer = {std::round(pointer.x() * 1000) / 1000, std::round(pointer.y() * 1000) / 1000};
            if (node.session.world.forces.pull)
                act(node, game::Move{pointer});
            else
                act(node, game::Grab{level_->player, pointer});
            pass(node, 1);
        }
    }

    void play_on(Node& node) {
        int const lengths[] = {1, 2, 3, 4, 6, 8, 12, 20, 30};
        int const ticks = lengths[below(std::size(lengths))];
        bool const pulls = level_->drag_reach > 0, tilts = level_->tilt_limit > 0;
        bool const has_pulls_left = node.session.world.forces.pull || !level_->pars.pulls ||
                                    static_cast<int>(node.session.pulled_at.size()) < *level_->pars.pulls;
        double const what = uniform(0, 1);
        if (pulls && has_pulls_left && what < (tilts ? 0.4 : 0.7)) return pull(node, ticks);
        if (node.session.world.forces.pull) act(node, game::Release{});
        if (tilts && what > 0.5) {
            double const shares[] = {-1, -0.5, 0, 0.5, 1};
            double const angle = std::round(shares[below(5)] * level_->tilt_limit * 1000) / 1000;
            if (angle != node.session.world.forces.tilt) act(node, game::Tilt{angle});
        }
        for (int i = 0; i < ticks && !over(node); ++i) pass(node, 1);
    }

    std::vector<game::Input> inputs_to(Node const& node) const {
        std::vector<std::vector<game::Input> const*> parts = {&node.inputs};
        for (int at = node.parent; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent)
            parts.push_back(&nodes_[static_cast<std::size_t>(at)].inputs);
        std::vector<game::Input> inputs;
        for (auto part = parts.rbegin(); part != parts.rend(); ++part)
            inputs.insert(inputs.end(), (*part)->begin(), (*part)->end());
        return inputs;
    }

    // Whether it is won with all bananas; the time of the goal.
    std::optional<double> won_with(std::vector<game::Input> inputs, double until) const {
        Session session = game::session_of(level_, method_, std::move(inputs));
        game::advance(session, until);
        if (!session.goal_time || game::status_at(session, *session.goal_time).bananas < all_bananas_)
            return std::nullopt;
        return session.goal_time;
    }

    void judge(Node const& node) {
        ++won_;
        std::vector<game::Input> const inputs = inputs_to(node);
        double const until = node.tick / ticks_per_second;
        auto const time = won_with(inputs, until);
        if (!time) return;
        if (best_ && *time > 1.3 * best_time_ && best_kept_ >= trials * 9 / 10) return;
        int kept = 0;
        for (int i = 0; i < trials; ++i) {
            std::vector<game::Input> other = inputs;
            double shift = uniform(0, clumsiness);
            for (game::Input& input : other) {
                input.time += shift;
                Vec2 const off(uniform(-clumsiness, clumsiness), uniform(-clumsiness, clumsiness));
                if (auto* grab = std::get_if<game::Grab>(&input.action)) grab->pointer += off;
                if (auto* move = std::get_if<game::Move>(&input.action)) move->pointer += off;
                if (auto* tilt = std::get_if<game::Tilt>(&input.action)) tilt->angle += off.x();
            }
            if (won_with(std::move(other), until + 1)) ++kept;
        }
        // As steady as can be, then as fast as can be.
        bool const both_steady = kept >= trials * 9 / 10 && best_kept_ >= trials * 9 / 10;
        bool const better = !best_ || (both_steady ? *time < best_time_ : kept > best_kept_);
        if (!better) return;
        best_kept_ = kept;
        best_time_ = *time;
        game::Run run;
        run.level_file = level_->file;
        run.inputs = inputs;
        run.duration = std::ceil((*time + 2) * 10) / 10;
        if (!inputs.empty()) {
            bool held = false;
            for (game::Input const& input : inputs) {
                if (std::holds_alternative<game::Grab>(input.action)) held = true;
                if (std::holds_alternative<game::Release>(input.action)) held = false;
            }
            if (held) run.inputs.push_back({std::max(*time, inputs.back().time) + 0.05, game::Release{}});
        }
        best_ = run;
    }

    std::shared_ptr<level::Level const> level_;
    physics::Method method_;
    std::mt19937 dice_;
    int all_bananas_ = 0;
    std::vector<Node> nodes_;
    std::vector<int> order_;
    std::map<int, std::vector<int>> by_bananas_;
    std::map<Cell, int> cells_;
    int won_ = 0, best_kept_ = 0;
    double best_time_ = 0;  // s
    std::optional<game::Run> best_;
};

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        std::fprintf(stderr, "usage: find_run LEVEL RUN [SECONDS [SEED]]\n");
        return 2;
    }
    try {
        double const seconds = count > 3 ? std::atof(words[3]) : 30;
        Search search(std::make_shared<level::Level const>(level::read_level(words[1])),
                      count > 4 ? static_cast<unsigned>(std::atoi(words[4])) : 1);
        auto const now = [] { return std::chrono::steady_clock::now(); };
        auto const end = now() + std::chrono::duration<double>(seconds);
        while (now() < end)
            for (int i = 0; i < 100; ++i) search.explore();
        std::fprintf(stderr, "%s: %s\n", words[1], search.report().c_str());
        if (!search.best()) return 1;
        game::write_run(*search.best(), words[2]);
        return 0;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "find_run: %s\n", error.what());
        return 1;
    }
}
