// The plane: vectors, the wedge product of the article, quarter turns.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace geometry {

using Vec2 = Eigen::Vector2d;

// a ^ b = a.x b.y - a.y b.x: the signed area that a and b span, positive where b lies to the left of a.
inline double cross(Vec2 const& a, Vec2 const& b) { return a.x() * b.y() - a.y() * b.x(); }

inline double dot(Vec2 const& a, Vec2 const& b) { return a.x() * b.x() + a.y() * b.y(); }

// Not Vec2::norm(): the same two products in the same order on every compiler.
inline double length(Vec2 const& a) { return std::sqrt(dot(a, a)); }

inline Vec2 turned_left(Vec2 const& a) { return {-a.y(), a.x()}; }
inline Vec2 turned_right(Vec2 const& a) { return {a.y(), -a.x()}; }

// a turned counter-clockwise by the angle whose cosine and sine are given.
inline Vec2 turned(Vec2 const& a, double cosine, double sine) {
    return {cosine * a.x() - sine * a.y(), sine * a.x() + cosine * a.y()};
}

inline bool is_finite(Vec2 const& a) { return std::isfinite(a.x()) && std::isfinite(a.y()); }

}  // namespace geometry
