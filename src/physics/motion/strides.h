// Strides: how far a power series in time may be followed.
#pragma once

#include <array>

namespace physics {

// Strides are of a fixed set of lengths, each with its power for the term before the last.
struct Stride {
    double length = 0;  // s
    double power = 0;
};

template <int order>
inline constexpr std::array<Stride, 200> strides = [] {
    std::array<Stride, 200> all;
    double length = 2;  // s, the longest
    for (Stride& stride : all) {
        double power = 1, base = length;
        for (int exponent = order - 1; exponent > 0; exponent >>= 1, base *= base)
            if (exponent & 1) power *= base;
        stride = {length, power};
        length *= 0.84;
    }
    return all;
}();

// The longest stride after which the last term of a series of that order, and the one before it, are at most `size`.
template <int order>
double longest_stride(double last, double before, double size) {
    for (Stride const& stride : strides<order>)
        if (last * stride.power * stride.length <= size && before * stride.power <= size) return stride.length;
    return strides<order>.back().length;
}

}  // namespace physics
