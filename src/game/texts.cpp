#include "game/texts.h"

#include <array>
#include <cstdlib>

#include "game/texts_by_language.h"

namespace game {

namespace {

using Words = std::array<char const*, text_count>;

Words words_in(Language language) {
    Words words{};
    for (TextEntry const& entry : english_texts()) words[static_cast<std::size_t>(entry.text)] = entry.words;
    for (TextEntry const& entry : texts_in(language)) words[static_cast<std::size_t>(entry.text)] = entry.words;
    return words;
}

char const* raw_words(Text text, Language language) {
    static Words const english = words_in(Language::english), german = words_in(Language::german);
    char const* const found = (language == Language::german ? german : english)[static_cast<std::size_t>(text)];
    return found ? found : "";
}

}  // namespace

std::span<TextEntry const> texts_in(Language language) {
    return language == Language::german ? german_texts() : english_texts();
}

std::string words(Text text, Language language, std::initializer_list<std::string> values) {
    std::string result;
    // What is put in is not looked through for places again.
    for (char const* at = raw_words(text, language); *at != 0; ++at) {
        bool const is_place = at[0] == '{' && at[1] >= '1' && at[1] <= '9' && at[2] == '}';
        std::size_t const number = is_place ? static_cast<std::size_t>(at[1] - '1') : 0;
        if (is_place && number < values.size()) {
            result += values.begin()[number];
            at += 2;
        } else {
            result += *at;
        }
    }
    return result;
}

Language language_of_locale(std::string const& locale) {
    std::string const name = locale.substr(0, locale.find_first_of("_.@"));
    return name == "de" ? Language::german : Language::english;
}

Language language_of_system() {
    for (char const* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (char const* const locale = std::getenv(name); locale && locale[0] != 0) return language_of_locale(locale);
    return Language::english;
}

}  // namespace game
