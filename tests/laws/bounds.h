// Which method is bound to which law, and how closely: one line a law, so that a new method is bound by a column of its
// own. T1 to T20 are the failures that every method is tested for; README.md here lists them.
#pragma once

#include <optional>
#include <vector>

#include "scenes/scenes.h"

namespace laws {

using namespace scenes;

// Tolerances, each in the law's own measure. `exact` is right to the rounding of doubles, which the measures of some
// laws multiply a little. `steps` leaves a ball that no other is near on the same plan, and is held to the same; what
// it steps are piles. `article` is bound where its ball, all mass at the hub, obeys the same law; to first order in its
// step of 1/240 s.
struct Law {
    double exact_and_steps = 0;
    std::optional<double> article = {};
};

namespace law {
inline constexpr Law flight{1e-12};                // parabola, spin kept
inline constexpr Law roll_on_slope{1e-12};         // physics.md 3.3, T1
inline constexpr Law slide_on_slope{1e-12};        // physics.md 3.3
inline constexpr Law slip_to_roll{1e-12};          // physics.md 3.3
inline constexpr Law spin_down{1e-12};             // physics.md 3.3
inline constexpr Law rolling_resistance{1e-12};    // physics.md 4.2
inline constexpr Law swing_in_valley{1e-12};       // physics.md 3.7, period
inline constexpr Law energy_in_valley{1e-12};      // physics.md 3.5
inline constexpr Law lift_off{1e-9};               // physics.md 3.5, angle in degrees
inline constexpr Law loop{1e-9};                   // physics.md 3.5, share of the threshold speed
inline constexpr Law bend{1e-12};                  // T2, share of the speed lost
inline constexpr Law hill{1e-12, 1e-2};            // T3
inline constexpr Law flat_joints{1e-12, 1e-9};     // T8, height in m and share of the speed
inline constexpr Law corner{1e-12};                // physics.md 5.4, T9
inline constexpr Law vertex{1e-11};                // physics.md 5.3, T3
inline constexpr Law bounce{1e-12};                // T10, share of the height
inline constexpr Law rest_time{1e-12};             // T11
inline constexpr Law impact_energy{1e-12};         // T1
inline constexpr Law pair_momentum{1e-12};         // physics.md 1.3
inline constexpr Law drag_in_air{1e-12, 1e-11};    // physics.md 3.2, T4 and T5, m for a swing of 1 m
inline constexpr Law drag_on_ground{3e-12};        // physics.md 3.4, T4
inline constexpr Law groove{1e-11};                // physics.md 7.2
inline constexpr Law path_of_centre{1e-12, 1e-3};  // physics.md 2.2, the angle rolled
inline constexpr Law no_escape{1e-9};              // T6, m into a line
inline constexpr Law rest{0, 1e-12};               // T12, m/s
inline constexpr Law piles{1e-2};                  // T13 and T14: share of the overlap of soft contacts
inline constexpr Law far_away{1e-9, 1e-6};         // T15, radii off the path at the origin, 1e5 m away
inline constexpr Law lawful_input{0, 0};           // T16
inline constexpr Law late_frame{0, 0};             // T17
inline constexpr Law hour{10, 0};                  // T18
inline constexpr Law simultaneous{1e-12};          // T19
}  // namespace law

struct Bound {
    physics::Method method;
    double tolerance = 0;
};

// The methods bound to a law, each with its tolerance.
inline std::vector<Bound> bounds_of(Law const& law) {
    std::vector<Bound> bounds{{physics::Exact{}, law.exact_and_steps}, {physics::Steps{}, law.exact_and_steps}};
    if (law.article) bounds.push_back({physics::Article{}, *law.article});
    return bounds;
}

}  // namespace laws
