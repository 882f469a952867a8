// What the player reads in the window and on pictures, by language: a translation is one file, texts_LANGUAGE.cpp.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>

namespace game {

enum class Language { english, german };

enum class Text {
    // What keys do.
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
    // Keys by name.
    key_space,
    key_enter,
    key_comma,
    key_period,
    key_minus,
    key_plus,
    key_page_up,
    key_page_down,
    key_backspace,
    key_delete,
    key_none,
    // The page of help.
    help_title,
    help_button,
    help_drag,
    help_wheel,
    help_zoom,
    help_past,
    help_take,
    help_shift,
    help_faster,
    help_pad,
    help_stick,
    // The menu of a pause.
    menu_title,
    menu_go_on,
    menu_again,
    menu_levels,
    menu_sound,
    menu_sound_off,
    menu_settings,
    menu_quit,
    // The pages of settings.
    settings_title,
    settings_keys,
    settings_volume,
    settings_sound,
    settings_turning,
    settings_reduced_motion,
    settings_high_contrast,
    settings_language,
    settings_back,
    settings_hint,
    setting_on,
    setting_off,
    language_of_system,
    keys_title,
    keys_reset,
    keys_hint,
    keys_wait,
    keys_wait_hint,
    keys_set,
    keys_swapped,
    keys_taken,
    keys_are_reset,
    // The title.
    title_start,
    title_keys,
    // The picker.
    picker_title,
    picker_hint,
    picker_broken,
    // What a level asks for, before the game.
    asked_gold,
    seconds,
    pull,
    pulls,
    banana,
    bananas,
    all_bananas,
    verb_drag,
    verb_tilt,
    // The end.
    goal,
    gold,
    silver,
    bronze,
    par,
    of_all,
    for_gold,
    for_silver,
    at_most,
    either,
    two_of,
    new_best,
    best,
    fall,
    time_over,
    goal_hint,
    fall_hint,
    film_button,
    // The overlays.
    shown_in_flight,
    shown_rolling,
    shown_sliding,
    shown_at_rest,
    shown_figures,
    shown_spin,
    shown_angle,
    shown_forces,
    shown_gravity,
    shown_normal,
    shown_friction,
    shown_drag,
    shown_energy,
    shown_motion,
    shown_rotation,
    shown_height,
    shown_spring,
    shown_total,
    // The badge.
    badge_ago,
    badge_replay,
    badge_paused,
    badge_slow,
    badge_filming,
    // Messages.
    played_on,
    time_not_kept,
    focus_lost,
    overlay_is,
    overlay_none,
    overlay_figures,
    overlay_forces,
    overlay_energy,
    overlay_all,
    picture_upright,
    picture_turns,
    picture_calm,
    saved,
    not_saved,
    run_ends,
    read_anew,
    method_is,
    let_go_first,
    in_the_past,
    at_the_present,
    was_over,
    on_from_here,
    back_in_present,
    one_film,
    nothing_played,
    film_begins,
    film_saved,
    film_failed,
    volume_is,
    muted,
    sound_on,
    pad_gone,
    count
};
inline constexpr std::size_t text_count = static_cast<std::size_t>(Text::count);

// In that language, or in English where it has none; "{1}", "{2}" are replaced by the values.
std::string words(Text text, Language language, std::initializer_list<std::string> values = {});

struct TextEntry {
    Text text;
    char const* words;  // UTF-8
};
std::span<TextEntry const> texts_in(Language language);

// Of a locale such as "de_DE.UTF-8"; English where it is none of ours.
Language language_of_locale(std::string const& locale);
// By LC_ALL, LC_MESSAGES and LANG: the first that is set and not empty.
Language language_of_system();

}  // namespace game
