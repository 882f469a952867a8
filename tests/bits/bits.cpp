// Prints what levels come to under every method: a line of hashes a run, the same whoever compiled it. Levels are named
// by arguments; recorded runs come on standard input, a word or number after the other:
//     run NAME LEVEL DURATION COUNT, then COUNT times: TIME grab BALL X Y | TIME move X Y | TIME release | TIME tilt
//     ANGLE
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/session.h"
#include "level/hash.h"

namespace {

constexpr double rows_per_second = 60;
constexpr double longest_run = 10;       // s, of a level
constexpr double balls_seconds = 30;     // s times balls, so that crowds take no longer than single balls do
constexpr std::size_t most_balls = 100;  // levels with more than that are there for their speed

using SharedLevel = std::shared_ptr<level::Level const>;
using Inputs = std::vector<game::Input>;

// Pulls and tilts that take the player's ball about the level.
Inputs script_for(level::Level const& level) {
    geometry::Vec2 const start = level.scene.balls[level.player].start.position;
    geometry::Vec2 const middle = level.size / 2;
    return {{0.25, game::Tilt{0.1}},
            {0.8, game::Grab{level.player, start + geometry::Vec2(1.5, 0.75)}},
            {1.3, game::Move{middle}},
            {1.9, game::Move{middle + geometry::Vec2(2, -3)}},
            {2.6, game::Release{}},
            {3.3, game::Tilt{-0.2}},
            {5.1, game::Grab{level.player, start}},
            {6.7, game::Release{}},
            {6.7, game::Tilt{0}}};
}

std::uint64_t folded(std::string const& text, std::uint64_t hash) {
    return level::fnv1a(std::as_bytes(std::span(text)), hash);
}

struct Outcome {
    std::string last;                         // state hash at the end
    std::uint64_t all = level::fnv1a_offset;  // of the state hashes of all rows and of when events were
};

Outcome outcome_of(game::Session session, double duration) {
    Outcome outcome;
    int const rows = static_cast<int>(duration * rows_per_second);
    for (int i = 0; i <= rows; ++i) {
        double const time = i / rows_per_second;
        game::advance(session, time);
        outcome.last = game::state_hash(session, time);
        outcome.all = folded(outcome.last, outcome.all);
        for (physics::Event const& event : session.history.events)
            outcome.all = folded(std::to_string(std::bit_cast<std::uint64_t>(event.time)), outcome.all);
        session.history.events.clear();
        game::forget_before(session, time);
    }
    return outcome;
}

void print_under_every_method(std::string const& name, SharedLevel const& level, Inputs const& inputs,
                              double duration) {
    for (physics::Method const& method :
         {physics::Method(physics::Article{}), physics::Method(physics::Euler{}), physics::Method(physics::Steps{}),
          physics::Method(physics::Exact{})}) {
        Outcome const outcome = outcome_of(game::session_of(level, method, inputs), duration);
        std::printf("%s %s %s %s\n", name.c_str(), physics::name_of(method), outcome.last.c_str(),
                    level::hex_of(outcome.all).c_str());
    }
}

SharedLevel level_in(std::string const& file) { return std::make_shared<level::Level const>(level::read_level(file)); }

void print_runs_of(std::string const& file) {
    SharedLevel const level = level_in(file);
    std::size_t const balls = level->scene.balls.size();
    if (balls > most_balls) return;
    double const duration = std::min(longest_run, balls_seconds / static_cast<double>(balls));
    std::string const name = std::filesystem::path(file).filename().string();
    print_under_every_method(name + " alone", level, {}, duration);
    print_under_every_method(name + " played", level, script_for(*level), duration);
}

geometry::Vec2 point_from(std::istream& words) {
    double x = 0, y = 0;
    words >> x >> y;
    return {x, y};
}

game::Input input_from(std::istream& words) {
    double time = 0, angle = 0;
    int ball = 0;
    std::string kind;
    words >> time >> kind;
    if (kind == "grab") {
        words >> ball;
        return {time, game::Grab{ball, point_from(words)}};
    }
    if (kind == "move") return {time, game::Move{point_from(words)}};
    if (kind == "release") return {time, game::Release{}};
    if (kind != "tilt") throw std::runtime_error("no input is called \"" + kind + "\"");
    words >> angle;
    return {time, game::Tilt{angle}};
}

void print_recorded_runs(std::istream& words) {
    for (std::string word, name, file; words >> word;) {
        double duration = 0;
        std::size_t count = 0;
        if (word != "run" || !(words >> name >> file >> duration >> count))
            throw std::runtime_error("a run was expected, got \"" + word + "\"");
        Inputs inputs;
        while (inputs.size() < count) inputs.push_back(input_from(words));
        if (!words) throw std::runtime_error(name + " is cut short");
        print_under_every_method(name, level_in(file), inputs, duration);
    }
}

}  // namespace

int main(int count, char** arguments) {
    try {
        for (int i = 1; i < count; ++i) print_runs_of(arguments[i]);
        print_recorded_runs(std::cin);
    } catch (std::exception const& error) {
        std::fprintf(stderr, "bits: %s\n", error.what());
        return 1;
    }
}
