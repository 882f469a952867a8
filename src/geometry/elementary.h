// Elementary functions made of + - * / and sqrt alone, so that every compiler and C library gives the same bits
// (physics.md 11.3).
#pragma once

#include <cmath>

namespace geometry {

inline constexpr double pi = 3.14159265358979323846;

// x + rounder - rounder is the whole number nearest to |x| < 2^51, found without a call and without a branch; the
// lowest bits of x + rounder count.
inline constexpr double rounder = 0x1.8p52;

// The angle plus whole turns, in [0, 2 pi].
inline double within_turn(double angle) { return angle - 2 * pi * std::floor(angle / (2 * pi)); }

struct SineCosine {
    double sine = 0;
    double cosine = 1;
};

// Error at most 1e-15 absolute for |angle| <= 1e6 rad; the argument is reduced by a split pi/2.
SineCosine sine_cosine(double angle);

// Relative error at most 1e-15; 0 below -708, infinity above 709.
double exponential(double x);

// The angle of (x, y) in (-pi, pi], error at most 1e-15 rad; 0 for the origin.
double arctangent(double y, double x);

// The angle in [0, pi] whose cosine is x; x outside [-1, 1] counts as the nearer end.
double arccosine(double x);

// The natural logarithm of a positive normal number, relative error at most 1e-15 away from 1, absolute error 1e-16
// near it.
double logarithm(double x);

// The x whose hyperbolic tangent is given, for |tangent| < 1, relative error at most 1e-15.
double hyperbolic_arctangent(double tangent);

}  // namespace geometry
