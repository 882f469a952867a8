// A first look at the text of a level, before a tree is made of it: what the XML reader would let pass or choke on.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace level {

inline constexpr int most_elements = 100'000;      // docs/levels.md
inline constexpr int most_attributes = 1'000'000;  // of all elements together, which else take ten times the file

struct Objection {
    std::ptrdiff_t offset = 0;  // in the text
    std::string what;           // "element: what"
};

// The first reason not to read on: a DOCTYPE that declares entities, too many elements or attributes, text or a second
// element outside the root, a tag without end, a NUL byte. A text without objection may still not be XML.
std::optional<Objection> objection_to(std::string_view text);

}  // namespace level
