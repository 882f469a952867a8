#include "physics/world/sensors.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/motion/leg_bounds.h"

namespace physics {

namespace {

// m: what is nearer to the limit than this all along is on it. Ends grazing in a sliver that bounds cannot tell apart.
constexpr double length_rounding = 1e-12;

// Legs in a row in a window of time, and a disc that holds them: a part of the ball's way like a part of a leg, if
// rougher.
struct Stretch {
    std::size_t first = 0, last = 0;  // legs [first, last)
    Vec2 centre = Vec2::Zero();
    double radius = never;  // m

    Range along(Vec2 const& origin, Vec2 const& direction) const {
        double const middle = geometry::dot(centre - origin, direction);
        return {middle - radius, middle + radius};
    }
    Range distance_from(Vec2 const& point) const {
        double const middle = geometry::length(centre - point);
        return {middle - radius, middle + radius};
    }
};

// Each watch tells what one region notices: nothing on any of a part of a ball's way, everything all along a part of a
// leg, or the step from one place to the next.

struct Entry {
    DiscRegion const& disc;
    double reach;  // m, from the disc's centre

    Entry(DiscRegion const& of, double rim) : disc(of), reach(of.radius + rim + sensor_accuracy) {}
    template <typename Part>
    bool misses(Part const& part) const {
        return part.distance_from(disc.centre).low > reach;
    }
    bool holds(LegPart const& part) const { return part.distance_from(disc.centre).high <= reach + length_rounding; }
    bool notices(Vec2 const&, Vec2 const& now) const { return geometry::length(now - disc.centre) <= reach; }
};

// One edge of a counter-clockwise polygon: heights are positive outside.
struct Edge {
    Vec2 from, outward;

    Edge(PolygonRegion const& polygon, std::size_t i) : from(polygon.corners[i]) {
        Vec2 const way = polygon.corners[(i + 1) % polygon.corners.size()] - from;
        outward = geometry::turned_right(way) / geometry::length(way);
    }
    template <typename Part>
    Range heights(Part const& part) const {
        return part.along(from, outward);
    }
    double height(Vec2 const& place) const { return geometry::dot(place - from, outward); }
};

struct EntryToPolygon {
    PolygonRegion const& polygon;

    template <typename Test>
    bool any_edge(Test&& test) const {
        for (std::size_t i = 0; i < polygon.corners.size(); ++i)
            if (test(Edge(polygon, i))) return true;
        return false;
    }
    template <typename Part>
    bool misses(Part const& part) const {
        return any_edge([&](Edge const& edge) { return edge.heights(part).low > sensor_accuracy; });
    }
    bool holds(LegPart const& part) const {
        // Not <=, so that what is no number holds nothing.
        return !any_edge(
            [&](Edge const& edge) { return !(edge.heights(part).high <= sensor_accuracy + length_rounding); });
    }
    bool notices(Vec2 const&, Vec2 const& now) const {
        return !any_edge([&](Edge const& edge) { return !(edge.height(now) <= sensor_accuracy); });
    }
};

struct ExitFromPolygon {
    EntryToPolygon inside;

    template <typename Part>
    bool misses(Part const& part) const {
        return !inside.any_edge([&](Edge const& edge) { return !(edge.heights(part).high < -sensor_accuracy); });
    }
    bool holds(LegPart const& part) const {
        return inside.any_edge(
            [&](Edge const& edge) { return edge.heights(part).low >= -sensor_accuracy - length_rounding; });
    }
    bool notices(Vec2 const&, Vec2 const& now) const {
        return inside.any_edge([&](Edge const& edge) { return edge.height(now) >= -sensor_accuracy; });
    }
};

struct Crossing {
    Vec2 from, along, normal;
    double span;  // m

