#include "screen/video.h"

namespace screen {
namespace {

// BT.709, limited range (ITU-R BT.709-6, 3.2 to 3.5): luma 16 to 235, chroma 16 to 240, in 1/65536.
constexpr double red_share = 0.2126, green_share = 0.7152, blue_share = 0.0722;
constexpr int one = 65536, half = one / 2;

constexpr int fixed(double value) { return static_cast<int>(value * one + (value < 0 ? -0.5 : 0.5)); }

constexpr double luma_range = 219.0 / 255, chroma_range = 224.0 / 255;
constexpr double blue_scale = chroma_range / (2 * (1 - blue_share)), red_scale = chroma_range / (2 * (1 - red_share));

constexpr int y_red = fixed(luma_range * red_share), y_green = fixed(luma_range * green_share),
              y_blue = fixed(luma_range * blue_share);
// Each row of factors adds up to 0, so that grey has no chroma at all.
constexpr int u_red = fixed(-blue_scale * red_share), u_blue = fixed(blue_scale * (1 - blue_share)),
              u_green = -u_red - u_blue;
constexpr int v_blue = fixed(-red_scale * blue_share), v_red = fixed(red_scale * (1 - red_share)),
              v_green = -v_red - v_blue;

void luma_row(std::uint8_t const* rgba, std::uint8_t* luma, std::size_t width) {
    for (std::size_t x = 0; x < width; ++x, rgba += 4)
        luma[x] =
            static_cast<std::uint8_t>((y_red * rgba[0] + y_green * rgba[1] + y_blue * rgba[2] + 16 * one + half) / one);
}

// Of two rows of pixels: the mean of each square of four.
void chroma_row(std::uint8_t const* upper, std::uint8_t const* lower, std::uint8_t* u, std::uint8_t* v,
                std::size_t width) {
    for (std::size_t x = 0; x < width; ++x, upper += 8, lower += 8) {
        int const red = upper[0] + upper[4] + lower[0] + lower[4];
        int const green = upper[1] + upper[5] + lower[1] + lower[5];
        int const blue = upper[2] + upper[6] + lower[2] + lower[6];
        constexpr int middle = 4 * (128 * one + half);
        u[x] = static_cast<std::uint8_t>((u_red * red + u_green * green + u_blue * blue + middle) / (4 * one));
        v[x] = static_cast<std::uint8_t>((v_red * red + v_green * green + v_blue * blue + middle) / (4 * one));
    }
}

}  // namespace

Yuv420 yuv420_of(Pixels const& pixels) {
    auto const width = static_cast<std::size_t>(pixels.width & ~1),
               height = static_cast<std::size_t>(pixels.height & ~1);
    std::size_t const stride = 4 * static_cast<std::size_t>(pixels.width), chroma_size = width / 2 * (height / 2);
    Yuv420 yuv{static_cast<int>(width), static_cast<int>(height), {}};
    yuv.bytes.resize(width * height + 2 * chroma_size);
    std::uint8_t* const u = yuv.bytes.data() + width * height;
    std::uint8_t* const v = u + chroma_size;
    for (std::size_t y = 0; y < height; y += 2) {
        std::uint8_t const* const upper = pixels.rgba.data() + y * stride;
        luma_row(upper, yuv.bytes.data() + y * width, width);
        luma_row(upper + stride, yuv.bytes.data() + (y + 1) * width, width);
        chroma_row(upper, upper + stride, u + y / 2 * (width / 2), v + y / 2 * (width / 2), width / 2);
    }
    return yuv;
}

}  // namespace screen
