#include "geometry/swing_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bracket.h"
#include "geometry/elementary.h"

namespace geometry {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double end_of_time = 1e300;    // s, stands for "after everything has settled"
constexpr double swing_extremum_share = 1e-9;  // of t: the gap at an extremum errs by its square
constexpr double swing_event_share = 2.5e-16;  // of t
constexpr int most_turns = 100000;       // then the search gives up and says how far it came

// y' is an oscillation of the same oscillator.
Swing rate_of(Oscillator const& o, Swing const& s) {
    return {s.rate, -(2 * o.decay * s.rate + o.stiffness * s.displacement)};
}

// The zeros of an oscillation after t = 0: evenly spaced for ever, or a single one, or none.
class Zeros {
public:
    Zeros(Oscillator const& o, Swing const& start) {
        double const cosine_part = start.displacement;
        double const sine_part = start.rate + o.decay * start.displacement;
        if (cosine_part == 0 && sine_part == 0) return;
        if (o.discriminant < 0) {
            double const angle = arctangent(-cosine_part * o.root, sine_part);
            first_ = (angle > 0 ? angle : angle + pi) * o.root_inverse;
            spacing_ = pi * o.root_inverse;
        } else if (cosine_part * sine_part < 0) {
            double const tangent = -cosine_part * o.root / sine_part;
            if (tangent < 1) first_ = o.root > 0 ? hyperbolic_arctangent(tangent) / o.root : -cosine_part / sine_part;
        }
    }

    double next_after(double t) const {
        if (t < first_) return first_;
        if (spacing_ == never) return never;
        double const count = std::floor((t - first_) / spacing_);
        // By multiplication, as the zero at t itself may have been found; rounding may put it on either side of the
        // floor.
        double const next = first_ + spacing_ * (count + 1);
        return next > t ? next : first_ + spacing_ * (count + 2);
    }

    double spacing() const { return spacing_; }

private:
    double first_ = never;
    double spacing_ = never;
};

class Gap {
public:
    struct State {
        double value = 0;
        double rate = 0;
        double bend = 0;
        double noise = 0;  // of the value
    };

    Gap(double c0, double c1, Oscillator const& oscillator, Swing const& start)
        : c0_(c0), c1_(c1), oscillator_(oscillator), start_(start) {
        if (!(oscillator.discriminant < 0)) return;
        double const sine_part = (start.rate + oscillator.decay * start.displacement) * oscillator.root_inverse;
        swing_ = std::sqrt(start.displacement * start.displacement + sine_part * sine_part);
        swing_rate_ = swing_ * std::sqrt(oscillator.stiffness);
    }

    State at(double t) const {
        Swing const y = swing_after(oscillator_, basis_at(oscillator_, t), start_);
        double const line = c0_ + c1_ * t;
        return {line + y.displacement, c1_ + y.rate, rate_of(oscillator_, y).rate,
                1e-16 * (std::abs(c0_) + std::abs(c1_ * t) + std::abs(y.displacement))};
    }

    // A time until which the gap surely stays above zero, if it is later than t; the envelope of y decides.
    double open_until(double t) const {
        double const margin = c0_ + c1_ * t - swing_ * decayed(t);
        if (!(margin > 0)) return t;
        return c1_ < 0 ? t - margin / c1_ : never;
    }

    // Whether the line is steeper than the oscillation will ever be again.
    bool is_straight_after(double t) const { return std::abs(c1_) > swing_rate_ * decayed(t); }

    // The sign of the rate just after t.
    int direction_after(double t) const {
        State const state = at(t);
        if (state.rate != 0) return sign_of(state.rate);
        if (state.bend != 0) return sign_of(state.bend);
        return sign_of(-oscillator_.stiffness * (state.rate - c1_));
    }

    bool repeats() const { return c1_ == 0 && oscillator_.decay == 0; }
    bool is_level() const { return c1_ == 0; }
    Oscillator const& oscillator() const { return oscillator_; }
    Swing const& start() const { return start_; }

private:
    double decayed(double t) const { return oscillator_.decay == 0 ? 1 : exponential(-oscillator_.decay * t); }

