#include "bench_truth.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace bench {

namespace {

using Real = long double;

Real along(Point const& a, Point const& b) { return a.x * b.x + a.y * b.y; }
Point point(Vec2 const& v) { return {v.x(), v.y()}; }

template <typename Position>
std::vector<Moment> one_ball(Task const& task, Position const& position) {
    std::vector<Moment> truth;
    for (double const time : frame_times(task.duration)) truth.push_back({position(Real(time))});
    return truth;
}

// Way along a line under constant acceleration, sliding first and rolling once slip has ended.
struct Travel {
    Real speed = 0, sliding = 0, until = INFINITY, rolling = 0;
    Real way(Real t) const {
        Real const first = std::min(t, until);
        Real const rest = t - first;
        return speed * first + sliding * first * first / 2 + (speed + sliding * first) * rest +
               rolling * rest * rest / 2;
    }
};

Travel travel_of(Real speed, Real slip, Real pull, Real most_friction, Real k) {
    Travel travel{speed, 0, 0, pull / (1 + k)};
    bool const grips = k * std::fabs(pull) / (1 + k) <= most_friction;
    Real const sense = std::fabs(slip) > 1e-12L ? slip : grips ? 0 : pull;
    if (sense == 0) return travel;
    Real const friction = -std::copysign(most_friction, sense);
    Real const change = pull + friction * (1 + 1 / k);
    travel.sliding = pull + friction;
    travel.until = slip * change < 0 && std::fabs(slip) > 1e-12L ? -slip / change : INFINITY;
    if (!grips && std::isfinite(travel.until)) travel.rolling = pull - std::copysign(most_friction, pull);
    return travel;
}

}  // namespace

std::vector<Moment> truth_on_line(Task const& task, geometry::Segment const& line) {
    physics::Ball const& ball = task.scene.balls[0];
    Point const from = point(line.start);
    Point const span = {line.end.x() - from.x, line.end.y() - from.y};
    Real const length = std::hypot(span.x, span.y);
    Point t = {span.x / length, span.y / length};
    Point const reach = {ball.start.position.x() - from.x, ball.start.position.y() - from.y};
    if (t.x * reach.y - t.y * reach.x < 0) t = {-t.x, -t.y};
    Point const n = {-t.y, t.x};
    Real const q = along(reach, t);
    Real const speed = along(point(ball.start.velocity), t);
    Real const slip = speed + Real(ball.radius) * ball.start.spin;
    Real const g = task.scene.gravity;
    Real const most = task.scene.terrain.pieces[0].material.friction * g * n.y;
    Travel const travel = travel_of(speed, slip, -g * t.y, most, ball.inertia);
    return one_ball(task, [&](Real time) {
        Real const s = q + travel.way(time);
        return Point{from.x + s * t.x + ball.radius * n.x, from.y + s * t.y + ball.radius * n.y};
    });
}

std::vector<Moment> truth_of_bounces(Task const& task, double floor, double restitution) {
    physics::Ball const& ball = task.scene.balls[0];
    Real const g = task.scene.gravity, e = restitution;
    Real const height = Real(ball.start.position.y()) - floor - ball.radius;
    Real const first = std::sqrt(2 * height / g), impact = g * first;
    return one_ball(task, [&](Real time) {
        Real y = height - g * time * time / 2;
        if (time > first) {
            Real since = time - first, speed = e * impact;
            while (speed > 1e-15L && since > 2 * speed / g) {
                since -= 2 * speed / g;
                speed *= e;
            }
            y = speed > 1e-15L ? speed * since - g * since * since / 2 : 0;
        }
        return Point{ball.start.position.x(), floor + Real(ball.radius) + y};
    });
}

std::vector<Moment> truth_on_spring(Task const& task) {
    physics::State const& start = task.scene.balls[0].start;
    Real const pi = std::acos(Real(-1));
    Real const omega = 2 * pi * task.scene.drag.frequency, decay = omega * task.scene.drag.damping;
    std::complex<Real> const swing = std::sqrt(std::complex<Real>(omega * omega - decay * decay));
    Point const rest = {task.pull->target.x(), task.pull->target.y() - task.scene.gravity / (omega * omega)};
    auto const axis = [&](Real from, Real speed, Real t) {
        Real const sine = std::abs(swing) * t < 1e-6L ? t : (std::sin(swing * t) / swing).real();
        return std::exp(-decay * t) * (from * std::cos(swing * t).real() + (speed + decay * from) * sine);
    };
    return one_ball(task, [&](Real t) {
        return Point{rest.x + axis(start.position.x() - rest.x, start.velocity.x(), t),
                     rest.y + axis(start.position.y() - rest.y, start.velocity.y(), t)};
    });
}

namespace {

// The polar angle of a disc that rolls about a centre; `outside` of the circle or inside.
struct Roller {
    Real phi = 0, rate = 0;
    Real g = 0, rho = 0, k = 0;
    bool outside = false;

