#include "physics/steps_along.h"

#include <algorithm>
#include <cmath>

namespace physics {

namespace {

constexpr int most_changes = 8;           // of phase within one substep; more means it is at rest for our purposes
constexpr double no_slip_at_all = 1e-14;  // m/s

double side_of(double x) { return x < 0 ? -1 : 1; }

// The acceleration along the track but for friction.
double drive_at(Drive const& drive, Along const& now) {
    if (!drive.pulled) return drive.push;
    return drive.push - drive.spring.stiffness * (drive.offset + now.way) - 2 * drive.spring.decay * now.speed;
}

// The centre moves on with `mass` (1 sliding, 1 + k rolling) under the drive and a constant force beside it.
Along glided(Drive const& drive, Along along, double force, double mass, double time) {
    double const push = drive.push + force;
    double const before = along.speed;
    if (!drive.pulled) {
        along.speed += push / mass * time;
        along.way += 0.5 * (before + along.speed) * time;
        return along;
    }
    geometry::Oscillator const slower{drive.spring.decay / mass, drive.spring.stiffness / mass};
    double const equilibrium = push / drive.spring.stiffness - drive.offset;
    auto const basis = geometry::basis_at(slower, time);
    auto const swing = swing_after(slower, basis, {along.way - equilibrium, before});
    along.way = equilibrium + swing.displacement;
    along.speed = swing.rate;
    return along;
}

struct Progress {
    Along along;
    double time = 0;  // s, used
};

Progress rolled(Drive const& drive, Along along, double force, double time) {
    double const mu = drive.material.friction, k = drive.inertia;
    double const grip_left = mu * (1 + k) * drive.pressure - k * std::abs(force);
    double const resistance =
        std::clamp(drive.material.rolling_resistance * drive.pressure, 0.0, std::max(0.0, grip_left));
    if (along.speed == 0 && std::abs(force) <= resistance) return {along, time};
    double const against = -resistance * (along.speed != 0 ? side_of(along.speed) : side_of(force));
    Along next = glided(drive, along, against, 1 + k, time);
    if (resistance > 0 && along.speed * next.speed < 0) {
        time *= along.speed / (along.speed - next.speed);
        next = glided(drive, along, against, 1 + k, time);
        next.speed = 0;
    }
    next.rim = next.speed;
    next.rolled = along.rolled + (next.way - along.way);
    return {next, time};
}

Progress slid(Drive const& drive, Along along, double direction, double time) {
    double const friction = drive.material.friction * drive.pressure;
    double const rim_rate = friction * direction / drive.inertia;
    double const slip = along.speed - along.rim;
    auto const after = [&](double t) {
        Along next = glided(drive, along, -friction * direction, 1, t);
        next.rim = along.rim + rim_rate * t;
        next.rolled = along.rolled + 0.5 * (along.rim + next.rim) * t;
        return next;
    };
    Along next = after(time);
    double const slip_then = next.speed - next.rim;
    if (slip * slip_then >= 0) return {next, time};
    time *= slip / (slip - slip_then);
    next = after(time);
    next.rim = next.speed;
    return {next, time};
}

}  // namespace

bool slips(Along const& along) {
    return std::abs(along.speed - along.rim) > no_slip * (std::abs(along.speed) + std::abs(along.rim)) + no_slip_at_all;
}

Along after_moving(Drive const& drive, Along const& start, double time) {
    Along along = start;
    double const k = drive.inertia, mu = drive.material.friction;
    for (int i = 0; i < most_changes && time > 0; ++i) {
        bool const slipping = slips(along);
        if (slipping && std::isinf(mu)) along.speed = along.rim = (along.speed + k * along.rim) / (1 + k);
        double const force = drive_at(drive, along);
        bool const grips = std::isinf(mu) || (!slipping && k * std::abs(force) / (1 + k) <= mu * drive.pressure);
        if (grips || !slipping) along.rim = along.speed;
        double const direction = side_of(slipping ? along.speed - along.rim : force);
        Progress const progress = grips ? rolled(drive, along, force, time) : slid(drive, along, direction, time);
        along = progress.along;
        time -= progress.time;
    }
    return along;
}

}  // namespace physics
