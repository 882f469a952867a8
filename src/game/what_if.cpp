#include "game/what_if.h"

#include <utility>

#include "physics/predict.h"

namespace game {

physics::History what_if(Session const& session, std::optional<Action> const& action, double horizon) {
    Session trial = without_past(session);
    if (action) act(trial, *action);
    return physics::predicted(trial.method, trial.level->scene, trial.world, horizon);
}

physics::History what_if_held(Session const& session, Vec2 const& pointer, double horizon) {
    Session trial = without_past(session);
    act(trial, Move{pointer});
    double const now = session.world.time;
    advance_held(trial, now, now + horizon, [&](double) { return pointer; });
    return std::move(trial.history);
}

}  // namespace game
