// Straight tracks: constant acceleration, or a damped swing on the drag spring (physics.md 3.3, 3.4).
#include <cmath>

#include "geometry/polynomial.h"
#include "geometry/swing_roots.h"
#include "physics/plan/leg_plan.h"
#include "physics/plan/plan_track.h"

namespace physics {

using geometry::first_quadratic_fall;
using geometry::Oscillator;
using geometry::Swing;

namespace {

// A slip this small, against the speeds of the swing, is rounding.
constexpr double line_onset_rounding = 1e-14;
// Under a pull the field does not stay the same for longer, and the bounces that are left are let go. s
constexpr double longest_sum = 1e-4;

LegPlan steady_line(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                    TrackEnds const& ends, double since) {
    double const force = normal_force(context, on_track);
    double const a = mode.alpha * tangent_acceleration(context, on_track) + mode.beta * force;
    double const rim_rate = mode.phase == Phase::slide ? mode.gamma * force : a;
    State const from = state_of(context, on_track);
    LegEnd soonest;
    offer_ends_at_hand(soonest, context, on_track, ends, a);
    if (ends.high.q < never)
        offer(soonest, first_quadratic_fall(std::max(0.0, ends.high.q - on_track.q), -on_track.speed, -a / 2, never),
              ends.high);
    if (ends.low.q > -never)
        offer(soonest, first_quadratic_fall(std::max(0.0, on_track.q - ends.low.q), on_track.speed, a / 2, never),
              ends.low);
    if (mode.phase == Phase::slide)
        offer(soonest, first_quadratic_fall(mode.sign * on_track.slip(), mode.sign * (a - rim_rate), 0, never),
              LegEndCause::grips);
    else if (mode.sign != 0)
        offer(soonest, first_quadratic_fall(mode.sign * on_track.speed, mode.sign * a, 0, never), LegEndCause::stops);
    // The pull of a spring that does not move the ball (mode.alpha = 0) changes with its place and speed all the same.
    if (context.field.pulled)
        for (int i = 0; i < mode.limit_count; ++i) {
            Limit const& limit = mode.limits[i];
            geometry::Oscillator const& spring = context.field.spring;
            double const jerk = -spring.stiffness * on_track.speed - 2 * spring.decay * a;
            double const at_hand = limit.tangent * tangent_acceleration(context, on_track) + limit.normal * force;
            offer(soonest,
                  first_quadratic_fall(at_hand, limit.tangent * jerk, -limit.tangent * spring.stiffness * a / 2, never),
                  limit);
        }
    return plan_until(soonest, on_track, mode,
                      Ballistic{from, a * on_track.track.along, -rim_rate / context.ball.radius}, since);
}

// q'' = alpha (a_0 - stiffness q - damping q') + beta N is a swing about its equilibrium.
class SwingingLine {
public:
    SwingingLine(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode)
        : context_(context),
          on_track_(on_track),
          mode_(mode),
          spring_{mode.alpha * context.field.spring.decay, mode.alpha * context.field.spring.stiffness} {
        force_ = normal_force(context, on_track);
        acceleration_ = mode.alpha * tangent_acceleration(context, on_track) + mode.beta * force_;
        // From q'' + 2 decay q' + stiffness (q - equilibrium) = 0 at the beginning.
        // Where grip has just been lost the slip grows from nothing; rounding must not end it at once.
        if (on_track.slip() == 0)
            onset_ = line_onset_rounding *
                     (std::abs(on_track.speed) + std::abs(acceleration_) / std::sqrt(spring_.stiffness));
        way_ = -(acceleration_ + 2 * spring_.decay * on_track.speed) / spring_.stiffness;
    }

    LegPlan plan(TrackEnds const& ends, double since) const {
        LegEnd soonest;
        offer_ends_at_hand(soonest, context_, on_track_, ends, acceleration_);
        find(soonest, ends.high.q - (on_track_.q - way_), 0, {-way_, -on_track_.speed}, ends.high);
        find(soonest, (on_track_.q - way_) - ends.low.q, 0, {way_, on_track_.speed}, ends.low);
        for (int i = 0; i < mode_.limit_count; ++i) find_limit(soonest, mode_.limits[i]);
        double const rim_rate = mode_.gamma * force_;
        if (mode_.phase == Phase::slide)
            find(soonest, onset_ - mode_.sign * on_track_.rim, -mode_.sign * rim_rate,
                 {mode_.sign * on_track_.speed, mode_.sign * acceleration_}, LegEndCause::grips);
        else if (mode_.sign != 0)
            find(soonest, 0, 0, {mode_.sign * on_track_.speed, mode_.sign * acceleration_}, LegEndCause::stops);
        double const r = context_.ball.radius;
        bool const rolls = mode_.phase == Phase::roll;
        LineSwing const motion{
            state_of(context_, on_track_), on_track_.track.along, way_, on_track_.speed, spring_, rolls ? 1 / r : 0,
            rolls ? 0 : -rim_rate / r};
        return plan_until(soonest, on_track_, mode_, motion, since);
    }

private:
    template <typename What>
    void find(LegEnd& soonest, double c0, double c1, Swing const& start, What const& what) const {
        if (std::isinf(c0)) return;
        geometry::SwingSearch const search = geometry::first_swing_fall(c0, c1, spring_, start, soonest.time);
        offer(soonest, search.time, what);
        if (!search.time && search.searched_until < soonest.time)
            offer(soonest, search.searched_until, Limit{0, 0, LegEndCause::goes_on, ModeHint::none});
    }

