#include "sound/hear.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sound/timbre.h"
#include "sound/tune.h"

namespace sound {

namespace {

using geometry::Vec2;
using physics::Event;
using physics::EventKind;
using physics::Phase;

constexpr double usual_radius = 0.4;  // m: of a ball that sounds at a timbre's own pitch
constexpr double grain = 0.022;       // m, of the ground under a ball of usual radius
constexpr double rolling_speed = 5;   // m/s, at which rolling is heard at two thirds of its loudness
constexpr double slipping_speed = 3;  // m/s
constexpr double icy = 0.1;           // friction below which ground is ice
constexpr double springy = 0.5;       // restitution above which it is rubber
constexpr double far_away = 8;        // m from the middle of the picture: to the side by `widest`
constexpr double widest = 0.6;
constexpr double whole_view = 16;  // m: a level that is no wider is shown whole (docs/game.md)

double share_of(double speed, double two_thirds) { return 1 - 1 / (1 + 2 * speed / two_thirds); }

double pan_at(game::Session const& session, Vec2 const& place, double time) {
    level::Level const& level = *session.level;
    double const middle = level.size.x() <= whole_view
                              ? level.size.x() / 2
                              : physics::state_at(session.history, level.player, time).position.x();
    return widest * std::clamp((place.x() - middle) / far_away, -1.0, 1.0);
}

physics::Ball const& ball_of(game::Session const& session, int ball) {
    return session.level->scene.balls[static_cast<std::size_t>(ball)];
}

// The velocity with which the ball came to a moment at which something happened to it.
Vec2 velocity_before(game::Session const& session, int ball, double time) {
    auto const& legs = session.history.legs[static_cast<std::size_t>(ball)];
    auto const after =
        std::partition_point(legs.begin(), legs.end(), [&](auto const& leg) { return leg.since < time; });
    return physics::at(after == legs.begin() ? *after : *(after - 1), time).velocity;
}

struct Stroke {
    Timbre timbre;
    double pitch;  // Hz, by a ball of usual radius
};

Stroke stroke_on(physics::Material const& material) {
    if (material.restitution > springy) return {Timbre::rubber, 120};
    if (material.friction < icy) return {Timbre::glass, 760};
    return {Timbre::wood, 270};
}

bool is_blow(Event const& event) {
    return event.kind == EventKind::land || event.kind == EventKind::bounce || event.kind == EventKind::hit;
}

std::optional<Note> blow_of(game::Session const& session, Event const& event, Clock const& clock) {
    physics::Ball const& ball = ball_of(session, event.ball);
    Vec2 const change = event.state.velocity - velocity_before(session, event.ball, event.time);
    double speed = geometry::length(change);
    double radius = ball.radius;
    bool const is_hit = event.kind == EventKind::hit && event.other >= 0;
    Stroke stroke{Timbre::marble, 1350};
    if (is_hit) {
        physics::Ball const& other = ball_of(session, event.other);
        speed *= (1 + ball.mass / other.mass) / 2;
        radius = std::min(radius, other.radius);
    } else if (event.contact.feature >= 0) {
        stroke = stroke_on(physics::material_of(session.level->scene.terrain, event.contact.feature));
    }
    double const loudness = loudness_of_blow(speed);
    if (loudness == 0) return std::nullopt;
    Note note;
    note.start = sample_at(clock, event.time);
    note.timbre = stroke.timbre;
    note.pitch = stroke.pitch * std::pow(usual_radius / radius, 0.6);
    note.loudness = loudness;
    note.brightness = std::clamp(0.25 + speed / 8, 0.0, 1.0);
    note.pan = pan_at(session, event.state.position, event.time);
    return note;
}

// A ball that is struck from two sides at once is heard once.
void add_blow(Score& score, Note const& note) {
    for (auto other = score.notes.rbegin(); other != score.notes.rend() && other->start >= note.start; ++other)
        if (other->start == note.start && other->timbre == note.timbre && other->pitch == note.pitch) return;
    score.notes.push_back(note);
}

template <typename Visit>
void each_event(game::Session const& session, double from, double until, Visit visit) {
    auto const& events = session.history.events;
    auto const first =
        std::partition_point(events.begin(), events.end(), [&](Event const& e) { return e.time <= from; });
    for (auto event = first; event != events.end() && event->time <= until; ++event) visit(*event);
}

double tension_at(game::Session const& session, double time) {
    physics::Forces const& forces = game::forces_at(session, time);
    if (!forces.pull || !(session.level->drag_reach > 0)) return 0;
    Vec2 const centre = physics::state_at(session.history, forces.pull->ball, time).position;
    return std::min(1.0, geometry::length(forces.pull->target - centre) / session.level->drag_reach);
}

void add_spring_notes(Score& score, game::Session const& session, Event const& event, Clock const& clock) {
    bool const is_taken = event.kind == EventKind::grab;
    // What is let go sounds by how far it was drawn just before.
    double const tension = is_taken ? 0.15 : tension_at(session, std::nextafter(event.time, -1));
    if (tension < 0.02) return;
    score.notes.push_back({sample_at(clock, event.time), Timbre::twang, is_taken ? 196 : 82 * (1 + tension),
                           is_taken ? 0.05 : 0.05 + 0.16 * tension, 0.3 + 0.7 * tension,
                           pan_at(session, event.state.position, event.time)});
}

void add_events(Score& score, game::Session const& session, double from, double until, Clock const& clock) {
    each_event(session, from, until, [&](Event const& event) {
        if (is_blow(event)) {
            if (auto const note = blow_of(session, event, clock)) add_blow(score, *note);
        } else if (event.kind == EventKind::grab || event.kind == EventKind::release) {
            add_spring_notes(score, session, event, clock);
        }
    });
}

struct Rung {
    int step;      // of the world's scale
    double after;  // s
    double loudness;
};

void add_chime(Score& score, World world, Timbre timbre, long long start, Rung const& rung, double pan) {
    score.notes.push_back(
        {start + std::llround(rung.after * rate), timbre, pitch_in(world, rung.step), rung.loudness, 1, pan});
}

// Up the world's own chord, and the chord once more.
constexpr Rung goal_rungs[] = {{7, 0, 0.16},     {9, 0.11, 0.16},  {11, 0.22, 0.16}, {14, 0.33, 0.2},
                               {11, 0.55, 0.13}, {14, 0.66, 0.16}, {16, 0.77, 0.16}, {7, 0.77, 0.12}};

void add_bananas(Score& score, game::Session const& session, double from, double until, Clock const& clock) {
    World const world = world_of(*session.level);
    for (std::size_t i = 0; i < session.noticed_at.size(); ++i) {
        double const time = session.noticed_at[i];
        if (session.level->meanings[i] != level::Meaning::banana || time <= from || time > until) continue;
        // The more of them, the higher: as the steps 1, 3, 5 and 8 of the scale.
        constexpr int chord[] = {0, 2, 4};
        int const before = game::status_at(session, time).bananas - 1;
        int const step = 14 + chord[before % 3] + 7 * std::min(before / 3, 1);
        add_chime(score, world, Timbre::pling, sample_at(clock, time), {step, 0, 0.15}, 0);
        add_chime(score, world, Timbre::pling, sample_at(clock, time), {step + 4, 0.07, 0.15}, 0);
    }
}

void add_rules(Score& score, game::Session const& session, double from, double until, Clock const& clock) {
    auto const happens = [&](std::optional<double> const& time) { return time && *time > from && *time <= until; };
    World const world = world_of(*session.level);
    add_bananas(score, session, from, until, clock);
    if (happens(session.goal_time))
        for (Rung const& rung : goal_rungs)
            add_chime(score, world, Timbre::bell, sample_at(clock, *session.goal_time), rung, 0);
    if (happens(session.fall_time))
        score.notes.push_back({sample_at(clock, *session.fall_time), Timbre::whistle, 1150, 0.13, 0.6, 0});
    auto const& limit = session.level->time_limit;
    bool const over_before = session.goal_time || session.fall_time;
    if (happens(limit) && !over_before)
        add_chime(score, world, Timbre::gong, sample_at(clock, *limit), {-7, 0, 0.3}, 0);
}

std::vector<int> heard_balls(level::Level const& level) {
    std::vector<int> balls{level.player};
    for (int i = 0; i < static_cast<int>(level.scene.balls.size()) && balls.size() < most_motions; ++i)
        if (i != level.player) balls.push_back(i);
    return balls;
}

// From terrain to ball, where it touches.
Vec2 normal_at(physics::Terrain const& terrain, physics::Contact const& contact, Vec2 const& centre) {
    Vec2 const foot =
        terrain.is_vertex(contact.feature)
            ? terrain.vertex(contact.feature).point
            : geometry::nearest_point(terrain.pieces[static_cast<std::size_t>(contact.feature)].curve, centre).point;
    Vec2 const way = centre - foot;
    double const distance = geometry::length(way);
    return distance > 0 ? Vec2(way / distance) : Vec2(Vec2::UnitY());
}

Motion motion_at(game::Session const& session, int index, double time) {
    physics::Ball const& ball = ball_of(session, index);
    physics::Leg const& leg = physics::leg_at(session.history, index, time);
    physics::State const state = physics::at(leg, time);
    Motion motion;
    // The same ground at the same place: rolling there and back sounds the same.
    motion.way = state.angle * ball.radius / (grain * std::sqrt(ball.radius / usual_radius));
    motion.pan = pan_at(session, state.position, time);
    auto const& pull = game::forces_at(session, time).pull;
    if (pull && pull->ball == index) motion.tension = tension_at(session, time);
    bool const touches = leg.phase == Phase::roll || leg.phase == Phase::slide;
    if (!touches || leg.contact.feature < 0) return motion;
    physics::Terrain const& terrain = session.level->scene.terrain;
    Vec2 const normal = normal_at(terrain, leg.contact, state.position);
    double const along = state.velocity.x() * normal.y() - state.velocity.y() * normal.x();
    double const rim = -ball.radius * state.spin;
    physics::Material const& material = physics::material_of(terrain, leg.contact.feature);
    bool const is_ice = material.friction < icy;
    motion.hardness = is_ice ? 0.8 : material.restitution > springy ? 0 : 0.15;
    motion.roll = (is_ice ? 0.16 : 0.3) * share_of(std::min(std::abs(along), std::abs(rim)), rolling_speed);
    if (leg.phase == Phase::slide) {
        double const slip = std::abs(along - rim);
        motion.slip = (is_ice ? 0.05 : 0.11) * share_of(slip, slipping_speed);
        motion.scrape = is_ice ? 0.9 : std::min(1.0, slip / 10);
    }
    return motion;
}

void add_rows(Score& score, game::Session const& session, double from, double until, Clock const& clock) {
    std::vector<int> const balls = heard_balls(*session.level);
    Motions& motions = score.motions;
    // The first row that is heard after `from`, and the last that is not after `until`.
    auto const row_after = [&](double time) {
        double const row =
            (static_cast<double>(clock.sample) + (time - clock.time) * clock.samples_a_second) / motion_step;
        return static_cast<long long>(std::floor(row)) + 1;
    };
    long long row = row_after(from);
    if (motions.rows.empty()) {
        motions.rows.resize(balls.size());
        motions.first = row;
    }
    row = motions.first + static_cast<long long>(motions.rows.front().size());
    for (long long const end = row_after(until); row < end; ++row) {
        double const offset = static_cast<double>(row * motion_step - clock.sample) / clock.samples_a_second;
        double const time = std::clamp(clock.time + offset, std::max(from, session.history.from), until);
        for (std::size_t i = 0; i < balls.size(); ++i) motions.rows[i].push_back(motion_at(session, balls[i], time));
    }
}

struct Red_green_blue {
    int red = 0, green = 0, blue = 0;
};
Red_green_blue parts_of(std::string const& colour) {
    if (colour.size() != 7) return {};
    auto const part = [&](std::size_t at) { return std::stoi(colour.substr(at, 2), nullptr, 16); };
    return {part(1), part(3), part(5)};
}

}  // namespace

long long sample_at(Clock const& clock, double time) {
    return clock.sample + std::llround((time - clock.time) * clock.samples_a_second);
}

double loudness_of_blow(double speed) {
    if (!(speed > faintest_blow)) return 0;
    double const over = speed - faintest_blow;
    return 0.5 * (1 - std::exp(-over / 3.5));
}

World world_of(level::Level const& level) {
    constexpr int dark = 3 * 70;  // of the three parts together
    std::vector<std::string> const &sky = level.look.sky, &hills = level.look.hills;
    if (!sky.empty()) {
        Red_green_blue const above = parts_of(sky.front());
        if (sky.front() != level::no_colour && above.red + above.green + above.blue < dark) return World::night;
    }
    if (hills.empty()) return World::meadow;
    Red_green_blue const near = parts_of(hills.back());
    if (near.red > near.green) return World::desert;
    return near.blue > near.green ? World::ice : World::meadow;
}

void hear(Score& score, game::Session const& session, double from, double until, Clock const& clock) {
    add_events(score, session, from, until, clock);
    add_rules(score, session, from, until, clock);
    add_rows(score, session, from, until, clock);
    std::stable_sort(score.notes.begin(), score.notes.end(),
                     [](Note const& a, Note const& b) { return a.start < b.start; });
}

}  // namespace sound
