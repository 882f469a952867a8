#include "reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace laws {

namespace {

using Real = long double;

struct Vector {
    Real x = 0, y = 0;
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(Real s, Vector a) { return {s * a.x, s * a.y}; }
Real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
Real length(Vector a) { return std::sqrt(dot(a, a)); }
Vector real(geometry::Vec2 const& v) { return {v.x(), v.y()}; }

// The point of the curve that is nearest.
Vector foot_on(geometry::Segment const& line, Vector from) {
    Vector const start = real(line.start), along = real(line.end) - start;
    Real const share = std::clamp<Real>(dot(from - start, along) / dot(along, along), 0, 1);
    return start + share * along;
}

Vector foot_on(geometry::Arc const& arc, Vector from) {
    constexpr Real turn = 2 * std::numbers::pi_v<Real>;
    Vector const centre = real(arc.centre), d = from - centre;
    Real const sweep = arc.sweep;
    Real gone = std::fmod((std::atan2(d.y, d.x) - static_cast<Real>(arc.from)) * (sweep < 0 ? -1 : 1), turn);
    if (gone < 0) gone += turn;
    Real angle = gone;
    if (gone > std::abs(sweep)) angle = gone - std::abs(sweep) < turn - gone ? std::abs(sweep) : 0;
    angle = static_cast<Real>(arc.from) + (sweep < 0 ? -angle : angle);
    return centre + static_cast<Real>(arc.radius) * Vector{std::cos(angle), std::sin(angle)};
}

struct Mover {
    physics::Scene const& scene;
    physics::Forces const& forces;
    Vector place, velocity;
    Real angle = 0, spin = 0;

    Vector acceleration() const {
        Real const tilt = forces.tilt, gravity = scene.gravity;
        Vector a{gravity * std::sin(tilt), -gravity * std::cos(tilt)};
        if (!forces.pull) return a;
        Real const omega = 2 * std::numbers::pi_v<Real> * static_cast<Real>(scene.drag.frequency);
        return a + omega * omega * (real(forces.pull->target) - place) -
               (2 * static_cast<Real>(scene.drag.damping) * omega) * velocity;
    }

    // Out of the piece, and an impulse with restitution and friction if the ball closes on it (r = radius, k = I / m
    // r^2).
    void meet(physics::Piece const& piece, Real slow) {
        physics::Ball const& ball = scene.balls.front();
        Real const radius = ball.radius, k = ball.inertia;
        Vector const d = place - std::visit([&](auto const& curve) { return foot_on(curve, place); }, piece.curve);
        Real const distance = length(d);
        if (distance >= radius) return;
        Vector const normal = (1 / distance) * d, tangent{normal.y, -normal.x};
        place = place + (radius - distance) * normal;
        Real const closing = -dot(velocity, normal);
        if (closing <= 0) return;
        Real const e = closing > slow ? piece.material.restitution : 0, pressed = (1 + e) * closing;
        Real const wanted = -(dot(velocity, tangent) + radius * spin) * k / (1 + k);
        Real const most = static_cast<Real>(std::min(piece.material.friction, 1e9)) * pressed;
        Real const rubbed = std::clamp(wanted, -most, most);
        velocity = velocity + pressed * normal + rubbed * tangent;
        spin += rubbed / (k * radius);
        if (std::abs(wanted) > most) return;  // rolling resistance acts while rolling only
        Real const resisted = piece.material.rolling_resistance * pressed / (k * radius);
        spin -= std::clamp(spin, -resisted, resisted);
    }

    void step(Real h) {
        Vector const a = acceleration();
        place = place + h * velocity + (h * h / 2) * a;
        velocity = velocity + h * a;
        angle += h * spin;
        for (physics::Piece const& piece : scene.terrain.pieces) meet(piece, 4 * h * length(a));
    }
};

}  // namespace

physics::State reference_after(physics::Scene const& scene, physics::Forces const& forces, double time, double step) {
    physics::State const& start = scene.balls.front().start;
    Mover mover{scene, forces, real(start.position), real(start.velocity), start.angle, start.spin};
    long long const steps = std::llround(time / step);
    for (long long i = 0; i < steps; ++i) mover.step(static_cast<Real>(time) / static_cast<Real>(steps));
    auto const plain = [](Vector v) { return geometry::Vec2(static_cast<double>(v.x), static_cast<double>(v.y)); };
    return {plain(mover.place), plain(mover.velocity), static_cast<double>(mover.angle),
            static_cast<double>(mover.spin)};
}

}  // namespace laws
