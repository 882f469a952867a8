#include "screen/grain.h"

#include <algorithm>
#include <cmath>

namespace screen {
namespace {

std::uint32_t scrambled(std::uint32_t key) {
    key ^= key >> 16;
    key *= 0x7feb352dU;
    key ^= key >> 15;
    key *= 0x846ca68bU;
    return key ^ (key >> 16);
}

// 0 to 1, of a lattice point or of the n-th number of a stone.
float chance(std::uint32_t a, std::uint32_t b, std::uint32_t seed) {
    return static_cast<float>(scrambled(a + scrambled(b + scrambled(seed))) >> 8) / 16777216.0F;
}

using Tile = std::vector<float>;

float& texel(Tile& tile, int x, int y) {
    constexpr int mask = grain_side - 1;
    return tile[static_cast<std::size_t>((y & mask) * grain_side + (x & mask))];
}

// Value noise with the given number of lattice cells along a side.
void add_noise(Tile& tile, int cells, float strength) {
    int const step = grain_side / cells;
    std::vector<float> lattice(static_cast<std::size_t>((cells + 1) * (cells + 1)));
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i)
            lattice[static_cast<std::size_t>(j * (cells + 1) + i)] =
                chance(static_cast<std::uint32_t>(i % cells), static_cast<std::uint32_t>(j % cells),
                       static_cast<std::uint32_t>(cells)) -
                0.5F;
    for (int y = 0; y < grain_side; ++y)
        for (int x = 0; x < grain_side; ++x) {
            float u = static_cast<float>(x % step) / static_cast<float>(step);
            float v = static_cast<float>(y % step) / static_cast<float>(step);
            u = u * u * (3 - 2 * u);
            v = v * v * (3 - 2 * v);
            float const* corner = &lattice[static_cast<std::size_t>((y / step) * (cells + 1) + x / step)];
            float const upper = corner[0] + (corner[1] - corner[0]) * u;
            float const lower = corner[cells + 1] + (corner[cells + 2] - corner[cells + 1]) * u;
            texel(tile, x, y) += strength * (upper + (lower - upper) * v);
        }
}

void add_squares(Tile& tile, int squares, float strength) {
    int const side = grain_side / squares;
    for (int y = 0; y < grain_side; ++y)
        for (int x = 0; x < grain_side; ++x) texel(tile, x, y) += (x / side + y / side) % 2 == 0 ? strength : -strength;
}

// A pebble, lit from above on the left, with a shadow below.
void add_stone(Tile& tile, std::uint32_t number) {
    float const x = chance(number, 0, 7) * grain_side, y = chance(number, 1, 7) * grain_side;
    float const size = 2 + 7 * chance(number, 2, 7) * chance(number, 3, 7);
    float const wide = size * (1 + 0.5F * chance(number, 4, 7)), high = size * (0.6F + 0.3F * chance(number, 5, 7));
    int const reach = static_cast<int>(wide) + 4;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            float const u = static_cast<float>(i) / wide, v = static_cast<float>(j) / high;
            float const edge = (1 - std::sqrt(u * u + v * v)) * high;
            float const shadow_v = (static_cast<float>(j) - 2) / high;
            float const shadow = (1 - std::sqrt(u * u + shadow_v * shadow_v)) * high;
            float& value = texel(tile, static_cast<int>(x) + i, static_cast<int>(y) + j);
            value -= 0.18F * std::clamp(shadow, 0.0F, 1.0F);
            float const lit = 0.22F - 0.22F * v - 0.08F * u;
            value += (lit - value) * std::clamp(edge, 0.0F, 1.0F);
        }
}

}  // namespace

std::vector<std::uint8_t> grain_tile() {
    Tile tile(static_cast<std::size_t>(grain_side) * grain_side, 0.0F);
    add_noise(tile, 8, 0.30F);
    add_noise(tile, 32, 0.22F);
    add_noise(tile, 128, 0.18F);
    add_squares(tile, 8, 0.07F);
    for (std::uint32_t number = 0; number < 150; ++number) add_stone(tile, number);
    std::vector<std::uint8_t> bytes(tile.size());
    std::transform(tile.begin(), tile.end(), bytes.begin(),
                   [](float value) { return static_cast<std::uint8_t>(std::clamp(128 + 127 * value, 0.0F, 255.0F)); });
    return bytes;
}

std::vector<std::uint8_t> halved(std::vector<std::uint8_t> const& square, int side) {
    auto const stride = static_cast<std::size_t>(side), half = stride / 2;
    std::vector<std::uint8_t> smaller(half * half);
    for (std::size_t y = 0; y < half; ++y)
        for (std::size_t x = 0; x < half; ++x) {
            std::uint8_t const* const corner = &square[2 * y * stride + 2 * x];
            smaller[y * half + x] =
                static_cast<std::uint8_t>((corner[0] + corner[1] + corner[stride] + corner[stride + 1] + 2) / 4);
        }
    return smaller;
}

}  // namespace screen
