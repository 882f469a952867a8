// Jacobi's elliptic functions of one modulus k, by theta series of which a few terms are enough; real arguments only
// (Whittaker and Watson, chapters 21 and 22; physics.md 11.4).
#pragma once

#include "geometry/elementary.h"

namespace geometry {

class Jacobi {
public:
    Jacobi() = default;  // k = 0: sine, cosine and 1
    // k^2 and 1 - k^2, given apart so that neither lacks digits; 1 - k^2 must be above 0.
    Jacobi(double parameter, double complement);

    // Of what is left of u in [-K, K] when `half_turns` times 2K are taken off; at each of them sn and cn change sign,
    // which `sign` says, and am u grows by pi.
    struct Values {
        double sn = 0, cn = 1, dn = 1;
        double half_turns = 0;
        double sign = 1;
    };
    // Absolute error about 1e-15, and what rounding of u itself makes of it.
    Values at(double u) const;

    double quarter_period() const { return quarter_; }  // K

private:
    struct Halves {  // even and odd part of a theta function in z = cos 2v: e0 + e2 z^2 and z (o0 + o2 z^2)
        double e0 = 1, e2 = 0, o0 = 0, o2 = 0;
    };

    bool is_near_circular_ = true;  // k^2 <= 1/2: theta functions of the angle; else of an imaginary one
    double quarter_ = pi / 2;
    double scale_ = 1;  // of u to the argument v of the theta functions
    Halves odd_;        // theta 1 and 2 without their factors 2 q^(1/4) sin v and cos v
    Halves even_;       // theta 3 and 4
    double sn_factor_ = 1, cn_factor_ = 1, dn_factor_ = 1;
};

// The u at which sn and cn have these values, within (-2K, 2K): the elliptic integral of the first kind. `dn` is
// sqrt(1 - k^2 sn^2).
double first_kind(double sn, double cn, double dn, double quarter_period);

}  // namespace geometry
