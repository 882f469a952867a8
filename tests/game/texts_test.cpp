#include "game/texts.h"

#include <set>

#include <doctest/doctest.h>

#include "support/folder.h"

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

    support::Variable const all("LC_ALL", {}), messages("LC_MESSAGES", {}), lang("LANG", {});
    struct Case {
        support::Variable const& variable;
        char const* value;
        Language language;
    };
    CHECK(game::language_of_system() == Language::english);
    for (Case const& c : {Case{lang, "de_AT.UTF-8", Language::german}, Case{messages, "en_US.UTF-8", Language::english},
                          Case{all, "de_DE", Language::german}, Case{all, "C", Language::english}}) {
        c.variable.set(c.value);
        CHECK(game::language_of_system() == c.language);
    }
    all.set("");
    messages.set("");
    CHECK(game::language_of_system() == Language::german);
}
