// Noise without a memory: a hash of whole numbers, joined smoothly.
#pragma once

#include <cstdint>

namespace sound {

// In [-1, 1], evenly, by the number and the seed.
inline double hashed(std::int64_t number, std::uint64_t seed) {
    // The finaliser of splitmix64 (Steele, Lea and Flood 2014).
    std::uint64_t x = static_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15u + seed * 0xd1b54a32d192ed03u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    x ^= x >> 31;
    return static_cast<double>(x >> 11) * 0x1p-52 - 1;
}

// In [-1, 1]: `hashed` at whole numbers, in between as smooth as 6 s^5 - 15 s^4 + 10 s^3: curvature has no step.
double smooth_noise(double at, std::uint64_t seed);

}  // namespace sound
