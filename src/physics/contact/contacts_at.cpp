#include "physics/contact/contacts_at.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/elementary.h"

namespace physics {

using geometry::Arc;
using geometry::dot;
using geometry::Segment;

namespace {

// A ball whose centre is nearer than this to the normal through a feature's end is at the end. Half of what a feature
// reaches beyond its end, so that where one ends the next is always seen. m
constexpr double end_zone = touch_reach / 2;
// Normals nearer than this are one.
constexpr double same_normal = 1e-9;
// Between the supports that stand for a socket. rad
constexpr double socket_spacing = geometry::pi / 6;

// `outwards` points out of the feature at an end of it that lies `within` metres ahead.
void mark_end(ContactPoint& point, Vec2 const& outwards, double within) {
    if (within > end_zone) return;
    bool const forwards = dot(outwards, geometry::turned_right(point.normal)) > 0;
    (forwards ? point.ends_forwards : point.ends_backwards) = true;
}

class Finder {
public:
    Finder(Terrain const& terrain, Vec2 const& centre, double radius)
        : terrain_(terrain), centre_(centre), radius_(radius) {}

    void look_at(int index) {
        if (auto const* segment = std::get_if<Segment>(&terrain_.pieces[index].curve))
            look_at_segment(index, *segment);
        else
            look_at_arc(index, std::get<Arc>(terrain_.pieces[index].curve));
        look_at_end(index, terrain_.start_vertex[index]);
        look_at_end(index, terrain_.end_vertex[index]);
    }

    std::vector<ContactPoint> points;

private:
    void look_at_segment(int index, Segment const& segment) {
        Vec2 const way = segment.end - segment.start;
        double const span = geometry::length(way);
        Vec2 const along = way / span, left = geometry::turned_left(along);
        double const foot = dot(centre_ - segment.start, along), height = dot(centre_ - segment.start, left);
        if (foot < -touch_reach || foot > span + touch_reach || std::abs(height) - radius_ > touch_reach) return;
        int const side = height > 0 ? 1 : -1;
        ContactPoint point{{index, side}, side * left, std::abs(height) - radius_};
        mark_end(point, -along, foot);
        mark_end(point, along, span - foot);
        points.push_back(point);
    }

    void look_at_arc(int index, Arc const& arc) {
        Vec2 const out = centre_ - arc.centre;
        double const distance = geometry::length(out), room = arc.radius - radius_;
        int const inner_side = arc.sweep > 0 ? 1 : -1;
        if (std::abs(room) <= socket_play && distance <= std::max(0.0, room) + socket_play)
            return fill_socket(index, arc, inner_side);
        if (distance == 0 || !is_over(index, arc, out)) return;
        if (distance > arc.radius) {
            if (distance - arc.radius - radius_ <= touch_reach)
                add_on_arc(index, arc,
                           {{index, -inner_side}, out / distance, distance - arc.radius - radius_, 1 / distance});
        } else if (room - distance <= touch_reach && room >= -socket_play) {
            add_on_arc(index, arc, {{index, inner_side}, -out / distance, room - distance, -1 / distance});
        }
    }

    // Past the ends of the arc, in m at the ball's centre; negative before them.
    static double past_start(Arc const& arc, Vec2 const& out) { return -dot(out, geometry::tangent_at_start(arc)); }
    static double past_end(Arc const& arc, Vec2 const& out) { return dot(out, geometry::tangent_at_end(arc)); }

    bool is_over(int index, Arc const& arc, Vec2 const& out) const {
        if (terrain_.start_vertex[index] < 0) return true;
        bool const after_start = past_start(arc, out) <= touch_reach, before_end = past_end(arc, out) <= touch_reach;
        return std::abs(arc.sweep) > geometry::pi ? after_start || before_end : after_start && before_end;
    }

