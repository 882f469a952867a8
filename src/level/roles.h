// What the class attribute makes of an element, and what other words in it were perhaps meant to be.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace level {

enum class Role { terrain, ball, banana, goal };

char const* name_of(Role role);

// The roles among the words of a class attribute, each once, in their order.
std::vector<Role> roles_in(std::string_view class_words);

// Whether a class attribute has the word by which terrain is grass and soil, however it is painted.
bool asks_for_grass(std::string_view class_words);

// The role that a word misses by one letter: one too many, too few, wrong, or two neighbours exchanged; or by capitals.
std::optional<Role> near_miss(std::string_view word);

// The role that a name such as "Terrain 2" or "ball-1" seems to mean; names have no effect.
std::optional<Role> role_meant_by(std::string_view name);

}  // namespace level