    explicit Crossing(LineRegion const& line) : from(line.from) {
        span = geometry::length(line.to - line.from);
        along = (line.to - line.from) / span;
        normal = geometry::turned_left(along);
    }
    template <typename Part>
    bool misses(Part const& part) const {
        Range const heights = part.along(from, normal);
        if (heights.low > sensor_accuracy || heights.high < -sensor_accuracy) return true;
        Range const ways = part.along(from, along);
        return ways.low > span + sensor_accuracy || ways.high < -sensor_accuracy;
    }
    bool holds(LegPart const& part) const {
        double const most = sensor_accuracy + length_rounding;
        Range const heights = part.along(from, normal);
        if (!(heights.low >= -most && heights.high <= most)) return false;
        Range const ways = part.along(from, along);
        return ways.low >= -most && ways.high <= span + most;
    }
    bool notices(Vec2 const& before, Vec2 const& now) const {
        double const height = geometry::dot(now - from, normal), way = geometry::dot(now - from, along);
        if (!(way >= -sensor_accuracy && way <= span + sensor_accuracy)) return false;
        double const was = geometry::dot(before - from, normal);
        return std::abs(height) <= sensor_accuracy || (was < 0) != (height < 0);
    }
};

using Watch = std::variant<Entry, EntryToPolygon, ExitFromPolygon, Crossing>;

Watch watch_of(Sensor const& sensor, double radius) {
    if (auto const* disc = std::get_if<DiscRegion>(&sensor.region)) return Entry(*disc, sensor.rim ? radius : 0);
    if (auto const* line = std::get_if<LineRegion>(&sensor.region)) return Crossing(*line);
    EntryToPolygon const entry{std::get<PolygonRegion>(sensor.region)};
    return sensor.outside ? Watch(ExitFromPolygon{entry}) : Watch(entry);
}

constexpr double finest = 0x1p-40;       // s, a picosecond: at 1 m/s a tenth of sensor_accuracy
constexpr double time_rounding = 1e-15;  // of the time

// s: rounding must not leave a cell at the edge of a window that ends at `to` unseen.
double search_slack(double to) { return finest + time_rounding * std::abs(to); }

// A search of one leg by inclusion. Its moments are a grid of the leg's own, whatever window is looked at, so that they
// do not depend on how often one asks. Blocks of the grid are halved until a bound shows that nothing is noticed in
// them, down to the grid's finest cells, where the places at both ends decide.
class Search {
public:
    // Events in (from, to]; `end` is when the leg ends, `never` where that is still to come. All in s.
    Search(Leg const& leg, double from, double to, double end) : leg_(leg), from_(from), to_(to), end_(end) {
        double const slack = search_slack(to);
        low_ = std::max(0.0, from - leg.since - slack);
        high_ = std::min(to - leg.since + slack, end - leg.since);
    }

    template <typename AnyWatch>
    std::optional<double> first(AnyWatch const& watch) const {
        if (!(low_ < high_) || watch.misses(LegPart(leg_, low_, high_))) return std::nullopt;
        double root = longest_held;
        while (root < high_) root *= 2;
        return first_in(watch, 0, root);
    }

private:
    // In the block from `start`, `length` long, both in s of the leg.
    template <typename AnyWatch>
    std::optional<double> first_in(AnyWatch const& watch, double start, double length) const {
        double const low = std::max(start, low_), high = std::min(start + length, high_);
        if (!(low < high) || watch.misses(LegPart(leg_, low, high))) return std::nullopt;
        if (length <= finest) return at_cell(watch, start);
        // On the edge to rounding all along, it would be so in every cell.
        if (length <= longest_held && watch.holds(LegPart(leg_, start, start + length)))
            return due(std::max(from_, time_at(start)));
        double const half = length / 2;
        auto const time = first_in(watch, start, half);
        return time ? time : first_in(watch, start + half, half);
    }

    template <typename AnyWatch>
    std::optional<double> at_cell(AnyWatch const& watch, double start) const {
        double const time = time_at(start + finest);
        if (!(time > from_)) return std::nullopt;
        Vec2 const before = at_span(leg_, start).position, now = at(leg_, time).position;
        return watch.notices(before, now) ? due(time) : std::nullopt;
    }

    std::optional<double> due(double time) const { return time <= to_ ? std::optional(time) : std::nullopt; }
    double time_at(double span) const { return std::min(leg_.since + span, end_); }

    static constexpr double longest_held = 1;  // s

