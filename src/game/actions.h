// What keys do: one table of actions, each with the keys that it comes with, and what the player has made of it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/texts.h"

namespace game {

enum class KeyAction {
    tilt_left,
    tilt_right,
    pause,
    single_step,
    look_back,
    look_forward,
    slow_motion,
    restart,
    go_on,
    levels,
    next_level,
    previous_level,
    turn_picture,
    overlay,
    mute,
    softer,
    louder,
    method,
    save,
    film,
    help,
    settings,
    full_screen,
    menu,
    quit,
    count
};
inline constexpr std::size_t action_count = static_cast<std::size_t>(KeyAction::count);

// Keys are called as SDL calls them: "A", "Space", "Left", "F1", ",", "Keypad +".
struct ActionRow {
    KeyAction action;
    char const* name;               // in the file of preferences
    Text text;                      // what the player reads
    std::vector<std::string> keys;  // that it comes with
};
// In the order of the enumeration.
std::vector<ActionRow> const& actions();
inline ActionRow const& row_of(KeyAction action) { return actions()[static_cast<std::size_t>(action)]; }

// Keys that are chosen otherwise, by the action's name.
using ChosenKeys = std::map<std::string, std::vector<std::string>>;

// A key stands for at most one action.
struct Bindings {
    std::array<std::vector<std::string>, action_count> keys;
    std::vector<std::string> const& of(KeyAction action) const { return keys[static_cast<std::size_t>(action)]; }
    bool operator==(Bindings const&) const = default;
};
Bindings usual_bindings();
std::optional<KeyAction> action_of(Bindings const& bindings, std::string const& key);

// What holds where these are chosen. `canonical` gives a key the name by which it is known, or an empty one where there
// is no such key. A key that was chosen for one action is taken from another that came with it. Each fault is a line.
struct Bound {
    Bindings bindings;
    std::vector<std::string> faults;
};
Bound bindings_of(ChosenKeys const& chosen, std::function<std::string(std::string const&)> const& canonical);

// The action has this key alone. Who had it before is `other`, and gets the action's first key if it has none left.
struct Rebound {
    Bindings bindings;
    std::optional<KeyAction> other;
};
Rebound rebound(Bindings bindings, KeyAction action, std::string const& key);

// Those that are not as they came, beside what is said of actions that are not known here.
ChosenKeys chosen_keys(Bindings const& bindings, ChosenKeys const& before);

}  // namespace game
