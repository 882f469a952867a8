// Dice: draws that mean the same on every machine. Splitmix64 (Steele, Lea and Flood, 2014) and nothing of libm's.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "geometry/elementary.h"
#include "geometry/vector.h"

namespace hunt {

using geometry::Vec2;

class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }  // in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    int whole(int low, int high) {  // both included
        return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double share) { return unit() < share; }
    double sign() { return chance(0.5) ? 1 : -1; }
    double pick(std::initializer_list<double> values) {
        return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
    }
    // Every factor of two between low and high is as likely.
    double scaled(double low, double high) {
        return low * geometry::exponential(unit() * geometry::logarithm(high / low));
    }
    Vec2 direction() {
        auto const [sine, cosine] = geometry::sine_cosine(between(0, 2 * geometry::pi));
        return {cosine, sine};
    }

private:
    std::uint64_t state_;
};

}  // namespace hunt
