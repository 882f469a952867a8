// Rolling on a circular track where nothing damps: a pendulum, in elliptic functions of the time. What ends it is known
// by the angle at which it happens, and one elliptic integral gives the time (physics.md 3.7).
#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/plan/leg_plan.h"
#include "physics/plan/plan_track.h"

namespace physics {

using geometry::pi;

namespace {

// A pendulum that comes this near to standing still at the top, by the share of the energy that it lacks or has too
// much, is no pendulum to rounding.
constexpr double least_complement = 1e-24;
// Below this square of the rate nothing moves.
constexpr double least_energy = 1e-200;  // 1/s^2
// A fall this little behind is at hand.
constexpr double angle_rounding = 1e-9;  // rad

// c + a cos psi + b sin psi, for what must stay above zero.
struct Fall {
    double constant = 0, by_cosine = 0, by_sine = 0;
};

// The angle psi is counted from where the field pulls to, in the sense in which the ball sets out; so psi grows at
// first.
class PendulumPlan {
public:
    PendulumPlan(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode)
        : context_(context), on_track_(on_track), mode_(mode) {
        Track const& track = on_track.track;
        Field const& field = context.field;
        // The spring on a circle is a constant field and a radial pull (physics.md 3.6).
        Vec2 const pull = field.gravity + field.spring.stiffness * (field.target - track.origin);
        field_ = geometry::length(pull);
        radial_ = field.spring.stiffness * track.rho;
        phi_ = track.phi0 - track.sense * on_track.q / track.rho;
        auto const [sine, cosine] = geometry::sine_cosine(phi_);
        motion_.centre = track.origin;
        motion_.rho = track.rho;
        motion_.rolling = track.sense * track.rho / context.ball.radius;
        motion_.down = field_ > 0 ? Vec2(pull / field_) : Vec2::UnitX();
        set_out(geometry::dot(motion_.down, Vec2(cosine, sine)), geometry::cross(motion_.down, Vec2(cosine, sine)));
    }

    bool moves() const { return moves_; }

    LegPlan plan(TrackEnds const& ends, double since) const {
        LegEnd soonest;  // by the angle that psi has run through, back and forth
        double const along = on_track_.track.sense * field_ * motion_.sense * sine_;
        offer_ends_at_hand(soonest, context_, on_track_, ends, mode_.alpha * along);
        offer(soonest, until_fall(force()), Limit{0, 0, LegEndCause::lifts, ModeHint::none});
        for (int i = 0; i < mode_.limit_count; ++i)
            offer(soonest, until_fall(fall_of(mode_.limits[i])), mode_.limits[i]);
        bool const high_first = on_track_.track.sense * motion_.sense < 0;
        double const to_high = (ends.high.q - on_track_.q) / motion_.rho,
                     to_low = (on_track_.q - ends.low.q) / motion_.rho;
        offer(soonest, until_end_ahead(high_first ? to_high : to_low), high_first ? ends.high : ends.low);
        offer(soonest, until_end_behind(high_first ? to_low : to_high), high_first ? ends.low : ends.high);
        soonest.time = time_of(soonest.time);
        return plan_until(soonest, on_track_, mode_, PendulumRun{std::make_shared<Pendulum>(motion_)}, since);
    }

private:
    // From the cosine and the sine of psi, counter-clockwise: the sense of the motion, the modulus and the phase.
    void set_out(double cosine, double sine) {
        double const turning = -on_track_.track.sense * on_track_.speed / on_track_.track.rho;
        motion_.sense = (turning != 0 ? turning : -sine) < 0 ? -1 : 1;
        cosine_ = cosine;
        sine_ = motion_.sense * sine;
        double const larger = std::sqrt(0.5 * (1 + std::abs(cosine))), smaller = 0.5 * std::abs(sine) / larger;
        double const y = cosine >= 0 ? larger : smaller;  // cos and sin of half psi
        double const x = std::copysign(cosine >= 0 ? smaller : larger, sine_);
        psi_ = 2 * geometry::arctangent(x, y);
        double const rate = 0.5 * std::abs(turning), own = std::sqrt(mode_.alpha * field_ / on_track_.track.rho);
        double const energy = rate * rate + own * own * x * x;
        double const lacking = (own * y - rate) * (own * y + rate);  // to stand still at the top
        motion_.turns_over = lacking < 0;
        parameter_ = motion_.turns_over ? own * own / energy : energy / (own * own);
        double const complement = std::abs(lacking) / (motion_.turns_over ? energy : own * own);
        moves_ = (turning != 0 || sine != 0) && energy > least_energy && complement > least_complement;
        if (!moves_) return;
        complement_ = complement;
        motion_.functions = geometry::Jacobi(parameter_, complement);
        motion_.pace = motion_.turns_over ? std::sqrt(energy) : own;
        // Exactly |x| where the ball stands.
        motion_.swing = motion_.turns_over ? 1 : std::sqrt(x * x + (rate / own) * (rate / own));
        highest_ = motion_.turns_over ? never : 2 * geometry::arctangent(motion_.swing, std::sqrt(complement));
        double const k = motion_.functions.quarter_period();
        motion_.phase = motion_.turns_over
                            ? geometry::first_kind(x, y, rate / motion_.pace, k)
                            : geometry::first_kind(x / motion_.swing, rate / (own * motion_.swing), y, k);
        motion_.phi_down = phi_ - motion_.sense * psi_;
        motion_.angle = on_track_.angle - motion_.rolling * motion_.sense * psi_;
    }

