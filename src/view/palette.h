// The colours of the game, and how colours are mixed.
#pragma once

#include <cstdint>

#include "view/picture.h"

namespace view {

constexpr Colour colour(std::uint32_t rgb, float alpha = 1) {
    return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
            static_cast<float>(rgb & 255) / 255, alpha};
}

constexpr Colour faded(Colour c, float share) { return {c.red, c.green, c.blue, c.alpha * share}; }

constexpr Colour mixed(Colour const& a, Colour const& b, float share) {
    return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share, a.blue + (b.blue - a.blue) * share,
            a.alpha + (b.alpha - a.alpha) * share};
}

namespace palette {

inline constexpr Colour sky_top = colour(0x3f9be8), sky_bottom = colour(0xdff4f2);
inline constexpr Colour sun = colour(0xfff6c8, 0.95f), sun_glow = colour(0xffffff, 0.3f);
inline constexpr Colour cloud = colour(0xffffff, 0.92f), cloud_shade = colour(0xcfe5f3, 0.9f);
inline constexpr Colour far_hill = colour(0xa9d4e3), far_foot = colour(0xd3ecea);
inline constexpr Colour middle_hill = colour(0x83c3b4), middle_foot = colour(0xbfe3cc);
inline constexpr Colour near_hill = colour(0x6cb583), near_foot = colour(0xa9d9a4);
inline constexpr Colour earth_top = colour(0xa8703f), earth_bottom = colour(0x5d3a2a);
inline constexpr Colour earth_shade = colour(0x3a1f14, 0.16f), earth_rim = colour(0x6b4127);
inline constexpr Colour turf = colour(0x58b536), turf_low = colour(0x3b8f2c), turf_lit = colour(0xb4ec5d);
inline constexpr Colour blade = colour(0x4aa532), blade_lit = colour(0x8edb4a);
inline constexpr Colour ice = colour(0xe2f6ff), ice_low = colour(0x8fcbe8), mud = colour(0x5b3d22),
                        mud_low = colour(0x3d2816);
inline constexpr Colour tread = colour(0x3b3f46), stud = colour(0xc9a24a), rubber = colour(0xc2382d),
                        coil = colour(0xffe1cf);
inline constexpr Colour ink = colour(0x22303c), paper = colour(0xffffff, 0.86f), night = colour(0x14202c, 0.72f);
inline constexpr Colour bright = colour(0xffffff), dim = colour(0xc9d6df);
inline constexpr Colour gold = colour(0xffc928), gold_deep = colour(0xd98a12), banana = colour(0xffdf3d);
inline constexpr Colour banana_shade = colour(0xeab11f), banana_tip = colour(0x6b4a1c);
inline constexpr Colour dust = colour(0xf3e6cf), spark = colour(0xfff3b0);
inline constexpr Colour shadow = colour(0x1a120c, 0.5f);
inline constexpr Colour steel = colour(0xf3f6f8), steel_back = colour(0x7b8b98), strain = colour(0xff7a3c);
inline constexpr Colour red = colour(0xe8452f), blue = colour(0x2f7de1), green = colour(0x2fae5a),
                        violet = colour(0x9b4fd8), orange = colour(0xf39a1e);

}  // namespace palette

}  // namespace view
