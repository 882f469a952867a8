// The camera: metres <-> pixels, and where it looks as a function of time and of the ball's path alone.
#pragma once

#include "level/level.h"
#include "physics/world/world.h"

namespace view {

using geometry::Vec2;

struct Camera {
    Vec2 centre = Vec2::Zero();   // m, the point of the world in the middle of the picture
    double scale = 80;            // pixels per metre
    Vec2 size = Vec2(1280, 720);  // pixels
    Vec2 right = Vec2::UnitX();   // unit, the world's direction that is seen to the right: turned_camera
    Vec2 swing = Vec2::Zero();    // m, by which turning has moved the centre: what is far away does not follow
};

Vec2 pixel_of(Camera const& camera, Vec2 const& world);
Vec2 world_of(Camera const& camera, Vec2 const& pixel);

// Pixels: what a way in the world, m, is in the picture.
Vec2 pixels_along(Camera const& camera, Vec2 const& way);

// rad, counter-clockwise: by which `right` is turned, and the world is seen turned clockwise.
double turn_of(Camera const& camera);

// A box around what of the world is seen, m.
geometry::Box sight_of(Camera const& camera);

// Reduced: nothing moves but what the game is about.
enum class Motion { full, reduced };

// What the player has turned the wheel to; the default shows what pictures without a window show. Where motion is
// reduced a camera that follows does so from farther away, and does not look ahead.
struct Lens {
    double zoom = 1;
    Vec2 pan = Vec2::Zero();  // m, added to where the camera would look
    Motion motion = Motion::full;
};
inline constexpr double calm_zoom = 0.8;
inline constexpr double least_zoom = 0.5, greatest_zoom = 8;

// How much of the past, in seconds, a history must still know for camera_at and moment_at to answer.
inline constexpr double camera_memory = 2.5;

// A level of at most this size is shown whole (docs/command-line.md); of a larger one so much is shown as suits the
// ball: this much where its radius is between a quarter and three fifths of a metre.
inline constexpr double whole_width = 16, whole_height = 9;  // m

// How large things are that have no size of their own, posts and springs: 1 where the view is whole_width wide.
double size_unit(level::Level const& level);

// The same time gives the same camera, whatever was drawn before: where it looks is a weighted mean of the path of the
// player's ball, ahead of it where it is fast. Its velocity is continuous and its acceleration bounded, also where the
// ball bounces, as long as that is not near the picture's edge. A ball that leaves the level, but has not fallen out
// yet, is kept in sight: a level that was shown whole is seen from farther away then.
Camera camera_at(level::Level const& level, physics::History const& history, double time, Vec2 const& size,
                 Lens const& lens = {});

// The same camera with the world turned clockwise by `turn`, rad, about where the ball softly is: all that camera_at
// says of softness holds, and the ball stays in sight. Turned by 0 it is the same to the bit.
Camera turned_camera(Camera camera, level::Level const& level, physics::History const& history, double time,
                     double turn);

// m, the middle of what notices balls.
Vec2 middle_of(physics::Region const& region);

// The same camera so far on the way to where it would look at the goal, 0 to 1.
Camera towards_goal(level::Level const& level, Camera camera, double share);

// The lens after turning the wheel by `notches` (away from the player is positive) over `pixel`: the point of the
// world under the pointer stays there as far as the level's edges allow.
Lens zoomed(Lens const& lens, Camera const& camera, Vec2 const& pixel, double notches);

}  // namespace view
