#include "hunt/otherwise.h"

#include <cmath>
#include <utility>

#include "hunt/ground.h"

namespace hunt {

namespace {

Stroke back(Line const& s) { return Line{s.to, s.from}; }
Stroke back(Bow const& s) { return Bow{s.to, s.from, s.radius, s.large, !s.left}; }
Stroke back(Cubic const& s) { return Cubic{s.to, s.second, s.first, s.from}; }
Stroke back(Quadratic const& s) { return Quadratic{s.to, s.handle, s.from}; }
Stroke back(Disc const& s) { return s; }

std::pair<Stroke, Stroke> halves(Line const& line, double share) {
    Vec2 const middle = line.from + share * (line.to - line.from);
    return {Line{line.from, middle}, Line{middle, line.to}};
}

std::pair<Stroke, Stroke> halves(Bow const& bow, double share) {
    Limb const limb = limb_of(bow);
    auto const [sine, cosine] = geometry::sine_cosine(limb.start + share * limb.sweep);
    Vec2 const middle = limb.centre + limb.radius * Vec2(cosine, sine);
    double const sweep = std::abs(limb.sweep);
    return {Bow{bow.from, middle, limb.radius, share * sweep > geometry::pi, bow.left},
            Bow{middle, bow.to, limb.radius, (1 - share) * sweep > geometry::pi, bow.left}};
}

std::vector<Stroke> flattened(std::pair<Stroke, Stroke> const& pair) { return {pair.first, pair.second}; }

}  // namespace

Stroke backwards(Stroke const& stroke) {
    return std::visit([](auto const& shape) { return back(shape); }, stroke);
}

std::vector<Stroke> split(Dice& dice, Stroke const& stroke) {
    double const share = dice.between(0.3, 0.7);
    auto const leads_somewhere = [](auto const& shape) { return shape.from != shape.to; };
    if (auto const* line = std::get_if<Line>(&stroke); line && leads_somewhere(*line))
        return flattened(halves(*line, share));
    if (auto const* bow = std::get_if<Bow>(&stroke); bow && leads_somewhere(*bow))
        return flattened(halves(*bow, share));
    return {stroke};
}

}  // namespace hunt
