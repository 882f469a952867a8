// FNV-1a, the 64-bit hash by which runs name level files and states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace level {

inline constexpr std::uint64_t fnv1a_offset = 0xcbf29ce484222325ULL;

// Continues from `hash`, so that bytes may come in parts.
std::uint64_t fnv1a(std::span<std::byte const> bytes, std::uint64_t hash = fnv1a_offset);

// 16 lower-case digits.
std::string hex_of(std::uint64_t hash);

std::string fnv1a_hex(std::span<std::byte const> bytes);

}  // namespace level
