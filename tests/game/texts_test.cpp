#include "game/texts.h"

#include <cstdlib>
#include <set>

#include <doctest/doctest.h>

using game::Language;
using game::Text;

TEST_CASE("every text has words in every language, and the same places for values") {
    for (Language const language : {Language::english, Language::german}) {
        std::set<Text> told;
        for (game::TextEntry const& entry : game::texts_in(language)) {
            INFO(entry.words);
            CHECK(told.insert(entry.text).second);
            std::string const english = game::words(entry.text, Language::english), here = entry.words;
            CHECK(!here.empty());
            for (char const* place : {"{1}", "{2}", "{3}", "{4}"})
                CHECK((english.find(place) == std::string::npos) == (here.find(place) == std::string::npos));
        }
        CHECK(told.size() == game::text_count);
    }
}

TEST_CASE("values come to their places, and are not looked through themselves") {
    CHECK(game::words(Text::either, Language::english, {"{2}", "b"}) == "{2} or b");
    CHECK(game::words(Text::either, Language::german, {"a", "b"}) == "a oder b");
    CHECK(game::words(Text::best, Language::english) == "Best: {1} s");
    CHECK(game::words(Text::badge_filming, Language::english, {"50"}) == "filming 50 %");
}

TEST_CASE("the system's language is what the first of three variables says that is set") {
    CHECK(game::language_of_locale("de_DE.UTF-8") == Language::german);
    CHECK(game::language_of_locale("de") == Language::german);
    CHECK(game::language_of_locale("de@euro") == Language::german);
    for (char const* locale : {"C", "", "en_GB.UTF-8", "dev", "POSIX"})
        CHECK(game::language_of_locale(locale) == Language::english);

    char const* const names[] = {"LC_ALL", "LC_MESSAGES", "LANG"};
    std::string before[3];
    bool was_set[3];
    for (int i = 0; i < 3; ++i) {
        char const* const value = std::getenv(names[i]);
        was_set[i] = value != nullptr;
        before[i] = value ? value : "";
        unsetenv(names[i]);
    }
    CHECK(game::language_of_system() == Language::english);
    setenv("LANG", "de_AT.UTF-8", 1);
    CHECK(game::language_of_system() == Language::german);
    setenv("LC_MESSAGES", "en_US.UTF-8", 1);
    CHECK(game::language_of_system() == Language::english);
    setenv("LC_ALL", "de_DE", 1);
    CHECK(game::language_of_system() == Language::german);
    setenv("LC_ALL", "C", 1);
    CHECK(game::language_of_system() == Language::english);
    setenv("LC_ALL", "", 1);
    setenv("LC_MESSAGES", "", 1);
    CHECK(game::language_of_system() == Language::german);
    for (int i = 0; i < 3; ++i)
        if (was_set[i])
            setenv(names[i], before[i].c_str(), 1);
        else
            unsetenv(names[i]);
}
