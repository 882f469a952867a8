// First contact in flight on the drag spring: the swing as a power series, window by window.
#include "geometry/elementary.h"
#include "physics/contact/gap_search.h"
#include "physics/motion/strides.h"

namespace physics {

using geometry::dot;

namespace {

// Of this order the square of the distance to a point has the most terms that a polynomial may have here.
constexpr int order = (geometry::most_coefficients - 1) / 2;
// The last term at the end of a window: what is left out is far below it. m, and as a share of the path's own size, of
// which no more is known
constexpr double window_truncation = 1e-13;
constexpr double truncation_share = 1e-16;

struct SwingPath {
    std::array<Vec2, order + 1> terms;  // m, m/s, ...
    double reach = 0;                   // m, from the equilibrium

    SwingPath(SpringFlight const& flight, double from) {
        State const now = state_on(flight, from);
        geometry::Oscillator const& o = flight.oscillator;
        terms[0] = now.position - flight.equilibrium;
        terms[1] = now.velocity;
        for (int n = 0; n + 2 <= order; ++n)
            terms[n + 2] = (2 * o.decay * (n + 1) * terms[n + 1] + o.stiffness * terms[n]) / (-1.0 * (n + 1) * (n + 2));
        reach = geometry::length(terms[0]);
        terms[0] = now.position;
    }

    SwingPath later(double t) const {
        SwingPath path = *this;
        for (int first = 0; first < order; ++first)
            for (int i = order - 1; i >= first; --i) path.terms[i] += t * path.terms[i + 1];
        return path;
    }

    double window() const {
        double const size = window_truncation + truncation_share * (geometry::length(terms[0]) + reach);
        return longest_stride<order>(geometry::length(terms[order]), geometry::length(terms[order - 1]), size);
    }
    // How far the path may lie from its chord within t.
    double sagitta(double t) const {
        double sum = 0;
        for (int i = order; i >= 2; --i) sum = (sum + geometry::length(terms[i])) * t;
        return sum * t;
    }

    std::array<double, order + 1> to_line(Vec2 const& normal, Vec2 const& point, double distance) const {
        std::array<double, order + 1> gap;
        gap[0] = dot(terms[0] - point, normal) - distance;
        for (int i = 1; i <= order; ++i) gap[i] = dot(terms[i], normal);
        return gap;
    }
    std::array<double, 2 * order + 1> to_circle(Vec2 const& centre, double rho) const {
        std::array<double, 2 * order + 1> gap{};
        Vec2 const out = terms[0] - centre;
        double const distance = geometry::length(out);
        gap[0] = (distance - rho) * (distance + rho);
        for (int i = 1; i <= order; ++i) {
            gap[i] += 2 * dot(out, terms[i]);
            gap[2 * i] += dot(terms[i], terms[i]);
            for (int j = 1; j < i; ++j) gap[i + j] += 2 * dot(terms[i], terms[j]);
        }
        return gap;
    }
    Vec2 at(double t) const {
        Vec2 sum = terms[order];
        for (int i = order - 1; i >= 0; --i) sum = terms[i] + t * sum;
        return sum;
    }
    double speed(double t) const {
        Vec2 sum = order * terms[order];
        for (int i = order - 1; i >= 1; --i) sum = i * terms[i] + t * sum;
        return geometry::length(sum);
    }
    double pull(double t) const {
        Vec2 sum = (order * (order - 1)) * terms[order];
        for (int i = order - 1; i >= 2; --i) sum = (i * (i - 1)) * terms[i] + t * sum;
        return geometry::length(sum);
    }
};

}  // namespace

SweepHit first_contact(Terrain const& terrain, SpringFlight const& flight, double radius, double from, double until) {
    for (double t = from; t < until;) {
        SwingPath const path(flight, t);
        // Where squares of lengths are no numbers any more there is nothing to meet.
        if (!std::isfinite(path.sagitta(1))) break;
        double const window = std::min(path.window(), until - t);
        GapSearch<SwingPath> search(terrain, path, radius, -1);
        geometry::Stroke const stroke =
            geometry::stroke_of(path.at(0), path.at(window), radius + touch_reach + path.sagitta(window));
        terrain.tree.each_near(stroke, [&](int piece) { search.look_at(piece, stroke.box, window); });
        if (search.first.time <= window) return {t + search.first.time, search.first.contact};
        if (!(t + window > t)) break;
        t += window;
    }
    return {until, no_contact};
}

}  // namespace physics
