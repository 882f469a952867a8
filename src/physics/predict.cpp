#include "physics/predict.h"

namespace physics {

History predicted(Method const& method, Scene const& scene, World const& world, double horizon) {
    World ahead = world;
    History history;
    history.from = world.time;
    for (Leg const& leg : ahead.legs) history.legs.push_back({leg});
    advance(method, scene, ahead, world.time + horizon, history);
    return history;
}

}  // namespace physics
