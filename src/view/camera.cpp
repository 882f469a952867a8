#include "view/camera.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr int samples = 48;
constexpr double settling = 0.15;      // s: the mean of the path has an age of about twice this
constexpr double furthest_lag = 0.22;  // of the picture: how far from its middle the ball may run ahead

// Without a doubling of the view's size beyond the level the ball has fallen out and is no longer followed.
Vec2 followed(level::Level const& level, physics::History const& history, double time) {
    Vec2 const position = physics::state_at(history, level.player, std::max(time, history.from)).position;
    Vec2 const margin = level.size / 2;
    return position.cwiseMax(-margin).cwiseMin(level.size + margin);
}

Vec2 mean_of_path(level::Level const& level, physics::History const& history, double time) {
    double constexpr spacing = camera_memory * 0.8 / samples;
    Vec2 sum = Vec2::Zero();
    double weights = 0;
    for (int i = 0; i < samples; ++i) {
        double const age = (i + 0.5) * spacing;
        double const weight = age * std::exp(-age / settling);
        sum += weight * followed(level, history, time - age);
        weights += weight;
    }
    return sum / weights;
}

double soft_limit(double offset, double limit) {
    double const ratio = offset / limit;
    return offset / std::sqrt(1 + ratio * ratio);
}

// One axis: within the level where it is larger than the view, its middle where it is not.
double kept_within(double centre, double extent, double view) {
    if (extent <= view) return extent / 2;
    return std::clamp(centre, view / 2, extent - view / 2);
}

double natural_scale(level::Level const& level, Vec2 const& size) {
    double const width = std::clamp(level.size.x(), 1e-6, whole_width);
    double const height = std::clamp(level.size.y(), 1e-6, whole_height);
    return std::min(size.x() / width, size.y() / height);
}

}  // namespace

Vec2 pixel_of(Camera const& camera, Vec2 const& world) {
    Vec2 const offset = (world - camera.centre) * camera.scale;
    return {camera.size.x() / 2 + offset.x(), camera.size.y() / 2 - offset.y()};
}

Vec2 world_of(Camera const& camera, Vec2 const& pixel) {
    Vec2 const offset = (pixel - camera.size / 2) / camera.scale;
    return {camera.centre.x() + offset.x(), camera.centre.y() - offset.y()};
}

geometry::Box sight_of(Camera const& camera) {
    Vec2 const half = camera.size / (2 * camera.scale);
    return {camera.centre - half, camera.centre + half};
}

Camera camera_at(level::Level const& level, physics::History const& history, double time, Vec2 const& size,
                 Lens const& lens) {
    Camera camera;
    camera.size = size;
    camera.scale = natural_scale(level, size) * lens.zoom;
    Vec2 const view = size / camera.scale;
    Vec2 const ball = followed(level, history, time);
    Vec2 const mean = mean_of_path(level, history, time);
    double const radius = level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    for (int axis = 0; axis < 2; ++axis) {
        double const lag = soft_limit(ball[axis] - mean[axis], furthest_lag * view[axis]);
        double centre = kept_within(ball[axis] - lag + lens.pan[axis], level.size[axis], view[axis]);
        // A level that is shown whole keeps still, wherever the ball goes; in a larger one the ball stays in sight.
        double const furthest = std::max(0.25 * view[axis], 0.5 * view[axis] - radius);
        if (level.size[axis] > view[axis]) centre = std::clamp(centre, ball[axis] - furthest, ball[axis] + furthest);
        camera.centre[axis] = centre;
    }
    return camera;
}

Lens zoomed(Lens const& lens, Camera const& camera, Vec2 const& pixel, double notches) {
    Lens after = lens;
    after.zoom = std::clamp(lens.zoom * std::pow(1.15, notches), least_zoom, greatest_zoom);
    Vec2 const from_centre = world_of(camera, pixel) - camera.centre;
    after.pan += from_centre * (1 - lens.zoom / after.zoom);
    // Back at the natural zoom nothing of a pan is left; further in, the ball must stay in sight.
    Vec2 const reach = 0.4 * camera.size / camera.scale * (lens.zoom / after.zoom) * std::max(0.0, 1 - 1 / after.zoom);
    after.pan = after.pan.cwiseMax(-reach).cwiseMin(reach);
    return after;
}

}  // namespace view
