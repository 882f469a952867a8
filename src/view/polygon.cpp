#include "view/polygon.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector.h"

namespace view {

double signed_area(Ring const& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        twice += geometry::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    return twice / 2;
}

bool contains(Ring const& ring, Vec2 const& point) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2 const& a = ring[i];
        Vec2 const& b = ring[(i + 1) % ring.size()];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        double const x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (point.x() < x) inside = !inside;
    }
    return inside;
}

geometry::Box box_of_ring(Ring const& ring) {
    geometry::Box box;
    for (Vec2 const& point : ring) box = geometry::united(box, {point, point});
    return box;
}

std::vector<Vec2> left_of(Ring const& points, Closing closing) {
    std::size_t const count = points.size();
    auto const edge_normal = [&](std::size_t from, std::size_t to) -> Vec2 {
        Vec2 const along = points[to] - points[from];
        double const length = geometry::length(along);
        return length > 0 ? Vec2(geometry::turned_left(along) / length) : Vec2(Vec2::Zero());
    };
    std::vector<Vec2> left(count, Vec2::UnitY());
    for (std::size_t i = 0; i < count; ++i) {
        bool const first = i == 0 && closing == Closing::open;
        bool const last = i + 1 == count && closing == Closing::open;
        Vec2 const before = first ? edge_normal(i, i + 1) : edge_normal((i + count - 1) % count, i);
        Vec2 const after = last ? before : edge_normal(i, (i + 1) % count);
        Vec2 const sum = before + after;
        // |sum|/2 is the cosine of half the turn.
        double const cosine = geometry::length(sum) / 2;
        if (cosine > 1e-6) left[i] = sum / (2 * cosine) / std::max(cosine, 0.5);
    }
    return left;
}

std::vector<Ring> band_along(std::span<Vec2 const> points, std::span<Vec2 const> into, Closing closing,
                             std::function<double(std::size_t)> const& width) {
    auto const inner = [&](std::size_t i) -> Vec2 { return points[i] + width(i) * into[i]; };
    std::size_t const count = points.size();
    std::vector<Ring> rings(closing == Closing::closed ? 2 : 1);
    Ring& back = rings.back();
    if (closing == Closing::closed) {
        rings[0].assign(points.begin(), points.end());
        back.reserve(count);
        for (std::size_t i = 0; i < count; ++i) back.push_back(inner(i));
        return rings;
    }
    back.reserve(2 * count);
    back.assign(points.begin(), points.end());
    for (std::size_t i = count; i-- > 0;) back.push_back(inner(i));
    return rings;
}

}  // namespace view
