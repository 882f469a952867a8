// Players without a head: what they do needs no look at the level.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "game/session.h"

namespace game_test {

using geometry::Vec2;

inline Vec2 middle_of(physics::Region const& region) {
    if (auto const* disc = std::get_if<physics::DiscRegion>(&region)) return disc->centre;
    if (auto const* line = std::get_if<physics::LineRegion>(&region)) return (line->from + line->to) / 2;
    Vec2 sum = Vec2::Zero();
    auto const& corners = std::get<physics::PolygonRegion>(region).corners;
    for (Vec2 const& corner : corners) sum += corner;
    return sum / static_cast<double>(corners.size());
}

inline Vec2 goal_of(level::Level const& level) {
    for (std::size_t i = 0; i < level.meanings.size(); ++i)
        if (level.meanings[i] == level::Meaning::goal) return middle_of(level.scene.sensors[i].region);
    return Vec2::Zero();
}

struct Robot {
    std::string name;
    std::function<void(game::Session&, double until)> play;
};

inline void tilt_for(game::Session& session, double until, double angle) {
    game::act(session, game::Tilt{angle});
    game::advance(session, until);
}

// First to one side, then to the other, a second each.
inline void rock(game::Session& session, double until, double angle) {
    for (double time = 0; time < until; ++time, angle = -angle) tilt_for(session, time + 1, angle);
}

inline std::vector<Robot> robots() {
    return {{"does nothing", [](game::Session& session, double until) { game::advance(session, until); }},
            {"tilts to the right", [](game::Session& session, double until) { tilt_for(session, until, 10); }},
            {"tilts to the left", [](game::Session& session, double until) { tilt_for(session, until, -10); }},
            {"rocks, right first", [](game::Session& session, double until) { rock(session, until, 10); }},
            {"rocks, left first", [](game::Session& session, double until) { rock(session, until, -10); }},
            {"pulls to the goal",
             [](game::Session& session, double until) {
                 Vec2 const goal = goal_of(*session.level);
                 game::act(session, game::Grab{session.level->player, goal});
                 game::advance_held(session, 0, until, [&](double) { return goal; });
             }},
            {"pulls to the goal, the hook not following", [](game::Session& session, double until) {
                 game::act(session, game::Grab{session.level->player, goal_of(*session.level)});
                 game::advance(session, until);
             }}};
}

// What a robot does from a time on, and what it does after that for ever.
struct TwoStepRobot {
    std::string name;
    std::function<void(game::Session&, double until)> first, then;
};

// On to `until`, or the end of the game, with a pointer that stays where it is from the ball (m) while one is held.
inline void play_on(game::Session& session, double until, Vec2 const& pointer_from_ball) {
    while (session.world.time < until && !session.goal_time && !session.fall_time) {
        if (session.world.forces.pull) {
            Vec2 const ball = physics::state_at(session.history, session.level->player, session.world.time).position;
            game::act(session, game::Move{ball + pointer_from_ball});
        }
        double const step = session.world.forces.pull ? 1.0 / 60 : 1;  // s
        game::advance(session, std::min(until, session.world.time + step));
    }
}

inline std::vector<TwoStepRobot> tilting_robots() {
    std::vector<TwoStepRobot> robots;
    auto const tilt = [](double angle) {
        return [angle](game::Session& session, double until) {
            game::act(session, game::Tilt{angle});
            play_on(session, until, Vec2::Zero());
        };
    };
    for (double const first : {-10.0, 0.0, 10.0})
        for (double const then : {-10.0, 0.0, 10.0})
            if (first != then)
                robots.push_back({"tilts by " + std::to_string(first) + ", then by " + std::to_string(then),
                                  tilt(first), tilt(then)});
    return robots;
}

inline std::vector<TwoStepRobot> pulling_robots() {
    auto const let_go = [](game::Session& session, double until) {
        game::act(session, game::Release{});
        play_on(session, until, Vec2::Zero());
    };
    auto const pull = [](double side) {
        return [side](game::Session& session, double until) {
            Vec2 const far(side * 100, 0);
            physics::State const ball = physics::state_at(session.history, session.level->player, session.world.time);
            game::act(session, game::Grab{session.level->player, ball.position + far});
            play_on(session, until, far);
        };
    };
    auto const to_the_goal = [](game::Session& session, double until) {
        Vec2 const goal = goal_of(*session.level);
        double const from = session.world.time;
        game::act(session, game::Grab{session.level->player, goal});
        game::advance_held(session, from, until, [&](double) { return goal; });
    };
    return {{"pulls to the right, then lets go", pull(1), let_go},
            {"pulls to the left, then lets go", pull(-1), let_go},
            {"pulls to the goal, then lets go", to_the_goal, let_go}};
}

}  // namespace game_test
