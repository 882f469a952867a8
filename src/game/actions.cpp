#include "game/actions.h"

#include <algorithm>

namespace game {

namespace {

bool holds(std::vector<std::string> const& keys, std::string const& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::vector<std::string>& keys_of(Bindings& bindings, KeyAction action) {
    return bindings.keys[static_cast<std::size_t>(action)];
}

// The keys that are chosen for an action, as far as there are such; nothing where it keeps its own.
std::optional<std::vector<std::string>> understood(ActionRow const& row, ChosenKeys const& chosen,
                                                   std::function<std::string(std::string const&)> const& canonical,
                                                   std::vector<std::string>& faults) {
    auto const found = chosen.find(row.name);
    if (found == chosen.end()) return std::nullopt;
    std::vector<std::string> keys;
    for (std::string const& said : found->second) {
        std::string const key = canonical(said);
        if (key.empty())
            faults.push_back("keys: " + std::string(row.name) + ": there is no key \"" + said + "\"");
        else if (!holds(keys, key))
            keys.push_back(key);
    }
    if (keys.empty() && !found->second.empty()) return std::nullopt;
    return keys;
}

}  // namespace

std::vector<ActionRow> const& actions() {
    static std::vector<ActionRow> const rows = {
        {KeyAction::tilt_left, "tilt-left", Text::tilt_left, {"Left", "A"}},
        {KeyAction::tilt_right, "tilt-right", Text::tilt_right, {"Right", "D"}},
        {KeyAction::pause, "pause", Text::pause, {"Space"}},
        {KeyAction::single_step, "single-step", Text::single_step, {"N"}},
        {KeyAction::look_back, "look-back", Text::look_back, {",", "<"}},
        {KeyAction::look_forward, "look-forward", Text::look_forward, {".", ">"}},
        {KeyAction::slow_motion, "slow-motion", Text::slow_motion, {"S"}},
        {KeyAction::restart, "restart", Text::restart, {"R"}},
        {KeyAction::go_on, "go-on", Text::go_on, {"Return", "Keypad Enter"}},
        {KeyAction::levels, "levels", Text::levels, {"L"}},
        {KeyAction::next_level, "next-level", Text::next_level, {"Tab", "PageDown"}},
        {KeyAction::previous_level, "previous-level", Text::previous_level, {"PageUp"}},
        {KeyAction::turn_picture, "turn-picture", Text::turn_picture, {"T"}},
        {KeyAction::overlay, "overlay", Text::overlay, {"O"}},
        {KeyAction::mute, "mute", Text::mute, {"M"}},
        {KeyAction::softer, "softer", Text::softer, {"-", "Keypad -"}},
        {KeyAction::louder, "louder", Text::louder, {"+", "=", "Keypad +"}},
        {KeyAction::method, "method", Text::method, {"F3"}},
        {KeyAction::save, "save", Text::save, {"F5"}},
        {KeyAction::film, "film", Text::film, {"F6"}},
        {KeyAction::help, "help", Text::help, {"F1"}},
        {KeyAction::settings, "settings", Text::settings, {"F2"}},
        {KeyAction::full_screen, "full-screen", Text::full_screen, {"F11"}},
        {KeyAction::menu, "menu", Text::menu, {"Escape"}},
        {KeyAction::quit, "quit", Text::quit, {"Q"}},
    };
    return rows;
}

Bindings usual_bindings() {
    Bindings bindings;
    for (ActionRow const& row : actions()) keys_of(bindings, row.action) = row.keys;
    return bindings;
}

std::optional<KeyAction> action_of(Bindings const& bindings, std::string const& key) {
    for (ActionRow const& row : actions())
        if (holds(bindings.of(row.action), key)) return row.action;
    return std::nullopt;
}

Bound bindings_of(ChosenKeys const& chosen, std::function<std::string(std::string const&)> const& canonical) {
    Bound bound;
    for (auto const& entry : chosen)
        if (std::none_of(actions().begin(), actions().end(),
                         [&](ActionRow const& row) { return row.name == entry.first; }))
            bound.faults.push_back("keys: there is no action \"" + entry.first + "\"");
    std::array<bool, action_count> is_chosen{};
    for (ActionRow const& row : actions()) {
        auto const keys = understood(row, chosen, canonical, bound.faults);
        is_chosen[static_cast<std::size_t>(row.action)] = keys.has_value();
        for (std::string const& key : keys.value_or(std::vector<std::string>{}))
            if (auto const other = action_of(bound.bindings, key))
                bound.faults.push_back("keys: \"" + key + "\" stands for " + row_of(*other).name +
                                       " already, not for " + row.name);
            else
                keys_of(bound.bindings, row.action).push_back(key);
    }
    for (ActionRow const& row : actions()) {
        if (is_chosen[static_cast<std::size_t>(row.action)]) continue;
        for (std::string const& key : row.keys)
            if (!action_of(bound.bindings, key)) keys_of(bound.bindings, row.action).push_back(key);
        if (bound.bindings.of(row.action).empty())
            bound.faults.push_back("keys: " + std::string(row.name) + " has no key any more");
    }
    return bound;
}

Rebound rebound(Bindings bindings, KeyAction action, std::string const& key) {
    std::vector<std::string> const former = bindings.of(action);
    std::optional<KeyAction> const owner = action_of(bindings, key);
    keys_of(bindings, action) = {key};
    if (!owner || *owner == action) return {std::move(bindings), std::nullopt};
    std::vector<std::string>& left = keys_of(bindings, *owner);
    std::erase(left, key);
    if (left.empty() && !former.empty()) left.push_back(former.front());
    return {std::move(bindings), owner};
}

ChosenKeys chosen_keys(Bindings const& bindings, ChosenKeys const& before) {
    ChosenKeys chosen = before;
    for (ActionRow const& row : actions()) {
        chosen.erase(row.name);
        if (bindings.of(row.action) != row.keys) chosen[row.name] = bindings.of(row.action);
    }
    return chosen;
}

}  // namespace game
