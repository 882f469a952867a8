// Chipmunk 7.0.3 (libchipmunk-dev): its own segments with neighbours, discs and damped spring; 10 iterations, its
// default. Its slop of 0.1 is meant for pixels; 5 mm, as Box2D has it, suits metres.
#include <algorithm>
#include <cmath>

#include <chipmunk/chipmunk.h>

#include "bench_engine.h"
#include "geometry/elementary.h"

namespace bench {

namespace {

constexpr double slop = 0.005;         // m
constexpr double most_friction = 1e6;  // infinity times no force would be no number
constexpr double run_away = 1e9;       // m; Chipmunk ends the program where a position is no number

cpVect vector_of(Vec2 const& v) { return cpv(v.x(), v.y()); }

// Chipmunk multiplies what two shapes bring, so balls bring what leaves the surface's own.
struct Share {
    double friction = 1, restitution = 1;
};
Share share_of(physics::Scene const& scene) {
    if (scene.balls.size() == 1) return {};
    return {scene.balls[0].friction, std::sqrt(scene.balls[0].restitution)};
}

struct ChipmunkWorld {
    cpSpace* space = cpSpaceNew();
    std::vector<cpBody*> balls;
    std::vector<cpShape*> shapes;
    cpConstraint* spring = nullptr;

    explicit ChipmunkWorld(physics::Scene const& scene, int pieces = peer_pieces) {
        cpSpaceSetGravity(space, cpv(0, -scene.gravity));
        cpSpaceSetCollisionSlop(space, slop);
        Share const share = share_of(scene);
        for (Chain const& chain : chains_of(scene, pieces)) add_chain(chain, share);
        for (Boulder const& boulder : boulders_of(scene))
            add_ground(cpCircleShapeNew(cpSpaceGetStaticBody(space), boulder.arc.radius, vector_of(boulder.arc.centre)),
                       boulder.material, share);
        for (physics::Ball const& ball : scene.balls) add_ball(ball, share);
    }
    ChipmunkWorld(ChipmunkWorld const&) = delete;
    ChipmunkWorld& operator=(ChipmunkWorld const&) = delete;
    ~ChipmunkWorld() {
        if (spring) {
            cpSpaceRemoveConstraint(space, spring);
            cpConstraintFree(spring);
        }
        for (cpShape* const shape : shapes) {
            cpSpaceRemoveShape(space, shape);
            cpShapeFree(shape);
        }
        for (cpBody* const ball : balls) {
            cpSpaceRemoveBody(space, ball);
            cpBodyFree(ball);
        }
        cpSpaceFree(space);
    }

    void add_ground(cpShape* shape, physics::Material const& material, Share const& share) {
        cpShapeSetFriction(shape, share.friction > 0 ? std::min(material.friction, most_friction) / share.friction : 0);
        cpShapeSetElasticity(shape, share.restitution > 0 ? material.restitution / share.restitution : 0);
        shapes.push_back(cpSpaceAddShape(space, shape));
    }
    void add_chain(Chain const& chain, Share const& share) {
        auto const& corners = chain.corners;
        for (std::size_t i = 1; i < corners.size(); ++i) {
            cpShape* const shape =
                cpSegmentShapeNew(cpSpaceGetStaticBody(space), vector_of(corners[i - 1]), vector_of(corners[i]), 0);
            if (corners.size() > 2) {
                Vec2 const before = i > 1 ? corners[i - 2] : Vec2(2 * corners[0] - corners[1]);
                Vec2 const after = i + 1 < corners.size() ? corners[i + 1] : Vec2(2 * corners[i] - corners[i - 1]);
                cpSegmentShapeSetNeighbors(shape, vector_of(before), vector_of(after));
            }
            add_ground(shape, chain.material, share);
        }
    }
    void add_ball(physics::Ball const& ball, Share const& share) {
        double const inertia = ball.inertia * ball.mass * ball.radius * ball.radius;
        cpBody* const body = cpSpaceAddBody(space, cpBodyNew(ball.mass, inertia));
        cpBodySetPosition(body, vector_of(ball.start.position));
        cpBodySetVelocity(body, vector_of(ball.start.velocity));
        cpBodySetAngularVelocity(body, ball.start.spin);
        cpShape* const shape = cpCircleShapeNew(body, ball.radius, cpvzero);
        cpShapeSetFriction(shape, share.friction);
        cpShapeSetElasticity(shape, share.restitution);
        shapes.push_back(cpSpaceAddShape(space, shape));
        balls.push_back(body);
    }
    Vec2 position_of(cpBody* ball) const {
        cpVect const at = cpBodyGetPosition(ball);
        return {at.x, at.y};
    }
    void add(std::vector<Vec2>& to) const {
        for (cpBody* const ball : balls) to.push_back(position_of(ball));
    }
    void add(std::vector<physics::State>& to) const {
        for (cpBody* const ball : balls) {
            cpVect const velocity = cpBodyGetVelocity(ball);
            to.push_back(
                {position_of(ball), {velocity.x, velocity.y}, cpBodyGetAngle(ball), cpBodyGetAngularVelocity(ball)});
        }
    }
    bool has_run_away() const {
        return std::any_of(balls.begin(), balls.end(),
                           [&](cpBody* const ball) { return !(geometry::length(position_of(ball)) < run_away); });
    }
};

class ChipmunkEngine : public Engine {
public:
    ChipmunkEngine(Contestant const& contestant, Task const& task)
        : rate_(contestant.rate), chipmunk_(task.scene, contestant.pieces) {
        if (!task.pull) return;
        double const omega = 2 * geometry::pi * task.scene.drag.frequency, mass = task.scene.balls[0].mass;
        chipmunk_.spring = cpSpaceAddConstraint(
            chipmunk_.space,
            cpDampedSpringNew(cpSpaceGetStaticBody(chipmunk_.space), chipmunk_.balls[0], vector_of(task.pull->target),
                              cpvzero, 0, mass * omega * omega, 2 * mass * omega * task.scene.drag.damping));
    }
    std::vector<Vec2> positions_at(std::vector<double> const& times) override { return at<Vec2>(times); }
    std::vector<physics::State> states_at(std::vector<double> const& times) override {
        return at<physics::State>(times);
    }

private:
    template <typename Wanted>
    std::vector<Wanted> at(std::vector<double> const& times) {
        std::vector<Wanted> answers;
        for (double const time : times) {
            for (; static_cast<double>(steps_) < time * rate_ - 0.5; ++steps_) cpSpaceStep(chipmunk_.space, 1 / rate_);
            chipmunk_.add(answers);
            if (chipmunk_.has_run_away()) return {};
        }
        return answers;
    }

    double rate_;
    ChipmunkWorld chipmunk_;
    long steps_ = 0;
};

class ChipmunkPile : public Pile {
public:
    ChipmunkPile(physics::Scene const& scene, int iterations) : chipmunk_(scene) {
        cpSpaceSetIterations(chipmunk_.space, iterations);
    }
    void frame() override { cpSpaceStep(chipmunk_.space, 1 / 60.0); }
    std::vector<Vec2> positions() const override {
        std::vector<Vec2> positions;
        chipmunk_.add(positions);
        return positions;
    }

private:
    ChipmunkWorld chipmunk_;
};

bool const is_known =
    make_known<ChipmunkEngine, ChipmunkPile>("Chipmunk", {{"10 iterations", 10}, {"40 iterations", 40}});

}  // namespace

}  // namespace bench
