// The plane: vectors, the wedge product of the article, quarter turns.
#pragma once

#include <cmath>
#include <concepts>
#include <type_traits>

#include <Eigen/Core>

// Two vectors, or a vector and a number, come to a vector at once, by functions that are compiled once. Eigen's own
// operators make a type of every expression, which takes long to compile and, not optimised, to run. These are nearer, for
// they need no conversion to a base. The same sums and products: the same bits.
namespace Eigen {

template <typename T>
concept PlaneVector = std::same_as<T, Vector2d>;
template <typename T>
concept Number = std::is_arithmetic_v<T>;

template <PlaneVector A, PlaneVector B> Vector2d operator+(A const& a, B const& b) { return {a.x() + b.x(), a.y() + b.y()}; }
template <PlaneVector A, PlaneVector B> Vector2d operator-(A const& a, B const& b) { return {a.x() - b.x(), a.y() - b.y()}; }
template <PlaneVector A> Vector2d operator-(A const& a) { return {-a.x(), -a.y()}; }
template <PlaneVector A, Number S> Vector2d operator*(A const& a, S s) { return {a.x() * s, a.y() * s}; }
template <Number S, PlaneVector A> Vector2d operator*(S s, A const& a) { return {s * a.x(), s * a.y()}; }
template <PlaneVector A, Number S> Vector2d operator/(A const& a, S s) { return {a.x() / s, a.y() / s}; }
template <PlaneVector A, PlaneVector B> Vector2d& operator+=(A& a, B const& b) { return a = a + b; }
template <PlaneVector A, PlaneVector B> Vector2d& operator-=(A& a, B const& b) { return a = a - b; }
}  // namespace Eigen

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
