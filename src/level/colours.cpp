#include "level/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "level/faults.h"
#include "level/lengths.h"
#include "level/numbers.h"

namespace level {

namespace {

constexpr std::string_view hexadecimal = "0123456789abcdef";

struct Named {
    std::string_view name;
    unsigned value = 0;  // rrggbb
};

// CSS Color Module Level 3, section 4.3, in the order of the alphabet.
// clang-format off
constexpr Named named_colours[] = {
    {"aliceblue", 0xf0f8ff}, {"antiquewhite", 0xfaebd7}, {"aqua", 0x00ffff}, {"aquamarine", 0x7fffd4},
    {"azure", 0xf0ffff}, {"beige", 0xf5f5dc}, {"bisque", 0xffe4c4}, {"black", 0x000000}, {"blanchedalmond", 0xffebcd},
    {"blue", 0x0000ff}, {"blueviolet", 0x8a2be2}, {"brown", 0xa52a2a}, {"burlywood", 0xdeb887}, {"cadetblue", 0x5f9ea0},
    {"chartreuse", 0x7fff00}, {"chocolate", 0xd2691e}, {"coral", 0xff7f50}, {"cornflowerblue", 0x6495ed},
    {"cornsilk", 0xfff8dc}, {"crimson", 0xdc143c}, {"cyan", 0x00ffff}, {"darkblue", 0x00008b}, {"darkcyan", 0x008b8b},
    {"darkgoldenrod", 0xb8860b}, {"darkgray", 0xa9a9a9}, {"darkgreen", 0x006400}, {"darkgrey", 0xa9a9a9},
    {"darkkhaki", 0xbdb76b}, {"darkmagenta", 0x8b008b}, {"darkolivegreen", 0x556b2f}, {"darkorange", 0xff8c00},
    {"darkorchid", 0x9932cc}, {"darkred", 0x8b0000}, {"darksalmon", 0xe9967a}, {"darkseagreen", 0x8fbc8f},
    {"darkslateblue", 0x483d8b}, {"darkslategray", 0x2f4f4f}, {"darkslategrey", 0x2f4f4f}, {"darkturquoise", 0x00ced1},
    {"darkviolet", 0x9400d3}, {"deeppink", 0xff1493}, {"deepskyblue", 0x00bfff}, {"dimgray", 0x696969},
    {"dimgrey", 0x696969}, {"dodgerblue", 0x1e90ff}, {"firebrick", 0xb22222}, {"floralwhite", 0xfffaf0},
    {"forestgreen", 0x228b22}, {"fuchsia", 0xff00ff}, {"gainsboro", 0xdcdcdc}, {"ghostwhite", 0xf8f8ff},
    {"gold", 0xffd700}, {"goldenrod", 0xdaa520}, {"gray", 0x808080}, {"green", 0x008000}, {"greenyellow", 0xadff2f},
    {"grey", 0x808080}, {"honeydew", 0xf0fff0}, {"hotpink", 0xff69b4}, {"indianred", 0xcd5c5c}, {"indigo", 0x4b0082},
    {"ivory", 0xfffff0}, {"khaki", 0xf0e68c}, {"lavender", 0xe6e6fa}, {"lavenderblush", 0xfff0f5},
    {"lawngreen", 0x7cfc00}, {"lemonchiffon", 0xfffacd}, {"lightblue", 0xadd8e6}, {"lightcoral", 0xf08080},
    {"lightcyan", 0xe0ffff}, {"lightgoldenrodyellow", 0xfafad2}, {"lightgray", 0xd3d3d3}, {"lightgreen", 0x90ee90},
    {"lightgrey", 0xd3d3d3}, {"lightpink", 0xffb6c1}, {"lightsalmon", 0xffa07a}, {"lightseagreen", 0x20b2aa},
    {"lightskyblue", 0x87cefa}, {"lightslategray", 0x778899}, {"lightslategrey", 0x778899},
    {"lightsteelblue", 0xb0c4de}, {"lightyellow", 0xffffe0}, {"lime", 0x00ff00}, {"limegreen", 0x32cd32},
    {"linen", 0xfaf0e6}, {"magenta", 0xff00ff}, {"maroon", 0x800000}, {"mediumaquamarine", 0x66cdaa},
    {"mediumblue", 0x0000cd}, {"mediumorchid", 0xba55d3}, {"mediumpurple", 0x9370db}, {"mediumseagreen", 0x3cb371},
    {"mediumslateblue", 0x7b68ee}, {"mediumspringgreen", 0x00fa9a}, {"mediumturquoise", 0x48d1cc},
    {"mediumvioletred", 0xc71585}, {"midnightblue", 0x191970}, {"mintcream", 0xf5fffa}, {"mistyrose", 0xffe4e1},
    {"moccasin", 0xffe4b5}, {"navajowhite", 0xffdead}, {"navy", 0x000080}, {"oldlace", 0xfdf5e6}, {"olive", 0x808000},
    {"olivedrab", 0x6b8e23}, {"orange", 0xffa500}, {"orangered", 0xff4500}, {"orchid", 0xda70d6},
    {"palegoldenrod", 0xeee8aa}, {"palegreen", 0x98fb98}, {"paleturquoise", 0xafeeee}, {"palevioletred", 0xdb7093},
    {"papayawhip", 0xffefd5}, {"peachpuff", 0xffdab9}, {"peru", 0xcd853f}, {"pink", 0xffc0cb}, {"plum", 0xdda0dd},
    {"powderblue", 0xb0e0e6}, {"purple", 0x800080}, {"red", 0xff0000}, {"rosybrown", 0xbc8f8f}, {"royalblue", 0x4169e1},
    {"saddlebrown", 0x8b4513}, {"salmon", 0xfa8072}, {"sandybrown", 0xf4a460}, {"seagreen", 0x2e8b57},
    {"seashell", 0xfff5ee}, {"sienna", 0xa0522d}, {"silver", 0xc0c0c0}, {"skyblue", 0x87ceeb}, {"slateblue", 0x6a5acd},
    {"slategray", 0x708090}, {"slategrey", 0x708090}, {"snow", 0xfffafa}, {"springgreen", 0x00ff7f},
    {"steelblue", 0x4682b4}, {"tan", 0xd2b48c}, {"teal", 0x008080}, {"thistle", 0xd8bfd8}, {"tomato", 0xff6347},
    {"turquoise", 0x40e0d0}, {"violet", 0xee82ee}, {"wheat", 0xf5deb3}, {"white", 0xffffff}, {"whitesmoke", 0xf5f5f5},
    {"yellow", 0xffff00}, {"yellowgreen", 0x9acd32}};
// clang-format on

Colour of_number(unsigned value) {
    return {(value >> 16 & 255) / 255.0, (value >> 8 & 255) / 255.0, (value & 255) / 255.0, 1};
}

// #rgb, #rgba, #rrggbb, #rrggbbaa
std::optional<Colour> of_digits(std::string_view digits) {
    std::size_t const count = digits.size();
    bool const is_one = count == 3 || count == 4 || count == 6 || count == 8;
    if (!is_one || digits.find_first_not_of(hexadecimal) != std::string_view::npos) return std::nullopt;
    std::size_t const each = count < 6 ? 1 : 2;
    std::array<double, 4> channels = {0, 0, 0, 1};
    for (std::size_t i = 0; i * each < count; ++i) {
        std::size_t const first = hexadecimal.find(digits[i * each]),
                          last = hexadecimal.find(digits[i * each + each - 1]);
        channels[i] = static_cast<double>(first * 16 + last) / 255;
    }
    return Colour{channels[0], channels[1], channels[2], channels[3]};
}

// A number, or a share of `whole` in per cent, at the cursor; divided by `whole`.
double share_at(Cursor& cursor, double whole) {
    double const number = cursor.number();
    bool const per_cent = cursor.peek() == '%';
    if (per_cent) cursor.next();
    return std::clamp(number / (per_cent ? 100 : whole), 0.0, 1.0);
}

// CSS Color Module Level 4, section 7.1.
double channel_of_hsl(double which, double hue, double saturation, double lightness) {
    double const k = std::fmod(which + hue / 30, 12);
    double const amplitude = saturation * std::min(lightness, 1 - lightness);
    return lightness - amplitude * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
}

Colour of_hsl(Cursor& cursor) {
    double const degrees = std::fmod(angle_at(cursor), 360), hue = degrees < 0 ? degrees + 360 : degrees;
    cursor.skip_separator();
    double const saturation = share_at(cursor, 100);
    cursor.skip_separator();
    double const lightness = share_at(cursor, 100);
    auto const channel = [&](double which) { return channel_of_hsl(which, hue, saturation, lightness); };
    return {channel(0), channel(8), channel(4), 1};
}

Colour of_rgb(Cursor& cursor) {
    double const red = share_at(cursor, 255);
    cursor.skip_separator();
    double const green = share_at(cursor, 255);
    cursor.skip_separator();
    return {red, green, share_at(cursor, 255), 1};
}

// The arguments of rgb, rgba, hsl and hsla, between commas or spaces; the opacity after a comma or a slash. Throws
// Broken.
Colour of_function(std::string_view name, std::string_view arguments) {
    Cursor cursor(trimmed(arguments));
    Colour colour = name.substr(0, 3) == "hsl" ? of_hsl(cursor) : of_rgb(cursor);
    cursor.skip_spaces();
    if (cursor.peek() == ',' || cursor.peek() == '/') {
        cursor.next();
        cursor.skip_spaces();
        colour.opacity = share_at(cursor, 1);
    }
    cursor.skip_spaces();
    if (!cursor.at_end()) throw Broken("a colour was expected");
    return colour;
}

std::optional<Colour> plain_colour(std::string_view text) {
    if (!text.empty() && text[0] == '#') return of_digits(text.substr(1));
    std::size_t const open = text.find('(');
    if (open != std::string_view::npos) {
        std::string_view const name = text.substr(0, open);
        bool const known = name == "rgb" || name == "rgba" || name == "hsl" || name == "hsla";
        if (!known || text.back() != ')') return std::nullopt;
        try {
            return of_function(name, text.substr(open + 1, text.size() - open - 2));
        } catch (Broken const&) {
            return std::nullopt;
        }
    }
    if (text == "currentcolor") return of_number(0);
    auto const* const found =
        std::lower_bound(std::begin(named_colours), std::end(named_colours), text,
                         [](Named const& named, std::string_view name) { return named.name < name; });
    if (found == std::end(named_colours) || found->name != text) return std::nullopt;
    return of_number(found->value);
}

}  // namespace

std::string hexadecimal_of(Colour const& colour) {
    std::string text = "#";
    for (double const channel : {colour.red, colour.green, colour.blue}) {
        auto const byte = static_cast<std::size_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
        text += {hexadecimal[byte / 16], hexadecimal[byte % 16]};
    }
    return text;
}

std::optional<Colour> colour_in(std::string_view text) {
    std::string lower(trimmed(text));
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
    if (lower == "none" || lower == "transparent") return std::nullopt;
    auto const colour = plain_colour(lower);
    if (!colour) throw Unsupported("the paint " + quoted(text));
    return colour;
}

}  // namespace level
