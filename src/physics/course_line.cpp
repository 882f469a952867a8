// Straight tracks: constant acceleration, or a damped swing on the drag spring (physics.md 2.3, 2.4).
#include <cmath>

#include "geometry/polynomial.h"
#include "geometry/swing_roots.h"
#include "physics/course.h"
#include "physics/course_track.h"

namespace physics {

using geometry::first_quadratic_fall;
using geometry::Oscillator;
using geometry::Swing;

namespace {

// A slip this small, against the speeds of the swing, is rounding.
constexpr double line_onset_rounding = 1e-14;
// Under a pull the field does not stay the same for longer, and the bounces that are left are let go. s
constexpr double longest_sum = 1e-4;

Course steady_line(Setting const& setting, Rider const& rider, Law const& law, TrackEnds const& ends, double since) {
    double const force = normal_force(setting, rider);
    double const a = law.alpha * tangent_acceleration(setting, rider) + law.beta * force;
    double const rim_rate = law.phase == Phase::slide ? law.gamma * force : a;
    State const from = state_of(setting, rider);
    Soonest soonest;
    offer_ends_at_hand(soonest, setting, rider, ends, a);
    if (ends.high.q < never)
        soonest.offer(first_quadratic_fall(std::max(0.0, ends.high.q - rider.q), -rider.speed, -a / 2, never),
                      ends.high);
    if (ends.low.q > -never)
        soonest.offer(first_quadratic_fall(std::max(0.0, rider.q - ends.low.q), rider.speed, a / 2, never), ends.low);
    if (law.phase == Phase::slide)
        soonest.offer(first_quadratic_fall(law.sign * rider.slip(), law.sign * (a - rim_rate), 0, never),
                      Ending::grips);
    else if (law.sign != 0)
        soonest.offer(first_quadratic_fall(law.sign * rider.speed, law.sign * a, 0, never), Ending::stops);
    return soonest.course(rider, law, Ballistic{from, a * rider.track.along, -rim_rate / setting.ball.radius}, since);
}

// q'' = alpha (a_0 - stiffness q - damping q') + beta N is a swing about its equilibrium.
class SwingingLine {
public:
    SwingingLine(Setting const& setting, Rider const& rider, Law const& law)
        : setting_(setting),
          rider_(rider),
          law_(law),
          spring_{law.alpha * setting.field.spring.decay, law.alpha * setting.field.spring.stiffness} {
        force_ = normal_force(setting, rider);
        acceleration_ = law.alpha * tangent_acceleration(setting, rider) + law.beta * force_;
        // From q'' + 2 decay q' + stiffness (q - equilibrium) = 0 at the beginning.
        // Where grip has just been lost the slip grows from nothing; rounding must not end it at once.
        if (rider.slip() == 0)
            onset_ = line_onset_rounding * (std::abs(rider.speed) + std::abs(acceleration_) / std::sqrt(spring_.stiffness));
        way_ = -(acceleration_ + 2 * spring_.decay * rider.speed) / spring_.stiffness;
    }

    Course course(TrackEnds const& ends, double since) const {
        Soonest soonest;
        offer_ends_at_hand(soonest, setting_, rider_, ends, acceleration_);
        find(soonest, ends.high.q - (rider_.q - way_), 0, {-way_, -rider_.speed}, ends.high);
        find(soonest, (rider_.q - way_) - ends.low.q, 0, {way_, rider_.speed}, ends.low);
        for (int i = 0; i < law_.limit_count; ++i) find_limit(soonest, law_.limits[i]);
        double const rim_rate = law_.gamma * force_;
        if (law_.phase == Phase::slide)
            find(soonest, onset_ - law_.sign * rider_.rim, -law_.sign * rim_rate,
                 {law_.sign * rider_.speed, law_.sign * acceleration_}, Ending::grips);
        else if (law_.sign != 0)
            find(soonest, 0, 0, {law_.sign * rider_.speed, law_.sign * acceleration_}, Ending::stops);
        double const r = setting_.ball.radius;
        bool const rolls = law_.phase == Phase::roll;
        LineSwing const motion{state_of(setting_, rider_), rider_.track.along,       way_, rider_.speed, spring_,
                               rolls ? 1 / r : 0,          rolls ? 0 : -rim_rate / r};
        return soonest.course(rider_, law_, motion, since);
    }

private:
    template <typename What>
    void find(Soonest& soonest, double c0, double c1, Swing const& start, What const& what) const {
        if (std::isinf(c0)) return;
        geometry::SwingSearch const search = geometry::first_swing_fall(c0, c1, spring_, start, soonest.time);
        soonest.offer(search.time, what);
        if (!search.time && search.searched_until < soonest.time)
            soonest.offer(search.searched_until, Limit{0, 0, Ending::goes_on, Onset::none});
    }

