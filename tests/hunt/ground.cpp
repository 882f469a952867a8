#include "hunt/ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hunt {

using geometry::dot;
using geometry::length;
using geometry::cross;

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int chords = 64;  // of a curve

Vec2 on_circle(Vec2 const& centre, double radius, double angle) {
    return centre + radius * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 point_on(Cubic const& c, double t) {
    double const s = 1 - t;
    return s * s * s * c.from + 3 * s * s * t * c.first + 3 * s * t * t * c.second + t * t * t * c.to;
}

Vec2 point_on(Quadratic const& q, double t) {
    double const s = 1 - t;
    return s * s * q.from + 2 * s * t * q.handle + t * t * q.to;
}

template <typename Curve>
void add_chords(Ground& ground, Curve const& curve) {
    for (int i = 0; i < chords; ++i)
        ground.push_back(bar(point_on(curve, i / static_cast<double>(chords)),
                             point_on(curve, (i + 1) / static_cast<double>(chords))));
}

void add(Ground& ground, Line const& line) { ground.push_back(bar(line.from, line.to)); }
void add(Ground& ground, Bow const& bow) { ground.push_back(limb_of(bow)); }
void add(Ground& ground, Cubic const& cubic) { add_chords(ground, cubic); }
void add(Ground& ground, Quadratic const& quadratic) { add_chords(ground, quadratic); }
void add(Ground& ground, Disc const& disc) { ground.push_back(round_limb(disc.centre, disc.radius, 0, turn)); }

bool spans(Limb const& limb, double angle) {
    double const beyond = limb.sweep < 0 ? limb.start - angle : angle - limb.start;
    return beyond - turn * std::floor(beyond / turn) <= std::abs(limb.sweep);
}

}  // namespace

Limb bar(Vec2 const& from, Vec2 const& to) {
    Limb limb;
    limb.from = from;
    limb.to = to;
    limb.middle = (from + to) / 2;
    limb.reach = length(to - from) / 2;
    return limb;
}

Limb round_limb(Vec2 const& centre, double radius, double start, double sweep) {
    Limb limb;
    limb.round = true;
    limb.centre = limb.middle = centre;
    limb.radius = limb.reach = radius;
    limb.start = start;
    limb.sweep = sweep;
    limb.from = on_circle(centre, radius, start);
    limb.to = on_circle(centre, radius, start + sweep);
    return limb;
}

Limb limb_of(Bow const& bow) {
    Vec2 const chord = bow.to - bow.from;
    double const half = length(chord) / 2;
    if (!(half > 0)) return bar(bow.from, bow.to);
    double const radius = std::max(bow.radius, half);
    double const height = std::sqrt((radius - half) * (radius + half));
    Vec2 const left = Vec2(-chord.y(), chord.x()) / (2 * half);
    Vec2 const centre = (bow.from + bow.to) / 2 + (bow.left == bow.large ? -height : height) * left;
    Vec2 const start = bow.from - centre, end = bow.to - centre;
    double sweep = std::atan2(cross(start, end), dot(start, end));
    if (bow.left && sweep < 0) sweep += turn;
    if (!bow.left && sweep > 0) sweep -= turn;
    Limb limb = round_limb(centre, radius, std::atan2(start.y(), start.x()), sweep);
    limb.from = bow.from;
    limb.to = bow.to;
    return limb;
}

Ground ground_of(physics::Terrain const& terrain) {
    Ground ground;
    for (physics::Piece const& piece : terrain.pieces) {
        if (auto const* arc = std::get_if<geometry::Arc>(&piece.curve)) {
            ground.push_back(round_limb(arc->centre, arc->radius, arc->from, arc->sweep));
        } else {
            auto const& segment = std::get<geometry::Segment>(piece.curve);
            ground.push_back(bar(segment.start, segment.end));
        }
        ground.back().friction = piece.material.friction;
        ground.back().resistance = piece.material.rolling_resistance;
    }
    return ground;
}

Ground ground_of(std::vector<Element> const& elements) {
    Ground ground;
    for (Element const& element : elements)
        for (Stroke const& stroke : element.strokes) std::visit([&](auto const& shape) { add(ground, shape); }, stroke);
    return ground;
}

Foot foot_on(Limb const& limb, Vec2 const& from) {
    if (!limb.round) {
        Vec2 const along = limb.to - limb.from;
        double const square = dot(along, along);
        double const share = square > 0 ? dot(from - limb.from, along) / square : 0;
        if (share > 0 && share < 1)
            return {limb.from + share * along, std::abs(cross(along, from - limb.from)) / std::sqrt(square)};
    } else {
        Vec2 const outward = from - limb.centre;
        double const distance = length(outward);
        if (distance == 0) return {limb.from, limb.radius};
        if (spans(limb, std::atan2(outward.y(), outward.x())))
            return {limb.centre + outward * (limb.radius / distance), std::abs(distance - limb.radius)};
    }
    double const start = length(from - limb.from), end = length(from - limb.to);
    return start < end ? Foot{limb.from, start} : Foot{limb.to, end};
}

Foot nearest_on(Ground const& ground, Vec2 const& from) {
    Foot nearest;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (length(from - ground[i].middle) - ground[i].reach > nearest.distance) continue;
        Foot const foot = foot_on(ground[i], from);
        if (foot.distance < nearest.distance) nearest = {foot.point, foot.distance, static_cast<int>(i)};
    }
    return nearest;
}

std::vector<Foot> feet_within(Ground const& ground, Vec2 const& from, double reach) {
    std::vector<Foot> feet;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (length(from - ground[i].middle) - ground[i].reach > reach) continue;
        Foot const foot = foot_on(ground[i], from);
        if (foot.distance < reach) feet.push_back({foot.point, foot.distance, static_cast<int>(i)});
    }
    return feet;
}

}  // namespace hunt
