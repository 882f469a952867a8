// Small levels made by hand, for tests of what is drawn, and what a picture holds.
#pragma once

#include "level/level.h"
#include "physics/motion/leg.h"
#include "scenes/levels.h"
#include "view/scene_picture.h"

namespace view_test {

using namespace scenes;

inline level::Outline straight(Vec2 const& from, Vec2 const& to) { return {{geometry::Segment{from, to}}, false}; }

inline level::Outline block(Vec2 const& low, Vec2 const& high) {
    level::Outline outline{{}, true};
    for (physics::Piece const& side : ring({low, {high.x(), low.y()}, high, {low.x(), high.y()}}))
        outline.curves.push_back(side.curve);
    return outline;
}

// A floor at height 1 and one ball of radius 0.5 that lies on it.
inline level::Level floor_level(double width, double height, physics::Material const& of = {}) {
    level::Level level = level_with({disc_at({width / 2, 1.5})});
    level.title = "Floor";
    level.size = Vec2(width, height);
    level.surface_names = {"floor"};
    level.scene.terrain = physics::terrain_of({line({0, 1}, {width, 1}, of)});
    level.outlines = {straight({0, 1}, {width, 1})};
    return level;
}

// From a time on the ball moves with constant velocity and spin.
inline physics::Leg steady_leg(physics::State const& start, double since = 0) {
    physics::Leg leg;
    leg.since = since;
    leg.motion = physics::Ballistic{start, Vec2::Zero(), 0};
    return leg;
}
inline physics::History steady_history(physics::State const& start) {
    physics::History history;
    history.legs.push_back({steady_leg(start)});
    return history;
}
inline physics::History resting_history(Vec2 const& place) { return steady_history({place, {0, 0}, 0, 0}); }

// Flies to and fro between two walls, 4 m apart, its velocity turning round at once.
inline physics::History bouncing_history(Vec2 const& middle, double speed) {
    physics::History history;
    physics::Trail<physics::Leg>& legs = history.legs.emplace_back();
    double const period = 4 / speed;
    for (int i = 0; i < 40; ++i) {
        double const way = i % 2 == 0 ? 1 : -1;
        legs.push_back(steady_leg({middle - Vec2(2 * way, 0), {speed * way, 0}, 0, 0}, i * period));
        legs.back().until = (i + 1) * period;
    }
    return history;
}

template <typename Kind>
std::vector<Kind> all_of(std::vector<view::Shape> const& shapes) {
    std::vector<Kind> all;
    for (view::Shape const& shape : shapes)
        if (auto const* one = std::get_if<Kind>(&shape)) all.push_back(*one);
    return all;
}
template <typename Kind>
int count_of(std::vector<view::Shape> const& shapes) {
    return static_cast<int>(all_of<Kind>(shapes).size());
}

// Letters, and the plate that they stand on, if any.
struct Letters {
    view::Label label;
    std::optional<view::Panel> plate;
};
inline std::vector<Letters> letters_of(std::vector<view::Shape> const& shapes) {
    std::vector<Letters> all;
    std::vector<view::Panel> plates;
    for (view::Shape const& shape : shapes) {
        if (auto const* panel = std::get_if<view::Panel>(&shape)) plates.push_back(*panel);
        auto const* label = std::get_if<view::Label>(&shape);
        if (!label) continue;
        all.push_back({*label, {}});
        for (view::Panel const& plate : plates) {
            Vec2 const at = label->at - plate.corner;
            if (at.x() >= 0 && at.y() >= 0 && at.x() <= plate.size.x() && at.y() <= plate.size.y())
                all.back().plate = plate;
        }
    }
    return all;
}

}  // namespace view_test
