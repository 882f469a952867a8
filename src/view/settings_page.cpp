#include "view/settings_page.h"

#include <algorithm>

namespace view {

using game::Language;
using game::Text;
using game::words;

namespace {

MenuRow switch_row(std::string text, bool on, Language language) {
    MenuRow row{std::move(text)};
    row.on = on;
    row.value = words(on ? Text::setting_on : Text::setting_off, language);
    return row;
}

std::string language_text(std::optional<Language> const& chosen, Language language) {
    if (!chosen) return words(Text::language_of_system, language);
    return *chosen == Language::german ? "Deutsch" : "English";
}

MenuRow setting_row(Setting setting, game::Preferences const& preferences, Language language) {
    switch (setting) {
        case Setting::keys:
            return {words(Text::settings_keys, language)};
        case Setting::volume:
            return {words(Text::settings_volume, language), preferences.volume};
        case Setting::sound:
            return switch_row(words(Text::settings_sound, language), !preferences.muted, language);
        case Setting::turning:
            return switch_row(words(Text::settings_turning, language),
                              preferences.turning && !preferences.reduced_motion, language);
        case Setting::reduced_motion:
            return switch_row(words(Text::settings_reduced_motion, language), preferences.reduced_motion, language);
        case Setting::high_contrast:
            return switch_row(words(Text::settings_high_contrast, language), preferences.high_contrast, language);
        case Setting::language: {
            MenuRow row{words(Text::settings_language, language)};
            row.value = language_text(preferences.language, language);
            return row;
        }
        case Setting::back:
            break;
    }
    return {words(Text::settings_back, language)};
}

struct NamedKey {
    char const* key;
    char const* sign;  // that reads the same everywhere, or none
    Text text = Text::count;
};
constexpr NamedKey named_keys[] = {{"Left", "←"},
                                   {"Right", "→"},
                                   {"Up", "↑"},
                                   {"Down", "↓"},
                                   {"Escape", "Esc"},
                                   {"Space", nullptr, Text::key_space},
                                   {"Return", nullptr, Text::key_enter},
                                   {",", nullptr, Text::key_comma},
                                   {".", nullptr, Text::key_period},
                                   {"-", nullptr, Text::key_minus},
                                   {"+", nullptr, Text::key_plus},
                                   {"PageUp", nullptr, Text::key_page_up},
                                   {"PageDown", nullptr, Text::key_page_down},
                                   {"Backspace", nullptr, Text::key_backspace},
                                   {"Delete", nullptr, Text::key_delete}};

}  // namespace

std::string key_text(std::string const& key, Language language) {
    for (NamedKey const& named : named_keys)
        if (key == named.key) return named.sign ? named.sign : words(named.text, language);
    std::string const pad = "Keypad ";
    return key.starts_with(pad) ? "Num " + key.substr(pad.size()) : key;
}

std::vector<std::string> key_texts(game::Bindings const& bindings, game::KeyAction action, Language language) {
    std::vector<std::string> texts;
    for (std::string const& key : bindings.of(action))
        if (std::string text = key_text(key, language); std::find(texts.begin(), texts.end(), text) == texts.end())
            texts.push_back(std::move(text));
    return texts;
}

std::string first_key_text(game::Bindings const& bindings, game::KeyAction action, Language language) {
    auto const& keys = bindings.of(action);
    return keys.empty() ? words(Text::key_none, language) : key_text(keys.front(), language);
}

Menu settings_menu(game::Preferences const& preferences) {
    Language const language = game::language_of(preferences);
    Menu menu{settings_form, words(Text::settings_title, language), {}, words(Text::settings_hint, language)};
    for (Setting const setting : settings_rows) menu.rows.push_back(setting_row(setting, preferences, language));
    return menu;
}

Menu keys_menu(game::Bindings const& bindings, std::optional<game::KeyAction> waiting, Language language) {
    Menu menu{keys_form, words(Text::keys_title, language), {}, words(Text::keys_hint, language)};
    for (game::ActionRow const& action : game::actions()) {
        MenuRow& row = menu.rows.emplace_back(MenuRow{words(action.text, language)});
        row.waits = waiting == action.action;
        if (row.waits)
            row.value = words(Text::keys_wait, language);
        else
            row.caps = key_texts(bindings, action.action, language);
        if (!row.waits && row.caps.empty()) row.value = words(Text::key_none, language);
        if (row.waits) menu.hint = words(Text::keys_wait_hint, language, {row.text});
    }
    menu.rows.push_back({words(Text::keys_reset, language)});
    menu.rows.push_back({words(Text::settings_back, language)});
    return menu;
}

std::vector<KeyHelp> key_help(game::Bindings const& bindings, Language language) {
    auto const fixed = [&](Text keys, Text meaning) -> KeyHelp {
        return {{words(keys, language)}, words(meaning, language)};
    };
    std::vector<KeyHelp> rows = {fixed(Text::help_button, Text::help_drag), fixed(Text::help_wheel, Text::help_zoom)};
    for (game::ActionRow const& action : game::actions()) {
        auto keys = key_texts(bindings, action.action, language);
        if (!keys.empty()) rows.push_back({std::move(keys), words(action.text, language)});
        if (action.action != game::KeyAction::look_forward) continue;
        rows.push_back(fixed(Text::help_shift, Text::help_faster));
        rows.push_back(fixed(Text::help_past, Text::help_take));
    }
    rows.push_back(fixed(Text::help_pad, Text::help_stick));
    return rows;
}

}  // namespace view
