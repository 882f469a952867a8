// What straight and circular tracks share: which of several ends comes first.
#pragma once

#include <algorithm>
#include <optional>

#include "physics/plan/leg_plan.h"

namespace physics {

// Makes `end` what comes at t (s since the leg began) if that is sooner.
inline void offer(LegEnd& end, std::optional<double> t, LegEndCause cause, ModeHint hint = ModeHint::none) {
    if (t && *t < end.time) end = {std::max(0.0, *t), cause, no_contact, 0, hint};
}
inline void offer(LegEnd& end, std::optional<double> t, Limit const& limit) { offer(end, t, limit.cause, limit.hint); }
inline void offer(LegEnd& end, std::optional<double> t, TrackEnd const& passage) {
    if (!t || !(*t < end.time)) return;
    LegEndCause const cause = passage.kind == EndKind::joint    ? LegEndCause::joins
                              : passage.kind == EndKind::corner ? LegEndCause::turns
                                                                : LegEndCause::meets;
    end = {std::max(0.0, *t), cause, passage.next, passage.next_q, ModeHint::none};
}

// The leg on a track that begins at `since` (s) and ends so.
inline LegPlan plan_until(LegEnd const& end, SurfaceState const& on_track, ContactMode const& mode, Motion motion,
                          double since) {
    return {{since, since + end.time, mode.phase, on_track.contact, std::move(motion)}, end};
}

// How near to the end of its track a ball is at it.
inline constexpr double end_reach = 1e-12;  // m

// Offers the ends of the track at once where the ball is driven against them, or would come back unseen.
inline void offer_ends_at_hand(LegEnd& soonest, MotionContext const& context, SurfaceState const& on_track,
                               TrackEnds const& ends, double acceleration) {
    bool const at_high = ends.high.q - on_track.q <= end_reach && acceleration > 0;
    bool const at_low = on_track.q - ends.low.q <= end_reach && acceleration < 0;
    if (!at_high && !at_low) return;
    double const sway = sway_speed(context, state_of(context, on_track));
    // A joint is passed in the direction of the motion alone.
    double const high_sway = ends.high.kind == EndKind::joint ? 0 : sway,
                 low_sway = ends.low.kind == EndKind::joint ? 0 : sway;
    if (at_high && on_track.speed >= -high_sway) offer(soonest, 0.0, ends.high);
    if (at_low && on_track.speed <= low_sway) offer(soonest, 0.0, ends.low);
}

LegPlan plan_line(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                  TrackEnds const& ends, double since);
LegPlan plan_circle(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                    TrackEnds const& ends, double since);
// The same in closed form, where it has one: rolling freely, without damping.
std::optional<LegPlan> plan_pendulum(MotionContext const& context, SurfaceState const& on_track,
                                     ContactMode const& mode, TrackEnds const& ends, double since);

inline LegPlan plan_track(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                          TrackEnds const& ends, double since) {
    if (on_track.track.straight) return plan_line(context, on_track, mode, ends, since);
    auto const closed_form = plan_pendulum(context, on_track, mode, ends, since);
    return closed_form ? *closed_form : plan_circle(context, on_track, mode, ends, since);
}

}  // namespace physics
