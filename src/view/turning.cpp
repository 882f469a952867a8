#include "view/turning.h"

#include "view/path_mean.h"

namespace view {

double turn_at(game::Session const& session, double time) {
    std::deque<game::ForcesSince> const& forces = session.forces;
    std::size_t last = forces.size() - 1;
    while (last > 0 && forces[last].time > time) --last;
    double turn = forces[last].forces.tilt;
    for (std::size_t i = last; i > 0; --i) {
        double const age = time - forces[i].time;
        if (age >= turn_span) break;
        double const change = forces[i].forces.tilt - forces[i - 1].forces.tilt;
        if (change != 0) turn -= change * (1 - weight_below(age, turn_span));
    }
    return turn;
}

Camera camera_of(game::Session const& session, double time, Vec2 const& size, Turning turning, Lens const& lens) {
    Camera const camera = camera_at(*session.level, session.history, time, size, lens);
    if (turning == Turning::never) return camera;
    return turned_camera(camera, *session.level, session.history, time, turn_at(session, time));
}

}  // namespace view