    // The normal force by the integral of energy, and a_t = sense field sin psi.
    Fall force() const {
        Track const& track = on_track_.track;
        double const at_start =
            on_track_.speed * on_track_.speed / track.rho - 2 * mode_.alpha * field_ * cosine_ - radial_;
        return {-track.sense * at_start, -track.sense * field_ * (1 + 2 * mode_.alpha), 0};
    }
    Fall fall_of(Limit const& limit) const {
        Fall const normal = force();
        return {limit.normal * normal.constant, limit.normal * normal.by_cosine,
                limit.tangent * on_track_.track.sense * motion_.sense * field_};
    }

    static double turn_to(double angle, bool at_hand) {
        double const turn = geometry::within_turn(angle);
        return at_hand && 2 * pi - turn < angle_rounding ? 0 : turn;
    }

    double to_top() const { return highest_ - psi_; }

    double until_fall(Fall const& fall) const {
        double const swing = std::sqrt(fall.by_cosine * fall.by_cosine + fall.by_sine * fall.by_sine);
        if (!(swing > std::abs(fall.constant))) return fall.constant > 0 ? never : 0;
        double const gap = fall.constant + fall.by_cosine * cosine_ + fall.by_sine * sine_;
        bool const closing = fall.by_sine * cosine_ - fall.by_cosine * sine_ < 0;
        if (gap <= 0 && closing) return 0;
        double const crest = geometry::arctangent(fall.by_sine, fall.by_cosine);
        double const half = geometry::arccosine(-fall.constant / swing);
        double const ahead = turn_to(crest + half - psi_, closing);
        if (motion_.turns_over || ahead <= to_top()) return ahead;
        double const back = turn_to(highest_ - (crest - half), false);
        if (back <= 2 * highest_) return to_top() + back;
        double const again = turn_to(crest + half + highest_, false);
        return again <= highest_ + psi_ ? to_top() + 2 * highest_ + again : never;
    }

    double until_end_ahead(double turn) const { return turn < to_top() ? std::max(0.0, turn) : never; }
    double until_end_behind(double turn) const {
        return !motion_.turns_over && turn < highest_ + psi_ ? 2 * to_top() + std::max(0.0, turn) : never;
    }

    // The argument of the functions on the way up to psi.
    double phase_at(double psi) const {
        double const k = motion_.functions.quarter_period();
        double const half_turns = motion_.turns_over ? (0.5 / pi) * psi + geometry::rounder - geometry::rounder : 0;
        auto const [x, y] = geometry::sine_cosine(0.5 * psi - half_turns * pi);
        if (motion_.turns_over)
            return geometry::first_kind(x, y, std::sqrt(complement_ + parameter_ * y * y), k) + 2 * k * half_turns;
        double const sn = std::clamp(x / motion_.swing, -1.0, 1.0);
        return geometry::first_kind(sn, std::sqrt((1 - sn) * (1 + sn)), y, k);
    }

    double time_of(double run) const {
        if (run == 0 || run == never) return run;
        double const k = motion_.functions.quarter_period();
        double phase;
        if (motion_.turns_over || run <= to_top())
            phase = phase_at(psi_ + run);
        else if (double const down = run - to_top(); down <= 2 * highest_)
            phase = 2 * k - phase_at(highest_ - down);
        else
            phase = 4 * k + phase_at(down - 3 * highest_);
        return std::max(0.0, (phase - motion_.phase) / motion_.pace);
    }

    MotionContext const& context_;
    SurfaceState const& on_track_;
    ContactMode const& mode_;
    Pendulum motion_;
    bool moves_ = false;
    double field_ = 0;                        // m/s^2
    double radial_ = 0;                       // m/s^2, the spring's pull to the centre
    double phi_ = 0;                          // rad, polar, at the beginning
    double psi_ = 0, cosine_ = 1, sine_ = 0;  // at the beginning
    double highest_ = never;                  // rad, psi where it turns back
    double parameter_ = 0, complement_ = 1;   // k^2 and 1 - k^2
};

}  // namespace

std::optional<LegPlan> plan_pendulum(MotionContext const& context, SurfaceState const& on_track,
                                     ContactMode const& mode, TrackEnds const& ends, double since) {
    if (mode.phase != Phase::roll || mode.beta != 0 || context.field.spring.decay != 0) return std::nullopt;
    PendulumPlan const pendulum(context, on_track, mode);
    if (!pendulum.moves()) return std::nullopt;
    return pendulum.plan(ends, since);
}

}  // namespace physics
