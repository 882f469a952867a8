#include "physics/steps_swell.h"

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

std::vector<double> heaviest_about(Stage const& stage) {
    std::size_t const count = stage.travellers.size();
    Islands islands{std::vector<int>(count)};
    std::vector<double> heaviest(count);
    for (std::size_t i = 0; i < count; ++i) {
        islands.parent[i] = static_cast<int>(i);
        heaviest[i] = stage.travellers[i].ball->mass;
    }
    for (Neighbours const& pair : stage.neighbours) {
        if (!pair.leaning) continue;
        int const a = islands.root(pair.first), b = islands.root(pair.second);
        heaviest[a] = std::max(heaviest[a], heaviest[b]);
        islands.parent[b] = a;
    }
    for (std::size_t i = 0; i < count; ++i) heaviest[i] = heaviest[islands.root(static_cast<int>(i))];
    return heaviest;
}

std::vector<double> swells_of(Stage const& stage) {
    std::size_t const count = stage.travellers.size();
    std::vector<double> swells(count, 1.0);
    auto const [lightest, most] =
        std::minmax_element(stage.travellers.begin(), stage.travellers.end(),
                            [](Traveller const& a, Traveller const& b) { return a.ball->mass < b.ball->mass; });
    if (lightest->ball->mass == most->ball->mass) return swells;
    double const omega = 2 * geometry::pi * contact_frequency(1 / stage.pace);
    double const weight = geometry::length(stage.fields.front().gravity);
    std::vector<double> const heaviest = heaviest_about(stage);
    for (std::size_t i = 0; i < count; ++i) {
        Ball const& ball = *stage.travellers[i].ball;
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

void swell_light_balls(Stage& stage) {
    std::vector<double> const before = std::move(stage.pile.swell);
    std::vector<double>& now = stage.pile.swell;
    now = swells_of(stage);
    if (now == before) return;
    // What held a ball under its load would throw it without.
    for (std::vector<Touch>* touches : {&stage.pile.touches, &stage.pile.left})
        for (Touch& touch : *touches) scale(touch.impulse, now[touch.ball] / before[touch.ball]);
    for (Neighbours& pair : stage.neighbours) {
        double const by =
            std::max(now[pair.first], now[pair.second]) / std::max(before[pair.first], before[pair.second]);
        scale(pair.impulse, by);
        scale(pair.borne, by);
    }
}

}  // namespace physics