    double c0_;
    double c1_;
    Oscillator oscillator_;
    Swing start_;
    double swing_ = never;       // m, envelope of y at t = 0; infinite where y does not oscillate
    double swing_rate_ = never;  // m/s, envelope of y'
};

// A time after `from` at which `state_at` has the sign it keeps for ever, or never if that is `sign` or zero.
template <typename ValueAt>
double change_after(ValueAt const& value_at, double from, int sign) {
    if (sign_of(value_at(end_of_time)) != -sign) return never;
    double t = from > 0 ? 2 * from : 1.0;
    while (t < end_of_time && sign_of(value_at(t)) != -sign) t *= 4;
    return t;
}

// The extrema of the gap, one after the other.
class Turns {
public:
    Turns(Gap const& gap, double from)
        : gap_(&gap), bends_(gap.oscillator(), bend_start(gap)), from_(from), direction_(gap.direction_after(from)) {
        if (!gap.is_level()) return;
        // At an extremum the sign of the rate is rounding; half way to the next one it is not.
        double const next = bends_.next_after(from);
        if (next < never && next > from) direction_ = sign_of(gap.at(from + (next - from) / 2).rate);
    }

    int direction() const { return direction_; }
    double spacing() const { return bends_.spacing(); }

    // The next extremum before `until`, or never.
    double next(double until) {
        double const turn = gap_->is_level() ? bends_.next_after(from_) : next_between_bends(until);
        if (!(turn < until)) return never;
        if (gap_->is_level()) from_ = turn;
        direction_ = -direction_;
        return turn;
    }

private:
    // Without a line the extrema are the zeros of y' themselves; with one they lie between those of y''.
    static Swing bend_start(Gap const& gap) {
        Swing const rate = rate_of(gap.oscillator(), gap.start());
        return gap.is_level() ? rate : rate_of(gap.oscillator(), rate);
    }

    double next_between_bends(double until) {
        while (from_ < until) {
            if (gap_->is_straight_after(from_)) return never;
            double bend = std::min(bends_.next_after(from_), until);
            auto const rate_at = [this](double t) { return gap_->at(t).rate; };
            if (bend == never) bend = change_after(rate_at, from_, direction_);
            if (bend == never) return never;
            Bracket const bracket{from_, bend, rate_at(from_), rate_at(bend), direction_};
            from_ = bend;
            if (sign_of(bracket.high_value) == -direction_) return turn_in(bracket);
        }
        return never;
    }

    double turn_in(Bracket const& bracket) const {
        auto const slope_at = [this](double t) {
            Gap::State const state = gap_->at(t);
            return Slope{state.rate, state.bend};
        };
        return root_in(slope_at, bracket, swing_extremum_share);
    }

    Gap const* gap_;
    Zeros bends_;
    double from_;
    int direction_;
};

double fall_in(Gap const& gap, Bracket const& bracket) {
    auto const slope_at = [&gap](double t) {
        Gap::State const state = gap.at(t);
        return Slope{std::abs(state.value) <= state.noise ? 0 : state.value, state.rate};
    };
    return root_in(slope_at, bracket, swing_event_share);
}

}  // namespace

SwingSearch first_swing_fall(double c0, double c1, Oscillator const& oscillator, Swing const& start, double until) {
    Gap const gap(c0, c1, oscillator, start);
    auto const value_at = [&gap](double t) { return gap.at(t).value; };
    if (!(until >= 0)) return {std::nullopt, until};
    Turns turns(gap, 0);
    double t = 0;
    double value = c0 + start.displacement;
    for (int turn = 0; turn < most_turns; ++turn) {
        if (turns.direction() < 0 && !(value > 0)) return {t, t};
        if (double const open = gap.open_until(t); open > t + turns.spacing() || open == never) {
            if (!(open < until)) return {std::nullopt, until};
            turns = Turns(gap, open);
            t = open;
            value = value_at(t);
            continue;
        }
        bool const closing = turns.direction() < 0;
        double const extremum = turns.next(until);
        double high = std::min(extremum, until);
        if (high == never && closing) high = change_after(value_at, t, 1);
        if (high == never) return {std::nullopt, until};
        double const high_value = value_at(high);
        if (closing && high_value < 0) {
            double const fall = fall_in(gap, {t, high, value, high_value, 1});
            return {fall, fall};
        }
        if (extremum == never || (gap.repeats() && turn > 2)) return {std::nullopt, until};
        t = high;
        value = high_value;
    }
    return {std::nullopt, t};
}

}  // namespace geometry
