#include "game/method_choice.h"

#include <stdexcept>

namespace game {

bool is_method_name(std::string const& name) {
    return name == "auto" || name == "article" || name == "steps" || name == "exact";
}

std::optional<std::string> objection_to(MethodWish const& wish) {
    if (wish.rate && !(*wish.rate >= lowest_rate && *wish.rate <= highest_rate))
        return "the rate must be between 1 and 1000000 steps a second";
    if (!wish.name) return std::nullopt;
    if (!is_method_name(*wish.name))
        return "unknown method \"" + *wish.name + "\": choose one of auto, article, steps, exact";
    if (*wish.name == "exact") return "the method \"exact\" is not part of this version yet: choose steps or article";
    return std::nullopt;
}

physics::Method method_for(MethodWish const& wish, physics::Scene const&) {
    if (auto const objection = objection_to(wish)) throw std::runtime_error(*objection);
    if (wish.name == "article") {
        physics::Article article;
        article.rate = wish.rate.value_or(article.rate);
        return article;
    }
    physics::Steps steps;
    steps.rate = wish.rate.value_or(steps.rate);
    return steps;
}

double rate_of(physics::Method const& method) {
    return std::visit([](auto const& stepping) { return stepping.rate; }, method);
}

}  // namespace game