    Real acceleration(Real at) const { return -g * std::cos(at) / ((1 + k) * rho); }
    Real press() const {
        return outside ? g * std::sin(phi) - rho * rate * rate : rho * rate * rate - g * std::sin(phi);
    }
    Roller after(Real h) const {
        Real const a1 = acceleration(phi), r2 = rate + h / 2 * a1;
        Real const a2 = acceleration(phi + h / 2 * rate), r3 = rate + h / 2 * a2;
        Real const a3 = acceleration(phi + h / 2 * r2), r4 = rate + h * a3;
        Real const a4 = acceleration(phi + h * r3);
        Roller next = *this;
        next.phi += h / 6 * (rate + 2 * r2 + 2 * r3 + r4);
        next.rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        return next;
    }
};

struct Launch {
    Real time = INFINITY;  // s
    Point position, velocity;
};

Launch launch_from(Roller const& roller, Real time, Real step, Point const& centre) {
    Real low = 0, high = step;
    for (int i = 0; i < 70; ++i) {
        Real const middle = (low + high) / 2;
        (roller.after(middle).press() < 0 ? high : low) = middle;
    }
    Roller const last = roller.after(high);
    Real const c = std::cos(last.phi), s = std::sin(last.phi), v = last.rho * last.rate;
    return {time + high, {centre.x + last.rho * c, centre.y + last.rho * s}, {-v * s, v * c}};
}

Roller roller_of(Task const& task, geometry::Arc const& arc) {
    physics::Ball const& ball = task.scene.balls[0];
    Real const x = Real(ball.start.position.x()) - arc.centre.x(), y = Real(ball.start.position.y()) - arc.centre.y();
    Roller roller;
    roller.outside = std::hypot(x, y) > arc.radius;
    roller.phi = std::atan2(y, x);
    roller.g = task.scene.gravity;
    roller.k = ball.inertia;
    roller.rho = Real(arc.radius) + (roller.outside ? ball.radius : -ball.radius);
    roller.rate =
        (ball.start.velocity.y() * std::cos(roller.phi) - ball.start.velocity.x() * std::sin(roller.phi)) / roller.rho;
    return roller;
}

}  // namespace

std::vector<Moment> truth_on_circle(Task const& task, geometry::Arc const& arc, int steps_per_frame) {
    Roller roller = roller_of(task, arc);
    Point const centre = point(arc.centre);
    Real const step = Real(1) / frames_per_second / steps_per_frame, g = roller.g;
    Launch launch;
    std::vector<Moment> truth;
    for (std::size_t frame = 0; frame < frame_times(task.duration).size(); ++frame) {
        for (int i = 0; i < steps_per_frame && std::isinf(launch.time); ++i) {
            Roller const next = roller.after(step);
            if (next.press() < 0)
                launch = launch_from(roller, (Real(frame) * steps_per_frame + i) * step, step, centre);
            roller = next;
        }
        Real const t = Real(frame + 1) / frames_per_second - launch.time;
        if (std::isinf(launch.time))
            truth.push_back(
                {{centre.x + roller.rho * std::cos(roller.phi), centre.y + roller.rho * std::sin(roller.phi)}});
        else
            truth.push_back({{launch.position.x + launch.velocity.x * t,
                              launch.position.y + launch.velocity.y * t - g * t * t / 2}});
    }
    return truth;
}

std::vector<Moment> truth_at_wall(Task const& task, double wall) {
    physics::Ball const& ball = task.scene.balls[0];
    Real const from = ball.start.position.x(), most = Real(wall) - ball.radius;
    return one_ball(task, [&](Real t) {
        Real const x = from + ball.start.velocity.x() * t;
        return Point{x > most ? 2 * most - x : x, ball.start.position.y()};
    });
}

std::vector<Moment> truth_of_blows(Task const& task, double restitution) {
    auto const& balls = task.scene.balls;
    std::vector<Real> x, v;
    for (physics::Ball const& ball : balls) {
        x.push_back(ball.start.position.x());
        v.push_back(ball.start.velocity.x());
    }
    Real now = 0;
    std::vector<Moment> truth;
    for (double const time : frame_times(task.duration)) {
        for (;;) {
            Real soonest = time - now;
            std::size_t which = 0;
            for (std::size_t i = 1; i < x.size(); ++i) {
                Real const gap = x[i] - x[i - 1] - balls[i].radius - balls[i - 1].radius, closing = v[i - 1] - v[i];
                if (closing <= 0 || std::max<Real>(gap, 0) / closing > soonest) continue;
                soonest = std::max<Real>(gap, 0) / closing;
                which = i;
            }
            for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * soonest;
            now += soonest;
            if (which == 0) break;
            Real const m1 = balls[which - 1].mass, m2 = balls[which].mass;
            Real const impulse = (1 + Real(restitution)) * (v[which - 1] - v[which]) / (1 / m1 + 1 / m2);
            v[which - 1] -= impulse / m1;
            v[which] += impulse / m2;
        }
        Moment moment;
        for (std::size_t i = 0; i < x.size(); ++i) moment.push_back({x[i], balls[i].start.position.y()});
        truth.push_back(moment);
    }
    return truth;
}

}  // namespace bench
