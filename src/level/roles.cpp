#include "level/roles.h"

#include <algorithm>
#include <array>

#include "level/css.h"
#include "level/numbers.h"

namespace level {

namespace {

constexpr std::array<Role, 4> every_role = {Role::terrain, Role::ball, Role::banana, Role::goal};

bool is_one_letter_away(std::string_view word, std::string_view name) {
    if (word.size() > name.size()) return is_one_letter_away(name, word);
    if (name.size() - word.size() > 1) return false;
    std::size_t const first = std::mismatch(word.begin(), word.end(), name.begin()).first - word.begin();
    if (word.size() < name.size()) return word.substr(first) == name.substr(first + 1);
    if (first == word.size()) return false;
    if (word.substr(first + 1) == name.substr(first + 1)) return true;
    return first + 1 < word.size() && word[first] == name[first + 1] && word[first + 1] == name[first] &&
           word.substr(first + 2) == name.substr(first + 2);
}

}  // namespace

char const* name_of(Role role) {
    switch (role) {
        case Role::terrain:
            return "terrain";
        case Role::ball:
            return "ball";
        case Role::banana:
            return "banana";
        case Role::goal:
            break;
    }
    return "goal";
}

std::vector<Role> roles_in(std::string_view class_words) {
    std::vector<Role> roles;
    for (std::string_view const word : words_of(class_words))
        for (Role const role : every_role)
            if (word == name_of(role) && std::find(roles.begin(), roles.end(), role) == roles.end())
                roles.push_back(role);
    return roles;
}

bool asks_for_grass(std::string_view class_words) {
    for (std::string_view const word : words_of(class_words))
        if (word == "grass") return true;
    return false;
}

std::optional<Role> near_miss(std::string_view word) {
    for (Role const role : every_role)
        if (word == name_of(role)) return std::nullopt;
    for (Role const role : every_role)
        if (is_one_letter_away(word, name_of(role)) || same_word(word, name_of(role))) return role;
    return std::nullopt;
}

std::optional<Role> role_meant_by(std::string_view name) {
    std::string_view const word = name.substr(0, name.find_last_not_of(" \t\r\n-_.#0123456789") + 1);
    for (Role const role : every_role)
        if (same_word(trimmed(word), name_of(role))) return role;
    return same_word(word, "player") ? std::optional(Role::ball) : std::nullopt;
}

}  // namespace level
