// What straight and circular tracks share: which of several ends comes first.
#pragma once

#include <algorithm>
#include <optional>

#include "physics/course.h"

namespace physics {

// The soonest of the ends that a course might come to.
struct Soonest {
    double time = never;  // s since the course began
    Ending ending = Ending::none;
    Contact next;
    double next_q = 0;
    Onset onset = Onset::none;

    void offer(std::optional<double> t, Ending what) {
        if (t && *t < time) *this = {std::max(0.0, *t), what, no_contact, 0, Onset::none};
    }
    void offer(std::optional<double> t, Limit const& limit) {
        if (t && *t < time) *this = {std::max(0.0, *t), limit.ending, no_contact, 0, limit.onset};
    }
    void offer(std::optional<double> t, TrackEnd const& passage) {
        if (!t || !(*t < time)) return;
        Ending const what = passage.kind == EndKind::joint    ? Ending::joins
                            : passage.kind == EndKind::corner ? Ending::turns
                                                              : Ending::meets;
        *this = {std::max(0.0, *t), what, passage.next, passage.next_q, Onset::none};
    }

    Course course(Rider const& rider, Law const& law, Motion motion, double since) const {
        Course c;
        c.leg = {since, since + time, law.phase, rider.contact, std::move(motion)};
        c.duration = time;
        c.ending = ending;
        c.next = next;
        c.next_q = next_q;
        c.onset = onset;
        return c;
    }
};

// How near to the end of its track a ball is at it.
inline constexpr double end_reach = 1e-12;  // m

// Offers the ends of the track at once where the ball is driven against them, or would come back unseen.
inline void offer_ends_at_hand(Soonest& soonest, Setting const& setting, Rider const& rider, TrackEnds const& ends,
                               double acceleration) {
    bool const at_high = ends.high.q - rider.q <= end_reach && acceleration > 0;
    bool const at_low = rider.q - ends.low.q <= end_reach && acceleration < 0;
    if (!at_high && !at_low) return;
    double const sway = sway_speed(setting, state_of(setting, rider));
    // A joint is passed in the direction of the motion alone.
    double const high_sway = ends.high.kind == EndKind::joint ? 0 : sway, low_sway = ends.low.kind == EndKind::joint ? 0 : sway;
    if (at_high && rider.speed >= -high_sway) soonest.offer(0.0, ends.high);
    if (at_low && rider.speed <= low_sway) soonest.offer(0.0, ends.low);
}

Course line_course(Setting const& setting, Rider const& rider, Law const& law, TrackEnds const& ends, double since);
Course circle_course(Setting const& setting, Rider const& rider, Law const& law, TrackEnds const& ends, double since);
// The same in closed form, where it has one: rolling freely, without damping.
std::optional<Course> pendulum_course(Setting const& setting, Rider const& rider, Law const& law, TrackEnds const& ends,
                                      double since);

inline Course track_course(Setting const& setting, Rider const& rider, Law const& law, TrackEnds const& ends,
                           double since) {
    if (rider.track.straight) return line_course(setting, rider, law, ends, since);
    auto const closed_form = pendulum_course(setting, rider, law, ends, since);
    return closed_form ? *closed_form : circle_course(setting, rider, law, ends, since);
}

}  // namespace physics
