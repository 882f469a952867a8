#include "game/glimpse.h"

#include <utility>

#include "physics/predict.h"

namespace game {

namespace {

// The same game without its past: as much as rules and methods need to go on from here.
Session without_past(Session const& session) {
    Session bare;
    bare.level = session.level;
    bare.method = session.method;
    bare.world = session.world;
    bare.history.from = session.world.time;
    for (physics::Leg const& leg : session.world.legs) bare.history.legs.push_back({leg});
    bare.forces.push_back({session.world.time, session.world.forces});
    return bare;
}

}  // namespace

physics::History glimpse(Session const& session, std::optional<Action> const& action, double horizon) {
    Session trial = without_past(session);
    if (action) act(trial, *action);
    return physics::predicted(trial.method, trial.level->scene, trial.world, horizon);
}

physics::History glimpse_held(Session const& session, Vec2 const& pointer, double horizon) {
    Session trial = without_past(session);
    trial.noticed_at = session.noticed_at;
    act(trial, Move{pointer});
    double const now = session.world.time;
    advance_held(trial, now, now + horizon, [&](double) { return pointer; });
    return std::move(trial.history);
}

}  // namespace game
