#include "screen/swollen.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace screen {
namespace {

constexpr double far_away = 1e12;  // pixels squared, from a pixel that nothing is known of

// Room for one line of the transform.
struct Parabolas {
    explicit Parabolas(std::size_t longest) : values(longest), foot(longest), from(longest + 1) {}
    std::vector<double> values;
    std::vector<std::size_t> foot;  // of the parabolas of the lower envelope, from left to right
    std::vector<double> from;       // where each of them begins to be the lowest
};

// In place of f(i): the least of f(j) + (i - j)^2 over j, for `count` numbers that are `stride` apart.
void spread(double* f, std::size_t count, std::size_t stride, Parabolas& room) {
    for (std::size_t i = 0; i < count; ++i) room.values[i] = f[i * stride];
    auto const raised = [&](std::size_t j) {
        double const x = static_cast<double>(j);
        return room.values[j] + x * x;
    };
    std::size_t last = 0;
    room.foot[0] = 0;
    room.from[0] = -far_away;
    for (std::size_t i = 1; i < count; ++i) {
        auto const meeting = [&] {
            std::size_t const foot = room.foot[last];
            return (raised(i) - raised(foot)) / (2 * static_cast<double>(i - foot));
        };
        double at = meeting();
        while (last > 0 && at <= room.from[last]) {
            --last;
            at = meeting();
        }
        ++last;
        room.foot[last] = i;
        room.from[last] = at;
    }
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double const x = static_cast<double>(i);
        while (lowest < last && room.from[lowest + 1] < x) ++lowest;
        double const way = x - static_cast<double>(room.foot[lowest]);
        f[i * stride] = room.values[room.foot[lowest]] + way * way;
    }
}

// Of the edge from the middle of a pixel that is covered in part.
double distance_of(std::uint8_t share) { return std::max(0.0, 0.5 - share / 255.0); }

}  // namespace

int swell_margin(double swell) { return static_cast<int>(std::ceil(swell)) + 1; }

Bitmap swollen(Bitmap const& letter, double swell) {
    auto const width = static_cast<std::size_t>(letter.width), height = static_cast<std::size_t>(letter.height);
    std::vector<double> squares(width * height);  // of distances, pixels
    for (std::size_t i = 0; i < squares.size(); ++i) {
        double const distance = distance_of(letter.shares[i]);
        squares[i] = letter.shares[i] == 0 ? far_away : distance * distance;
    }
    Parabolas room(std::max(width, height));
    for (std::size_t x = 0; x < width; ++x) spread(squares.data() + x, height, width, room);
    for (std::size_t y = 0; y < height; ++y) spread(squares.data() + y * width, width, 1, room);
    Bitmap thick = letter;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        double const share = std::clamp(swell + 0.5 - std::sqrt(squares[i]), 0.0, 1.0);
        thick.shares[i] = std::max(letter.shares[i], static_cast<std::uint8_t>(std::lround(255 * share)));
    }
    return thick;
}

}  // namespace screen
