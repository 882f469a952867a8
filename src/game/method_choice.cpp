#include "game/method_choice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "game/tolerance.h"
#include "geometry/elementary.h"
#include "physics/exact/exact.h"

namespace game {

bool is_method_name(std::string const& name) {
    return name == "auto" || name == "article" || name == "euler" || name == "steps" || name == "exact";
}

std::optional<std::string> objection_to(MethodWish const& wish) {
    if (wish.rate && !(*wish.rate >= lowest_rate && *wish.rate <= highest_rate))
        return "the rate must be between 1 and 1000000 steps a second";
    if (wish.tolerance && !(std::isfinite(*wish.tolerance) && *wish.tolerance > 0))
        return "the tolerance must be greater than 0 metres";
    if (!wish.name) return std::nullopt;
    if (!is_method_name(*wish.name))
        return "unknown method \"" + *wish.name + "\": choose one of auto, article, euler, steps, exact";
    if (wish.tolerance && wish.name == "article")
        return "the method \"article\" keeps no tolerance: its error is of the model, not of the step";
    return std::nullopt;
}

namespace {

constexpr double slowest_pile_rate = 60, fastest_pile_rate = 960;  // steps/s, between which piles were measured

// Balls that lean on each other sag by the weight borne over m (2 pi f)^2, f half of the rate. While it settles, no
// pile of n discs that was measured was deeper than this many times what a column of sqrt(n / 2) sags by
// (physics.md 9.2).
constexpr double deepest_in_column = 25;

double pile_rate_within(double tolerance, physics::Scene const& scene) {
    auto const lighter = [](physics::Ball const& a, physics::Ball const& b) { return a.mass < b.mass; };
    auto const [lightest, heaviest] = std::minmax_element(scene.balls.begin(), scene.balls.end(), lighter);
    double const column = std::sqrt(static_cast<double>(scene.balls.size()) / 2) * heaviest->mass / lightest->mass;
    return std::sqrt(deepest_in_column * column * scene.gravity / tolerance) / geometry::pi;
}

bool is_pile(physics::Scene const& scene) {
    return std::holds_alternative<physics::Steps>(physics::choice_for(scene).method);
}

}  // namespace

double rate_within(double tolerance, physics::Scene const& scene) {
    if (is_pile(scene)) return std::clamp(pile_rate_within(tolerance, scene), slowest_pile_rate, fastest_pile_rate);
    double const usual = physics::Steps{}.rate;
    return std::clamp(usual * std::sqrt(usual_error / tolerance), usual, highest_tolerance_rate);
}

namespace {

// Of a pile, which alone is stepped without being named.
std::string pile_keeps(double tolerance, physics::Scene const& scene, double rate) {
    std::string const at = "steps at " + std::to_string(std::lround(rate)) + " steps/s";
    return pile_rate_within(tolerance, scene) <= fastest_pile_rate
               ? at + " kept " + in_metres(tolerance) + " in every pile that was measured"
               : "nothing is known to keep " + in_metres(tolerance) + "; nearest, " + at;
}

physics::Choice named_or_chosen(MethodWish const& wish, physics::Scene const& scene) {
    if (wish.name == "article") return {physics::Article{wish.rate.value_or(physics::Article{}.rate)}, "it was named"};
    if (wish.name == "euler") return {physics::Euler{wish.rate.value_or(physics::Euler{}.rate)}, "it was named"};
    if (wish.name == "exact") return {physics::Exact{}, "it was named"};
    physics::Choice choice =
        wish.name == "steps" ? physics::Choice{physics::Steps{}, "it was named"} : physics::choice_for(scene);
    auto* const steps = std::get_if<physics::Steps>(&choice.method);
    if (steps && wish.rate) {
        steps->rate = *wish.rate;
    } else if (steps && wish.tolerance) {
        steps->rate = rate_within(*wish.tolerance, scene);
        if (wish.name != "steps") choice.why = pile_keeps(*wish.tolerance, scene, steps->rate);
    }
    return choice;
}

}  // namespace

physics::Choice choice_for(MethodWish const& wish, physics::Scene const& scene) {
    if (auto const objection = objection_to(wish)) throw std::runtime_error(*objection);
    physics::Choice choice = named_or_chosen(wish, scene);
    if (wish.tolerance && !is_promised(choice.method, scene)) choice.why += "; " + doubt_about(choice.method, scene);
    return choice;
}

physics::Method method_for(MethodWish const& wish, physics::Scene const& scene) {
    return choice_for(wish, scene).method;
}

double rate_of(physics::Method const& method) {
    struct Rates {
        double operator()(physics::Article const& article) const { return article.rate; }
        double operator()(physics::Euler const& euler) const { return euler.rate; }
        double operator()(physics::Steps const& steps) const { return steps.rate; }
        double operator()(physics::Exact const&) const { return physics::handover_rate; }
    };
    return std::visit(Rates{}, method);
}

}  // namespace game