    void add_on_arc(int index, Arc const& arc, ContactPoint point) {
        if (terrain_.start_vertex[index] >= 0) {
            Vec2 const out = centre_ - arc.centre;
            Vec2 const start = geometry::tangent_at_start(arc), end = geometry::tangent_at_end(arc);
            bool const near_start = dot(out, geometry::start_of(arc) - arc.centre) > 0;
            bool const near_end = dot(out, geometry::end_of(arc) - arc.centre) > 0;
            if (near_start) mark_end(point, -start, -past_start(arc, out));
            if (near_end) mark_end(point, end, -past_end(arc, out));
        }
        points.push_back(point);
    }

    void fill_socket(int index, Arc const& arc, int inner_side) {
        // An odd number, so that one of them lies in the middle.
        int const count = static_cast<int>(std::ceil(std::abs(arc.sweep) / socket_spacing)) | 1;
        for (int i = 0; i < count; ++i) {
            auto const [sine, cosine] = geometry::sine_cosine(arc.from + arc.sweep * (i + 0.5) / count);
            ContactPoint point{{index, inner_side}, Vec2(-cosine, -sine)};
            point.normals_from = arc.from + geometry::pi;
            point.normals_turn = arc.sweep;
            points.push_back(point);
        }
    }

    void look_at_end(int index, int vertex) {
        if (vertex < 0 || terrain_.vertices[vertex].edges.front().piece != index) return;
        Vertex const& v = terrain_.vertices[vertex];
        Vec2 const out = centre_ - v.point;
        double const distance = geometry::length(out);
        if (v.cone_width == 0 || distance == 0 || distance - radius_ > touch_reach) return;
        ContactPoint point{{terrain_.feature_of_vertex(vertex), 1}, out / distance, distance - radius_, 1 / distance};
        for (Vec2 const& edge : {v.first_edge, v.last_edge}) {
            double const past = dot(point.normal, edge) * radius_;
            if (past > touch_reach) return;
            mark_end(point, edge, -past);
        }
        points.push_back(point);
    }

