#include "view/wake.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "view/path_mean.h"

namespace view {

namespace {

constexpr double loose_span = 0.5, spin_span = 0.3, trail_span = 0.25;  // s
constexpr double trail_spacing = 1.0 / 60, dust_spacing = 1.0 / 45;     // s
constexpr double dust_life = 0.55, spark_life = 0.4;                    // s
constexpr double least_slip = 0.5;                                      // m/s that raises dust
constexpr double hard_impact = 3;                                       // m/s by which a velocity jumps: sparks
constexpr double quick = 12, quickest = 30;  // radii a second: where a trail begins, is whole
static_assert(std::max({loose_span, dust_life, spark_life, spin_span}) < wake_memory);

// 0 to 1, of a number and a use of it.
double luck(std::int64_t number, int use) {
    auto key = static_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(use);
    key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9u;
    key = (key ^ key >> 27) * 0x94d049bb133111ebu;
    return static_cast<double>((key ^ key >> 31) >> 11) / 9007199254740992.0;
}

double share_of(double x, double low, double high) { return std::clamp((x - low) / (high - low), 0.0, 1.0); }

double loose_share(physics::Trail<physics::Leg> const& legs, double time) {
    double share = 0, end = time;
    for (auto leg = legs.end(); leg != legs.begin() && end > time - loose_span;) {
        --leg;
        if (leg->since >= end) continue;
        bool const loose = leg->phase == physics::Phase::flight || leg->phase == physics::Phase::slide;
        if (loose) share += weight_below(time - leg->since, loose_span) - weight_below(time - end, loose_span);
        end = leg->since;
    }
    return share;
}

struct Rub {
    Vec2 place = Vec2::Zero();   // m, where it touches
    Vec2 normal = Vec2::Zero();  // unit
    double slip = 0;             // m/s, of the ball's rim along (n.y, -n.x)
};

Rub rub_of(level::Level const& level, physics::Leg const& leg, physics::State const& state, double radius) {
    physics::Terrain const& terrain = level.scene.terrain;
    if (leg.contact.feature < 0 || !physics::fits(terrain, leg.contact, radius)) return {};
    physics::Track const track = physics::track_of(terrain, leg.contact, radius);
    Vec2 const normal = physics::normal_at(track, physics::nearest_coordinate(track, state.position));
    double const along = geometry::dot(state.velocity, geometry::turned_right(normal));
    return {state.position - radius * normal, normal, along + radius * state.spin};
}

void add_dust(Wake& wake, level::Level const& level, physics::History const& history, int ball, double time) {
    double const radius = level.scene.balls[static_cast<std::size_t>(ball)].radius;
    double const first = std::max({time - dust_life, history.from, 0.0});
    for (double i = std::floor(time / dust_spacing); i * dust_spacing > first; --i) {
        double const then = i * dust_spacing;
        physics::Leg const& leg = physics::leg_at(history, ball, then);
        if (leg.phase != physics::Phase::slide) continue;
        Rub const rub = rub_of(level, leg, physics::at(leg, then), radius);
        if (std::abs(rub.slip) < least_slip) continue;
        auto const number = static_cast<std::int64_t>(i) * 64 + ball;
        double const age = (time - then) / dust_life,
                     size = radius * (0.12 + 0.3 * age) * (0.7 + 0.6 * luck(number, 0));
        // Thrown the way that the rim goes, then slower and slower.
        Vec2 const way = std::clamp(0.3 * rub.slip, -2.0, 2.0) * geometry::turned_right(rub.normal) +
                         radius * (0.8 + 2 * luck(number, 1)) * rub.normal;
        wake.dust.push_back({rub.place + dust_life * age * (1 - age / 2) * way + size * rub.normal, way, age, size});
    }
}

void add_sparks(Wake& wake, level::Level const& level, physics::History const& history, int ball, double time) {
    constexpr double just_before = 1e-6;  // s
    constexpr int most_impacts = 3;
    double const radius = level.scene.balls[static_cast<std::size_t>(ball)].radius;
    int impacts = 0;
    for (auto event = history.events.end(); event != history.events.begin() && impacts < most_impacts;) {
        --event;
        if (event->time > time) continue;
        if (event->time <= time - spark_life) break;
        using enum physics::EventKind;
        bool const is_impact = event->kind == bounce || event->kind == land || event->kind == hit;
        if (!is_impact || (event->ball != ball && !(event->kind == hit && event->other == ball))) continue;
        double const before = std::max(event->time - just_before, history.from);
        physics::State const after = physics::state_at(history, ball, event->time);
        Vec2 const jump = after.velocity - physics::state_at(history, ball, before).velocity;
        double const hardness = geometry::length(jump);
        if (hardness < hard_impact) continue;
        ++impacts;
        Vec2 const out = jump / hardness;
        double const elapsed = time - event->time, age = elapsed / spark_life;
        int const count = static_cast<int>(std::min(5 + 1.5 * (hardness - hard_impact), 14.0));
        for (int i = 0; i < count; ++i) {
            auto const number = static_cast<std::int64_t>(event->time * 1e6) * 64 + i;
            double const aside = 2.6 * (luck(number, 2) - 0.5), speed = radius * (4 + 8 * luck(number, 3));
            Vec2 const way = speed * geometry::turned(out, std::cos(aside), std::sin(aside));
            Vec2 const place = after.position - radius * out + elapsed * (1 - age / 2) * way;
            wake.sparks.push_back({place, way, age, 0.07 * radius});
        }
    }
}

}  // namespace

Wake wake_of(level::Level const& level, physics::History const& history, int ball, double time) {
    Wake wake;
    double const radius = level.scene.balls[static_cast<std::size_t>(ball)].radius;
    auto const state = [&](double age) { return physics::state_at(history, ball, std::max(time - age, history.from)); };
    physics::State const now = state(0);
    wake.loose = loose_share(history.legs[static_cast<std::size_t>(ball)], time);
    wake.spin = (now.angle - state(spin_span).angle) / spin_span;
    // A difference of two mean velocities, each over 0.15 s.
    constexpr double mean = 0.15, apart = 0.2;
    wake.push =
        (now.position - state(mean).position - state(apart).position + state(apart + mean).position) / (mean * apart);
    double const speed = geometry::length(now.position - state(mean).position) / mean;
    wake.haste = share_of(speed / radius, quick, quickest);
    if (wake.haste > 0) {
        double const first = std::max({time - trail_span, history.from, 0.0});
        for (double i = std::ceil(first / trail_spacing); i * trail_spacing < time; ++i)
            wake.trail.push_back(physics::state_at(history, ball, i * trail_spacing).position);
        wake.trail.push_back(now.position);
    }
    add_dust(wake, level, history, ball, time);
    add_sparks(wake, level, history, ball, time);
    return wake;
}

}  // namespace view
