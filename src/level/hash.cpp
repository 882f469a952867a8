#include "level/hash.h"

namespace level {

std::uint64_t fnv1a(std::span<std::byte const> bytes, std::uint64_t hash) {
    constexpr std::uint64_t prime = 0x100000001b3ULL;
    for (std::byte const byte : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * prime;
    return hash;
}

std::string hex_of(std::uint64_t hash) {
    std::string text(16, '0');
    for (int i = 15; i >= 0; --i, hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
    return text;
}

std::string fnv1a_hex(std::span<std::byte const> bytes) { return hex_of(fnv1a(bytes)); }

}  // namespace level