    // tangent a_t + normal N, where a_t = (q'' - beta N) / alpha and q'' is a swing of its own.
    void find_limit(Soonest& soonest, Limit const& limit) const {
        double const jerk = -2 * spring_.decay * acceleration_ - spring_.stiffness * rider_.speed;
        double const share = limit.tangent / law_.alpha;
        find(soonest, limit.normal * force_ - share * law_.beta * force_, 0, {share * acceleration_, share * jerk},
             limit);
    }

    Setting const& setting_;
    Rider const& rider_;
    Law const& law_;
    Oscillator spring_;
    double force_ = 0;
    double acceleration_ = 0;
    double onset_ = 0;  // m/s
    double way_ = 0;    // m, from the equilibrium
};

}  // namespace

Course line_course(Setting const& setting, Rider const& rider, Law const& law, TrackEnds const& ends, double since) {
    if (!setting.field.pulled || law.alpha == 0) return steady_line(setting, rider, law, ends, since);
    return SwingingLine(setting, rider, law).course(ends, since);
}

namespace {

// The bounces to come, seen as a whole: how long they take, and whether they end the slip.
struct Bounces {
    double span = 0;   // s
    double grip = 0;   // friction against the pressing force, in the mean
    bool slide = false;  // all of them slip
};
Bounces bounces_after(Setting const& setting, Rider const& rider, double hop) {
    Material const& material = material_of(setting.terrain, rider.contact.feature);
    double const e = material.restitution, k = setting.ball.inertia, pressing = normal_force(setting, rider);
    Bounces bounces;
    bounces.span = e < 1 ? 2 * hop / (pressing * (1 - e)) : 0;
    if (setting.field.pulled && bounces.span > longest_sum) bounces.span = 0;
    bounces.grip = material.friction * (1 + e) / 2;
    // The slip that friction could take away in all the bounces that are left, against the slip there is.
    double const slip_end = std::abs(rider.slip()) - bounces.span * ((1 + 1 / k) * bounces.grip * pressing);
    bounces.slide = rider.slip() != 0 && slip_end > 0;
    return bounces;
}

}  // namespace

bool sums_exactly(Setting const& setting, Rider const& rider, double hop) {
    if (!rider.track.straight || setting.field.pulled) return false;
    double const k = setting.ball.inertia, pressing = normal_force(setting, rider);
    Bounces const bounces = bounces_after(setting, rider, hop);
    if (rider.slip() != 0) return bounces.slide;
    return k / (1 + k) * std::abs(tangent_acceleration(setting, rider)) <= bounces.grip * pressing;
}

Course settling_course(Setting const& setting, Rider const& rider, double hop, double since) {
    double const k = setting.ball.inertia;
    double const pressing = normal_force(setting, rider);
    double const a = tangent_acceleration(setting, rider);
    auto const [span, grip, slides] = bounces_after(setting, rider, hop);
    double const sign = rider.slip() > 0 ? 1 : -1;
    Rider end = rider;
    double const acceleration = slides ? a - grip * pressing * sign : a / (1 + k);
    if (!slides) end.speed = end.rim = rider.slip() == 0 ? rider.speed : (rider.speed + k * rider.rim) / (1 + k);
    double const rim_rate = slides ? grip * pressing * sign / k : acceleration;
    Course course;
    course.leg.since = since;
    course.leg.until = since + span;
    course.duration = span;
    course.leg.phase = Phase::flight;
    course.leg.contact = rider.contact;
    course.leg.motion =
        Ballistic{state_of(setting, end), acceleration * geometry::turned_right(normal_at(rider.track, rider.q)),
                  -rim_rate / setting.ball.radius};
    course.ending = Ending::settles;
    return course;
}

}  // namespace physics