    Terrain const& terrain_;
    Vec2 const& centre_;
    double radius_;
};

// Which of two points counts first where nothing else tells them apart: never by how they were drawn. What rubs,
// bounces and resists most; then by where it is. Points of one socket stay together.
bool counts_before(Terrain const& terrain, ContactPoint const& a, ContactPoint const& b) {
    auto const place = [&](ContactPoint const& point) {
        Material const& material = material_of(terrain, point.contact.feature);
        bool const is_socket = point.normals_turn != 0;
        Vec2 const where = is_socket ? Vec2(point.normals_from, point.normals_turn) : point.normal;
        return std::make_tuple(-material.friction, -material.restitution, -material.rolling_resistance, is_socket,
                               where.x(), where.y(), point.contact.feature);
    };
    return place(a) < place(b);
}

bool has_normal(ContactPoint const& socket, double angle) {
    double const sign = socket.normals_turn < 0 ? -1 : 1;
    double const past = geometry::within_turn(sign * (angle - socket.normals_from) + same_normal);
    return past <= std::abs(socket.normals_turn) + 2 * same_normal;
}

ContactPoint with_normal(ContactPoint socket, double angle) {
    auto const [sine, cosine] = geometry::sine_cosine(angle);
    socket.normal = {cosine, sine};
    return socket;
}

// Sockets push against a way of the ball as one, however they are drawn: right against it or, where none has such a
// normal, from the nearest ends on either side.
void add_pushing(std::vector<ContactPoint>& points, std::vector<ContactPoint> const& sockets, Vec2 const& way) {
    double const against = geometry::arctangent(-way.y(), -way.x());
    double left = never, right = never;  // rad, from `against`
    ContactPoint at_left, at_right;
    for (ContactPoint const& socket : sockets) {
        if (has_normal(socket, against)) {
            points.push_back(socket);
            points.back().normal = -way / geometry::length(way);
            return;
        }
        for (double const end : {socket.normals_from, socket.normals_from + socket.normals_turn}) {
            double const past = geometry::within_turn(end - against);
            if (past < left) left = past, at_left = with_normal(socket, end);
            if (2 * geometry::pi - past < right) right = 2 * geometry::pi - past, at_right = with_normal(socket, end);
        }
    }
    points.push_back(at_left);
    points.push_back(at_right);
}

// The points with which features push that are touched by a ball that moves and is drawn so: sockets against its motion
// and, where it does not close on them, against what draws it.
std::vector<ContactPoint> pushing(std::vector<ContactPoint> const& all, Vec2 const& velocity, Vec2 const& acceleration,
                                  double rounding) {
    std::vector<ContactPoint> points, sockets;
    for (ContactPoint const& point : all)
        if (point.normals_turn == 0)
            points.push_back(point);
        else if (sockets.empty() || sockets.back().contact != point.contact)
            sockets.push_back(point);
    if (sockets.empty()) return points;
    std::size_t const first = points.size();
    if (geometry::length(velocity) > rounding) add_pushing(points, sockets, velocity);
    bool const closes = std::any_of(points.begin() + static_cast<std::ptrdiff_t>(first), points.end(),
                                    [&](ContactPoint const& p) { return dot(velocity, p.normal) < -rounding; });
    if (!closes && geometry::length(acceleration) > 0) add_pushing(points, sockets, acceleration);
    return points;
}

}  // namespace

double second_derivative(ContactPoint const& point, Vec2 const& velocity, Vec2 const& acceleration) {
    double const along = geometry::cross(velocity, point.normal);
    return dot(acceleration, point.normal) + point.curvature * along * along;
}

std::vector<ContactPoint> contacts_at(Terrain const& terrain, Vec2 const& centre, double radius) {
    Finder finder(terrain, centre, radius);
    terrain.tree.each_near(geometry::stroke_of(centre, centre, radius + touch_reach),
                           [&](int piece) { finder.look_at(piece); });
    std::stable_sort(finder.points.begin(), finder.points.end(),
                     [&](ContactPoint const& a, ContactPoint const& b) { return counts_before(terrain, a, b); });
    return std::move(finder.points);
}

bool is_left_behind(ContactPoint const& point, Vec2 const& velocity, Vec2 const& acceleration, double rounding) {
    Vec2 const tangent = geometry::turned_right(point.normal);
    double const speed = dot(velocity, tangent), pull = dot(acceleration, tangent);
    double const way = std::abs(speed) > rounding ? speed : pull;
    return (way > 0 && point.ends_forwards) || (way < 0 && point.ends_backwards);
}

std::vector<ContactPoint> kept_apart(std::vector<ContactPoint> const& all, Vec2 const& velocity,
                                     Vec2 const& acceleration, double rounding) {
    std::vector<ContactPoint> chosen;
    // Where all that share the normal end: the ball goes on from one to the other, or is held between them.
    struct Ends {
        bool forwards, backwards;
    };
    std::vector<Ends> ends;
    auto const better = [&](ContactPoint const& a, ContactPoint const& b) {
        bool const a_behind = is_left_behind(a, velocity, acceleration, rounding);
        bool const b_behind = is_left_behind(b, velocity, acceleration, rounding);
        if (a_behind != b_behind) return b_behind;
        // Out of a socket the ball goes on along its neighbour.
        if ((a.normals_turn != 0) != (b.normals_turn != 0)) return b.normals_turn != 0;
        return second_derivative(a, velocity, acceleration) < second_derivative(b, velocity, acceleration);
    };
    for (ContactPoint const& point : pushing(all, velocity, acceleration, rounding)) {
        auto const same = std::find_if(chosen.begin(), chosen.end(), [&](ContactPoint const& other) {
            return geometry::length(other.normal - point.normal) <= same_normal;
        });
        if (same == chosen.end()) {
            chosen.push_back(point);
            ends.push_back({point.ends_forwards, point.ends_backwards});
            continue;
        }
        Ends& of_all = ends[static_cast<std::size_t>(same - chosen.begin())];
        of_all = {of_all.forwards && point.ends_forwards, of_all.backwards && point.ends_backwards};
        if (better(point, *same)) *same = point;
    }
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        chosen[i].ends_forwards = ends[i].forwards;
        chosen[i].ends_backwards = ends[i].backwards;
    }
    return chosen;
}

}  // namespace physics
