// Circular tracks: the motion as power series in time, to machine precision in one stride (physics.md 3.5, 3.9).
#include <array>
#include <cmath>

#include "geometry/elementary.h"
#include "geometry/polynomial.h"
#include "physics/plan/leg_plan.h"
#include "physics/plan/plan_track.h"
#include "physics/motion/strides.h"

namespace physics {

namespace {

// The last coefficients' terms at the end of a stride, against the motion's own size: below rounding.
constexpr double truncation = 1e-17;
// A rate of slip below this share of the acceleration is rounding.
constexpr double circle_onset_rounding = 1e-12;

// The motion about the ball's present place, coefficients by power of the time.
struct Expansion {
    Series phi{}, sine{}, cosine{};
    Series speed{};    // m/s, along t
    Series way{};      // m, along t, from q
    Series rim{};      // m/s
    Series force{};    // normal force per mass
    Series tangent{};  // a_t
};

// Divisions are what an expansion would wait for most.
constexpr std::array<double, series_order + 2> reciprocal = [] {
    std::array<double, series_order + 2> all{};
    for (int n = 1; n < series_order + 2; ++n) all[n] = 1.0 / n;
    return all;
}();

// n-th coefficient of the square of a series.
double square_term(Series const& a, int n) {
    double sum = 0;
    for (int i = 0; 2 * i < n; ++i) sum += a[i] * a[n - i];
    return n % 2 == 0 ? 2 * sum + a[n / 2] * a[n / 2] : 2 * sum;
}

// (n+1)-th coefficients of the sine and cosine of an angle, from its rate's and their own up to the n-th.
geometry::SineCosine chain_terms(Series const& rate, Expansion const& x, int n) {
    double sine = 0, cosine = 0;
    for (int j = 0; j <= n; ++j) {
        sine += rate[j] * x.cosine[n - j];
        cosine += rate[j] * x.sine[n - j];
    }
    return {sine * reciprocal[n + 1], -(cosine * reciprocal[n + 1])};
}

Expansion expansion_of(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode) {
    Track const& track = on_track.track;
    Field const& field = context.field;
    // The spring on a circle is a constant field and a radial pull (physics.md 3.6).
    Vec2 const constant = field.gravity + field.spring.stiffness * (field.target - track.origin);
    double const radial = field.spring.stiffness * track.rho;
    double const s = track.sense;
    Expansion x;
    x.phi[0] = track.phi0 - s * on_track.q / track.rho;
    auto const [sine, cosine] = geometry::sine_cosine(x.phi[0]);
    x.sine[0] = sine;
    x.cosine[0] = cosine;
    x.speed[0] = on_track.speed;
    x.rim[0] = on_track.rim;
    Series rate{};  // of phi
    double const curvature = 1 / track.rho;
    for (int n = 0; n <= series_order; ++n) {
        double const outward = constant.x() * x.cosine[n] + constant.y() * x.sine[n] - (n == 0 ? radial : 0);
        x.force[n] = -s * (square_term(x.speed, n) * curvature + outward);
        x.tangent[n] =
            s * (constant.x() * x.sine[n] - constant.y() * x.cosine[n]) - 2 * field.spring.decay * x.speed[n];
        if (n == series_order) break;
        double const share = reciprocal[n + 1];
        x.speed[n + 1] = (mode.alpha * x.tangent[n] + mode.beta * x.force[n]) * share;
        x.rim[n + 1] = mode.phase == Phase::slide ? mode.gamma * x.force[n] * share : x.speed[n + 1];
        x.way[n + 1] = x.speed[n] * share;
        rate[n] = -s * curvature * x.speed[n];
        x.phi[n + 1] = rate[n] * share;
        auto const [next_sine, next_cosine] = chain_terms(rate, x, n);
        x.sine[n + 1] = next_sine;
        x.cosine[n + 1] = next_cosine;
    }
    return x;
}

// The longest stride at which the terms left out do not show.
double stride_of(Expansion const& x, double rho) {
    double const size = truncation * (1 + std::abs(x.phi[1]));
    double const last = std::abs(x.speed[series_order]) / rho, before = std::abs(x.speed[series_order - 1]) / rho;
    return longest_stride<series_order>(last, before, size);
}

Series combined(double a, Series const& x, double b, Series const& y) {
    Series sum;
    for (int i = 0; i <= series_order; ++i) sum[i] = a * x[i] + b * y[i];
    return sum;
}

Series distance_to(Series const& way, double limit, double direction) {
    Series gap;
    for (int i = 0; i <= series_order; ++i) gap[i] = -direction * way[i];
    gap[0] = std::max(0.0, limit);
    return gap;
}

// Slip in its own sense. Where grip has just been lost it begins with nothing, and at first grows by its second power
// alone: the rounding of its rate must not end it.
Series slip_series(SurfaceState const& on_track, ContactMode const& mode, Expansion const& x) {
    Series slip = combined(mode.sign, x.speed, -mode.sign, x.rim);
    if (on_track.slip() != 0) return slip;
    slip[0] = 0;
    if (std::abs(slip[1]) <= circle_onset_rounding * std::abs(x.tangent[0])) slip[1] = 0;
    return slip;
}

Series angle_series(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                    Expansion const& x) {
    Series angle{};
    angle[0] = on_track.angle;
    for (int i = 1; i <= series_order; ++i)
        angle[i] = (mode.phase == Phase::slide ? -x.rim[i - 1] / i : -x.way[i]) / context.ball.radius;
    return angle;
}

}  // namespace

LegPlan plan_circle(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                    TrackEnds const& ends, double since) {
    Expansion const x = expansion_of(context, on_track, mode);
    LegEnd soonest;
    offer(soonest, stride_of(x, on_track.track.rho), Limit{0, 0, LegEndCause::goes_on, ModeHint::none});
    offer_ends_at_hand(soonest, context, on_track, ends, x.speed[1]);
    auto const look = [&](Series const& gap, auto const& what) {
        offer(soonest, geometry::first_fall(gap, soonest.time), what);
    };
    look(x.force, LegEndCause::lifts);
    for (int i = 0; i < mode.limit_count; ++i)
        look(combined(mode.limits[i].tangent, x.tangent, mode.limits[i].normal, x.force), mode.limits[i]);
    if (ends.high.q < never) look(distance_to(x.way, ends.high.q - on_track.q, 1), ends.high);
    if (ends.low.q > -never) look(distance_to(x.way, on_track.q - ends.low.q, -1), ends.low);
    if (mode.phase == Phase::slide) look(slip_series(on_track, mode, x), LegEndCause::grips);
    if (mode.phase == Phase::roll && mode.sign != 0) look(combined(mode.sign, x.speed, 0, x.speed), LegEndCause::stops);
    auto const series = std::make_shared<CircleSeries>();
    series->centre = on_track.track.origin;
    series->rho = on_track.track.rho;
    series->phi = x.phi;
    series->angle = angle_series(context, on_track, mode, x);
    return plan_until(soonest, on_track, mode, CircleRun{series}, since);
}

}  // namespace physics