    // tangent a_t + normal N, where a_t = (q'' - beta N) / alpha and q'' is a swing of its own.
    void find_limit(LegEnd& soonest, Limit const& limit) const {
        double const jerk = -2 * spring_.decay * acceleration_ - spring_.stiffness * on_track_.speed;
        double const share = limit.tangent / mode_.alpha;
        find(soonest, limit.normal * force_ - share * mode_.beta * force_, 0, {share * acceleration_, share * jerk},
             limit);
    }

    MotionContext const& context_;
    SurfaceState const& on_track_;
    ContactMode const& mode_;
    Oscillator spring_;
    double force_ = 0;
    double acceleration_ = 0;
    double onset_ = 0;  // m/s
    double way_ = 0;    // m, from the equilibrium
};

}  // namespace

LegPlan plan_line(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                  TrackEnds const& ends, double since) {
    if (!context.field.pulled || mode.alpha == 0) return steady_line(context, on_track, mode, ends, since);
    return SwingingLine(context, on_track, mode).plan(ends, since);
}

namespace {

// The bounces to come, seen as a whole: how long they take, and whether they end the slip.
struct Bounces {
    double span = 0;     // s
    double squares = 0;  // s, the sum of the squares of their times, by the span
    double grip = 0;     // friction against the pressing force, in the mean
    bool slide = false;  // all of them slip
};
Bounces bounces_after(MotionContext const& context, SurfaceState const& on_track, double hop) {
    Material const& material = material_of(context.terrain, on_track.contact.feature);
    double const e = material.restitution, k = context.ball.inertia, pressing = normal_force(context, on_track);
    Bounces bounces;
    bounces.span = e < 1 ? 2 * hop / (pressing * (1 - e)) : 0;
    if (context.field.pulled && bounces.span > longest_sum) bounces.span = 0;
    bounces.squares = bounces.span > 0 ? 2 * hop / (pressing * (1 + e)) : 0;
    bounces.grip = material.friction * (1 + e) / 2;
    // The slip that friction could take away in all the bounces that are left, against the slip there is.
    double const slip_end = std::abs(on_track.slip()) - bounces.span * ((1 + 1 / k) * bounces.grip * pressing);
    bounces.slide = on_track.slip() != 0 && slip_end > 0;
    return bounces;
}

}  // namespace

bool sums_exactly(MotionContext const& context, SurfaceState const& on_track, double hop) {
    if (!on_track.track.straight || context.field.pulled) return false;
    double const k = context.ball.inertia, pressing = normal_force(context, on_track);
    Bounces const bounces = bounces_after(context, on_track, hop);
    if (on_track.slip() != 0) return bounces.slide;
    return k / (1 + k) * std::abs(tangent_acceleration(context, on_track)) <= bounces.grip * pressing;
}

LegPlan plan_settling(MotionContext const& context, SurfaceState const& on_track, double hop, double since) {
    double const k = context.ball.inertia;
    double const pressing = normal_force(context, on_track);
    double const a = tangent_acceleration(context, on_track);
    auto const [span, squares, grip, slides] = bounces_after(context, on_track, hop);
    double const sign = on_track.slip() > 0 ? 1 : -1;
    SurfaceState end = on_track;
    double acceleration = slides ? a - grip * pressing * sign : a / (1 + k);
    if (!slides)
        end.speed = end.rim = on_track.slip() == 0 ? on_track.speed : (on_track.speed + k * on_track.rim) / (1 + k);
    double rim_rate = slides ? grip * pressing * sign / k : acceleration;
    // In flight nothing but the pull acts: the way is ahead of, and the turn behind, what the means make of them. The
    // leg ends with the place, the angle and the speeds of the sum.
    if (span > 0) {
        double const ahead = (a - acceleration) * squares, behind = rim_rate * squares;
        end.speed += ahead;
        acceleration -= ahead / span;
        end.rim -= behind;
        rim_rate += behind / span;
    }
    LegPlan plan;
    plan.leg.since = since;
    plan.leg.until = since + span;
    plan.end.time = span;
    plan.leg.phase = Phase::flight;
    plan.leg.contact = on_track.contact;
    plan.leg.motion =
        Ballistic{state_of(context, end), acceleration * geometry::turned_right(normal_at(on_track.track, on_track.q)),
                  -rim_rate / context.ball.radius};
    plan.end.cause = LegEndCause::settles;
    return plan;
}

}  // namespace physics
