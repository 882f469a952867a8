#include "view/path_mean.h"

#include <algorithm>
#include <cmath>

#include "view/camera.h"
#include "view/soft_limits.h"

namespace view {

static_assert(longest_span + 2 * path_spacing < camera_memory);

namespace {

// The kernel over age by which the path is averaged, of area 1, and its derivative: the kernel and, at the far end, its
// slope are 0, so that the mean velocity is continuous where the ball's is not.
double weight(double age, double over) {
    return age < over ? 12 * age * (over - age) * (over - age) / (over * over * over * over) : 0;
}
double slope(double age, double over) {
    return age < over ? 12 * (over - age) * (over - 3 * age) / (over * over * over * over) : 0;
}

}  // namespace

double weight_below(double age, double over) {
    double const u = std::clamp(age / over, 0.0, 1.0);
    return u * u * (6 - 8 * u + 3 * u * u);
}

// Where a ball has fallen out it is no longer followed.
Vec2 followed(level::Level const& level, physics::History const& history, double time) {
    Vec2 const position = physics::state_at(history, level.player, std::max(time, history.from)).position;
    Vec2 place;
    for (int axis = 0; axis < 2; ++axis)
        place[axis] = softly_within(position[axis], -level.size[axis] / 2, level.size[axis] * 1.5);
    return place;
}

// The integrals of the weights times position and velocity, from where the ball is now. The path is a chain of chords
// whose joints stand still while time goes on; over each of them three points of Gauss are exact.
PathMean mean_of_path(level::Level const& level, physics::History const& history, double time) {
    struct Point {
        double place, share;
    };
    static double const node = std::sqrt(0.6);
    Point const points[] = {{-node, 5.0 / 18}, {0, 8.0 / 18}, {node, 5.0 / 18}};
    Vec2 const now = followed(level, history, time);
    PathMean mean{now, Vec2::Zero()};
    double end = time;
    Vec2 place = now;
    for (double joint = std::ceil(time / path_spacing) - 1; end > time - longest_span; --joint) {
        double const start = joint * path_spacing;
        Vec2 const before = followed(level, history, start);
        double const from = std::max(start, time - longest_span);
        for (Point const& point : points) {
            double const when = (from + end) / 2 + (end - from) / 2 * point.place;
            Vec2 const off = before + (place - before) * ((when - start) / (end - start)) - now;
            for (int axis = 0; axis < 2; ++axis) {
                double const share = (end - from) * point.share * off[axis];
                mean.position[axis] += share * weight(time - when, spans[axis].place);
                mean.velocity[axis] += share * slope(time - when, spans[axis].velocity);
            }
        }
        end = start;
        place = before;
    }
    return mean;
}

}  // namespace view
