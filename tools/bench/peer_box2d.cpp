// Box2D 2.4.1 (libbox2d-dev): its own chains, discs and mouse joint; 8 and 3 iterations, as its manual advises.
#include <algorithm>

#include <box2d/box2d.h>

#include "bench_engine.h"
#include "geometry/elementary.h"

namespace bench {

namespace {

constexpr int velocity_iterations = 8, position_iterations = 3;

b2Vec2 vector_of(Vec2 const& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

// Box2D takes the root of the product of frictions and the larger restitution; ours takes the surface's alone.
void give_material(b2Fixture& fixture, physics::Material const& material, double ball_friction) {
    double const friction = std::min(material.friction, 1e6);
    fixture.SetFriction(static_cast<float>(ball_friction > 0 ? friction * friction / ball_friction : 0));
    fixture.SetRestitution(static_cast<float>(material.restitution));
}

void add_chain(b2Body& ground, Chain chain, double ball_friction) {
    std::reverse(chain.corners.begin(), chain.corners.end());  // its chains are touched from the right
    std::vector<b2Vec2> corners;
    for (Vec2 const& corner : chain.corners) corners.push_back(vector_of(corner));
    b2EdgeShape edge;
    b2ChainShape line;
    b2Shape const* shape = &line;
    int const count = static_cast<int>(corners.size());
    if (count == 2) {
        edge.SetTwoSided(corners[0], corners[1]);
        shape = &edge;
    } else if (chain.closed) {
        line.CreateLoop(corners.data(), count - 1);
    } else {
        line.CreateChain(corners.data(), count, 2 * corners[0] - corners[1],
                         2 * corners[count - 1] - corners[count - 2]);
    }
    give_material(*ground.CreateFixture(shape, 0), chain.material, ball_friction);
}

struct Box2dWorld {
    b2World world;
    std::vector<b2Body*> balls;

    explicit Box2dWorld(physics::Scene const& scene, int pieces = peer_pieces)
        : world({0, static_cast<float>(-scene.gravity)}) {
        bool const alone = scene.balls.size() == 1;
        double const friction = alone ? 1 : scene.balls[0].friction;
        b2BodyDef nailed;
        b2Body* const ground = world.CreateBody(&nailed);
        for (Chain const& chain : chains_of(scene, pieces)) add_chain(*ground, chain, friction);
        for (Boulder const& boulder : boulders_of(scene)) {
            b2CircleShape disc;
            disc.m_p = vector_of(boulder.arc.centre);
            disc.m_radius = static_cast<float>(boulder.arc.radius);
            give_material(*ground->CreateFixture(&disc, 0), boulder.material, friction);
        }
        for (physics::Ball const& ball : scene.balls) add_ball(ball, friction, alone ? 0 : ball.restitution);
    }

    void add_ball(physics::Ball const& ball, double friction, double restitution) {
        b2BodyDef body;
        body.type = b2_dynamicBody;
        body.position = vector_of(ball.start.position);
        body.linearVelocity = vector_of(ball.start.velocity);
        body.angularVelocity = static_cast<float>(ball.start.spin);
        body.allowSleep = false;
        b2CircleShape disc;
        disc.m_radius = static_cast<float>(ball.radius);
        b2FixtureDef fixture;
        fixture.shape = &disc;
        fixture.density = static_cast<float>(ball.mass / (geometry::pi * ball.radius * ball.radius));
        fixture.friction = static_cast<float>(friction);
        fixture.restitution = static_cast<float>(restitution);
        balls.push_back(world.CreateBody(&body));
        balls.back()->CreateFixture(&fixture);
    }

    void add(std::vector<Vec2>& to) const {
        for (b2Body const* const ball : balls) to.push_back({ball->GetPosition().x, ball->GetPosition().y});
    }
    void add(std::vector<physics::State>& to) const {
        for (b2Body const* const ball : balls) {
            b2Vec2 const at = ball->GetPosition(), velocity = ball->GetLinearVelocity();
            to.push_back({{at.x, at.y}, {velocity.x, velocity.y}, ball->GetAngle(), ball->GetAngularVelocity()});
        }
    }
};

class Box2dEngine : public Engine {
public:
    Box2dEngine(Contestant const& contestant, Task const& task)
        : rate_(contestant.rate), box_(task.scene, contestant.pieces) {
        if (task.pull) pull(task);
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
            for (; static_cast<double>(steps_) < time * rate_ - 0.5; ++steps_)
                box_.world.Step(static_cast<float>(1 / rate_), velocity_iterations, position_iterations);
            box_.add(answers);
        }
        return answers;
    }
    void pull(Task const& task) {
        b2BodyDef nailed;
        b2MouseJointDef joint;
        joint.bodyA = box_.world.CreateBody(&nailed);
        joint.bodyB = box_.balls[0];
        joint.target = box_.balls[0]->GetPosition();
        joint.maxForce = 1e9f;
        b2LinearStiffness(joint.stiffness, joint.damping, static_cast<float>(task.scene.drag.frequency),
                          static_cast<float>(task.scene.drag.damping), joint.bodyA, joint.bodyB);
        static_cast<b2MouseJoint*>(box_.world.CreateJoint(&joint))->SetTarget(vector_of(task.pull->target));
    }

    double rate_;
    Box2dWorld box_;
    long steps_ = 0;
};

class Box2dPile : public Pile {
public:
    Box2dPile(physics::Scene const& scene, int iterations) : box_(scene), iterations_(iterations) {}
    void frame() override { box_.world.Step(1 / 60.0f, iterations_, std::max(3, iterations_ * 3 / 8)); }
    std::vector<Vec2> positions() const override {
        std::vector<Vec2> positions;
        box_.add(positions);
        return positions;
    }

private:
    Box2dWorld box_;
    int iterations_;
};

bool const is_known = make_known<Box2dEngine, Box2dPile>("Box2D", {{"8 iterations", 8}, {"32 iterations", 32}});

}  // namespace

}  // namespace bench
