// Small levels made by hand, and games on them: for the tests of what knows levels.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "game/method_choice.h"
#include "game/run_file.h"
#include "game/session.h"
#include "scenes/scenes.h"

namespace scenes {

// Nothing but balls, 16 m by 9 m.
inline level::Level level_with(std::vector<physics::Ball> balls, double gravity = g) {
    level::Level level;
    level.file = "level.svg";
    level.hash = "0123456789abcdef";
    level.size = Vec2(16, 9);
    level.scene = scene_of({}, std::move(balls), gravity);
    return level;
}

// What notices the player's ball.
inline void add_sensor(level::Level& level, level::Meaning meaning, physics::Region const& region, bool rim = false) {
    physics::Sensor sensor;
    sensor.region = region;
    sensor.rim = rim;
    sensor.ball = 0;
    level.scene.sensors.push_back(sensor);
    level.meanings.push_back(meaning);
}
inline void add_line(level::Level& level, level::Meaning meaning, double x) {
    add_sensor(level, meaning, physics::LineRegion{Vec2(x, -5), Vec2(x, 5)});
}

inline std::shared_ptr<level::Level const> read_level(std::string const& file) {
    return std::make_shared<level::Level const>(level::read_level(file));
}

inline game::Session session_of(level::Level const& level, physics::Method const& method = physics::Exact{},
                                std::vector<game::Input> inputs = {}) {
    return game::session_of(std::make_shared<level::Level const>(level), method, std::move(inputs), "run.json");
}

// A game of what ships, by the method that it asks for.
inline game::Session session_of_run(game::Run const& run) {
    auto const level = read_level(run.level_file);
    return game::session_of(level, game::method_for({run.method_name, run.rate}, level->scene), run.inputs);
}

}  // namespace scenes
