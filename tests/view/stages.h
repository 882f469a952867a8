// Small levels made by hand, for tests of what is drawn.
#pragma once

#include "game/method_choice.h"
#include "game/run_file.h"
#include "level/level.h"
#include "physics/motion/leg.h"
#include "view/scene_picture.h"

namespace view_test {

using geometry::Vec2;

inline level::Outline straight(Vec2 const& from, Vec2 const& to) { return {{geometry::Segment{from, to}}, false}; }

inline void add_terrain(level::Level& level, level::Outline const& outline) {
    std::vector<physics::Piece> pieces = level.scene.terrain.pieces;
    for (geometry::Curve const& curve : outline.curves) pieces.push_back({curve, {}, 0});
    level.scene.terrain = physics::terrain_of(pieces);
    level.outlines.push_back(outline);
}

// A floor at height 1 and one ball of radius 0.5 that lies on it.
inline level::Level floor_level(double width, double height) {
    level::Level level;
    level.title = "Floor";
    level.hash = "0123456789abcdef";
    level.size = Vec2(width, height);
    level.surface_names = {"floor"};
    physics::Ball ball;
    ball.start.position = Vec2(width / 2, 1.5);
    level.scene.balls = {ball};
    add_terrain(level, straight({0, 1}, {width, 1}));
    return level;
}

// A run that ships, played to its end.
inline game::Session played_run(std::string const& file) {
    game::Run const run = game::read_run(file);
    auto const level = std::make_shared<level::Level const>(level::read_level(run.level_file));
    game::Session session =
        game::session_of(level, game::method_for({run.method_name, run.rate}, level->scene), run.inputs);
    game::advance(session, run.duration.value_or(10));
    return session;
}

// The ball moves with constant velocity and spin from t = 0 on.
inline physics::History steady_history(physics::State const& start) {
    physics::Leg leg;
    leg.motion = physics::Ballistic{start, Vec2::Zero(), 0};
    physics::History history;
    history.legs.push_back({leg});
    return history;
}

template <typename Kind>
int count_of(std::vector<view::Shape> const& shapes) {
    int count = 0;
    for (view::Shape const& shape : shapes) count += std::holds_alternative<Kind>(shape) ? 1 : 0;
    return count;
}

}  // namespace view_test
