// The pages of settings and of help, as rows: what holds now, in the player's language.
#pragma once

#include <string>
#include <vector>

#include "game/actions.h"
#include "game/preferences.h"
#include "view/hud.h"
#include "view/menu.h"

namespace view {

enum class Setting { keys, volume, sound, turning, reduced_motion, high_contrast, language, back };
// In the order of the rows.
inline constexpr Setting settings_rows[] = {
    Setting::keys,           Setting::volume,        Setting::sound,    Setting::turning,
    Setting::reduced_motion, Setting::high_contrast, Setting::language, Setting::back};

Menu settings_menu(game::Preferences const& preferences);

// The actions in the order of their table, then a row that gives back all keys, and one that leads back. `waiting` is
// the action whose new key is waited for.
Menu keys_menu(game::Bindings const& bindings, std::optional<game::KeyAction> waiting, game::Language language);
inline constexpr std::size_t keys_reset_row = game::action_count, keys_back_row = game::action_count + 1,
                             keys_row_count = game::action_count + 2;

// A key as the player reads it: "Space", "←", "Num +".
std::string key_text(std::string const& key, game::Language language);
// All that an action has, without those that read the same.
std::vector<std::string> key_texts(game::Bindings const& bindings, game::KeyAction action, game::Language language);
// The first that an action has.
std::string first_key_text(game::Bindings const& bindings, game::KeyAction action, game::Language language);

// What the pointer, the keys that hold now and a gamepad do.
std::vector<KeyHelp> key_help(game::Bindings const& bindings, game::Language language);

}  // namespace view
