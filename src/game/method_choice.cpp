#include "game/method_choice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "game/tolerance.h"
#include "physics/advice.h"
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

double rate_within(double tolerance) {
    double const usual = physics::Steps{}.rate;
    return std::clamp(usual * std::sqrt(usual_error / tolerance), usual, highest_tolerance_rate);
}

namespace {

physics::Choice named_or_chosen(MethodWish const& wish, physics::Scene const& scene) {
    if (wish.name == "article") return {physics::Article{wish.rate.value_or(physics::Article{}.rate)}, "it was named"};
    if (wish.name == "euler") return {physics::Euler{wish.rate.value_or(physics::Euler{}.rate)}, "it was named"};
    if (wish.name == "exact") return {physics::Exact{}, "it was named"};
    if (wish.name == "steps") {
        double const rate = wish.tolerance ? rate_within(*wish.tolerance) : physics::Steps{}.rate;
        return {physics::Steps{wish.rate.value_or(rate)}, "it was named"};
    }
    physics::Choice choice = wish.tolerance ? physics::advice_for(scene, *wish.tolerance) : physics::choice_for(scene);
    if (auto* steps = std::get_if<physics::Steps>(&choice.method)) steps->rate = wish.rate.value_or(steps->rate);
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