    Leg const& leg_;
    double from_, to_, end_;
    double low_ = 0, high_ = 0;  // s of the leg, what is looked at
};

struct Notice {
    double time = never;
    int ball = 0;
};

// Where a leg begins elsewhere than the one before it ended, the ball goes from there to here in no time.
template <typename AnyWatch>
bool noticed_at_start(AnyWatch const& watch, Trail<Leg> const& legs, std::size_t i) {
    Vec2 const now = at_span(legs[i], 0).position;
    return watch.notices(i > 0 ? at(legs[i - 1], legs[i].since).position : now, now);
}

// Legs are looked at together where there are many: in rows of so many.
constexpr std::size_t legs_in_row = 32;

// When a leg of a trail ends, `never` where that is still to come.
double end_of(Trail<Leg> const& legs, std::size_t i) { return i + 1 < legs.size() ? legs[i + 1].since : never; }

Stretch stretch_of(Trail<Leg> const& legs, std::size_t first, std::size_t last, double from, double to) {
    Stretch stretch{first, last, at_span(legs[first], std::max(0.0, from - legs[first].since)).position, 0};
    if (first > 0)  // it may have come from elsewhere in no time
        stretch.radius = geometry::length(at(legs[first - 1], legs[first].since).position - stretch.centre);
    for (std::size_t i = first; i < last; ++i) {
        Leg const& leg = legs[i];
        double const slack = search_slack(to);
        double const low = std::max(0.0, from - leg.since - slack);
        double const high = std::max(low, std::min(to + slack, end_of(legs, i)) - leg.since);
        stretch.radius = std::max(stretch.radius, LegPart(leg, low, high).distance_from(stretch.centre).high);
    }
    stretch.radius += length_rounding;
    return stretch;
}

// The legs that have a part in (from, to]; the way of a few is not bounded.
std::vector<Stretch> stretches_of(Trail<Leg> const& legs, double from, double to) {
    auto const after = [](double t, Leg const& leg) { return t < leg.since; };
    auto const index = [&](auto const& at) { return static_cast<std::size_t>(at - legs.begin()); };
    std::size_t const next = index(std::upper_bound(legs.begin(), legs.end(), from, after));
    std::size_t const first = next > 0 ? next - 1 : 0;
    std::size_t const last =
        index(std::upper_bound(legs.begin() + static_cast<std::ptrdiff_t>(next), legs.end(), to, after));
    if (last - first < legs_in_row / 4) return {{first, last}};
    std::vector<Stretch> stretches;
    for (std::size_t i = first; i < last; i += legs_in_row)
        stretches.push_back(stretch_of(legs, i, std::min(i + legs_in_row, last), from, to));
    return stretches;
}

template <typename AnyWatch>
std::optional<double> first_notice(AnyWatch const& watch, Trail<Leg> const& legs, std::vector<Stretch> const& stretches,
                                   double from, double to) {
    for (Stretch const& stretch : stretches) {
        if (watch.misses(stretch)) continue;
        for (std::size_t i = stretch.first; i < stretch.last; ++i) {
            if (legs[i].since > from && noticed_at_start(watch, legs, i)) return legs[i].since;
            if (auto const time = Search(legs[i], from, to, end_of(legs, i)).first(watch)) return time;
        }
    }
    return std::nullopt;
}

// Before whatever else happens at that time, be it known already or not, and after other sensors.
void add_in_order(History& history, Event const& event) {
    auto const place = std::partition_point(history.events.begin(), history.events.end(), [&](Event const& e) {
        return e.time < event.time || (e.time == event.time && e.kind == EventKind::sensor);
    });
    history.events.insert(place, event);
}

void note(World& world, History& history, int sensor, int ball, double time) {
    add_in_order(history, {time, EventKind::sensor, ball, state_at(history, ball, time), no_contact, sensor});
    world.noticed[sensor][ball] = true;
}

}  // namespace

std::vector<std::vector<bool>> nothing_noticed(Scene const& scene) {
    return {scene.sensors.size(), std::vector<bool>(scene.balls.size(), false)};
}

void sense(Scene const& scene, World& world, double from, double to, History& history) {
    std::vector<Stretch> stretches;
    int whose = -1;
    for (int i = 0; i < static_cast<int>(scene.sensors.size()); ++i) {
        Sensor const& sensor = scene.sensors[i];
        Notice first;
        for (int ball = 0; ball < static_cast<int>(scene.balls.size()); ++ball) {
            if ((sensor.ball >= 0 && sensor.ball != ball) || world.noticed[i][ball]) continue;
            if (whose != ball) stretches = stretches_of(history.legs[ball], from, to);
            whose = ball;
            auto const time = std::visit(
                [&](auto const& watch) { return first_notice(watch, history.legs[ball], stretches, from, to); },
                watch_of(sensor, scene.balls[ball].radius));
            if (!time) continue;
            if (sensor.each_ball)
                note(world, history, i, ball, *time);
            else if (*time < first.time)
                first = {*time, ball};
        }
        if (first.time == never) continue;
        note(world, history, i, first.ball, first.time);
        world.noticed[i].assign(scene.balls.size(), true);
    }
}

}  // namespace physics
