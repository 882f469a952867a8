#include "view/moment.h"

#include <algorithm>
#include <cmath>

namespace view {

Moment moment_at(level::Level const& level, physics::History const& history, double time, Recall recall) {
    Moment moment;
    moment.time = time;
    int const balls = static_cast<int>(level.scene.balls.size());
    for (int ball = 0; ball < balls; ++ball) {
        physics::Leg const& leg = physics::leg_at(history, ball, time);
        moment.balls.push_back(physics::at(leg, time));
        moment.before.push_back(physics::state_at(history, ball, std::max(time - force_interval, history.from)));
        moment.phases.push_back(leg.phase);
        moment.contacts.push_back(leg.contact);
        moment.wakes.push_back(wake_of(level, history, ball, time));
    }
    if (recall == Recall::nothing) return moment;
    // At whole multiples of the spacing, so that the chart slides and does not shimmer.
    double const newest = std::floor(time / chart_spacing);
    for (double i = newest - std::floor(chart_length / chart_spacing); i <= newest; ++i) {
        double const then = i * chart_spacing;
        if (then < history.from) continue;
        std::vector<physics::State>& row = moment.recent.emplace_back();
        for (int ball = 0; ball < balls; ++ball) row.push_back(physics::state_at(history, ball, then));
    }
    return moment;
}

Moment moment_of(game::Session const& session, double time, Recall recall) {
    Moment moment = moment_at(*session.level, session.history, time, recall);
    moment.forces = game::forces_at(session, time);
    moment.noticed_at = session.noticed_at;
    moment.status = game::status_at(session, time);
    return moment;
}

}  // namespace view
