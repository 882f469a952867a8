#include "physics/steps/mass_scaling.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

namespace {

constexpr double firm = 60;             // Hz, of a contact between balls, as far as the substeps carry it
constexpr double light_overlap = 0.02;  // share of the radius by which a ball may be pressed into a lighter one

// The heaviest of the balls that lean on each other, by ball.
struct Islands {
    std::vector<int> parent;
    int root(int ball) {
        while (parent[ball] != ball) ball = parent[ball] = parent[parent[ball]];
        return ball;
    }
};

std::vector<double> heaviest_about(StepContext const& context) {
    std::size_t const count = context.body_states.size();
    Islands islands{std::vector<int>(count)};
    std::vector<double> heaviest(count);
    for (std::size_t i = 0; i < count; ++i) {
        islands.parent[i] = static_cast<int>(i);
        heaviest[i] = context.body_states[i].ball->mass;
    }
    for (BallPair const& pair : context.ball_pairs) {
        if (!pair.leaning) continue;
        int const a = islands.root(pair.first), b = islands.root(pair.second);
        heaviest[a] = std::max(heaviest[a], heaviest[b]);
        islands.parent[b] = a;
    }
    for (std::size_t i = 0; i < count; ++i) heaviest[i] = heaviest[islands.root(static_cast<int>(i))];
    return heaviest;
}

std::vector<double> swells_of(StepContext const& context) {
    std::size_t const count = context.body_states.size();
    std::vector<double> swells(count, 1.0);
    auto const [lightest, most] =
        std::minmax_element(context.body_states.begin(), context.body_states.end(),
                            [](BodyState const& a, BodyState const& b) { return a.ball->mass < b.ball->mass; });
    if (lightest->ball->mass == most->ball->mass) return swells;
    double const omega = 2 * geometry::pi * contact_frequency(1 / context.pace);
    double const weight = geometry::length(context.fields.front().gravity);
    std::vector<double> const heaviest = heaviest_about(context);
    for (std::size_t i = 0; i < count; ++i) {
        Ball const& ball = *context.body_states[i].ball;
        double const carried = weight > 0 ? light_overlap * ball.radius * omega * omega / weight : most_outweigh;
        double const allowed = std::clamp(carried, 1.0, most_outweigh);
        while (heaviest[i] > allowed * ball.mass * swells[i]) swells[i] *= 2;
    }
    return swells;
}

void scale(Impulse& impulse, double by) {
    impulse.normal *= by;
    impulse.tangent *= by;
}

}  // namespace

double contact_frequency(double substeps_per_second) {
    return std::min(substeps_per_second / 4, std::max(firm, substeps_per_second / 8));
}

void swell_light_balls(StepContext& context) {
    std::vector<double> const before = std::move(context.island.swell);
    std::vector<double>& now = context.island.swell;
    now = swells_of(context);
    if (now == before) return;
    // What held a ball under its load would throw it without.
    for (std::vector<CachedContact>* touches : {&context.island.cached_contacts, &context.island.left})
        for (CachedContact& touch : *touches) scale(touch.impulse, now[touch.ball] / before[touch.ball]);
    for (BallPair& pair : context.ball_pairs) {
        double const by =
            std::max(now[pair.first], now[pair.second]) / std::max(before[pair.first], before[pair.second]);
        scale(pair.impulse, by);
        scale(pair.borne, by);
    }
}

}  // namespace physics
