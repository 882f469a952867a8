#include "view/outline_points.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double grass_spacing = 0.12;  // m

// A chord over the length s of an arc lies s^2 / 8 r off its middle.
double longest_chord(geometry::Arc const& arc, double flatness) {
    return std::sqrt(8 * flatness * std::max(arc.radius, flatness));
}

}  // namespace

Fineness fineness_for(level::Level const& level) {
    constexpr double most_points = 200'000, most_chords = 1'000'000;
    double length = 0, chords = 0;
    for (level::Outline const& outline : level.outlines)
        for (geometry::Curve const& curve : outline.curves) {
            double const along = geometry::length_of(curve);
            length += along;
            if (auto const* arc = std::get_if<geometry::Arc>(&curve))
                chords += along / longest_chord(*arc, unseen_flatness);
        }
    double const excess = std::max(1.0, chords / most_chords);
    return {std::max(grass_spacing, length / most_points), unseen_flatness * excess * excess};
}

std::vector<Vec2> points_along(level::Outline const& outline, double spacing, double flatness) {
    auto const pieces_of = [&](geometry::Curve const& curve) {
        double chord = spacing;
        if (auto const* arc = std::get_if<geometry::Arc>(&curve))
            chord = std::min(chord, longest_chord(*arc, flatness));
        return static_cast<int>(std::clamp(std::ceil(geometry::length_of(curve) / chord), 1.0, 20000.0));
    };
    std::size_t count = outline.closed ? 0 : 1;
    for (geometry::Curve const& curve : outline.curves) count += static_cast<std::size_t>(pieces_of(curve));
    std::vector<Vec2> points;
    points.reserve(count);
    for (geometry::Curve const& curve : outline.curves) {
        auto const* arc = std::get_if<geometry::Arc>(&curve);
        int const pieces = pieces_of(curve);
        for (int i = 0; i < pieces; ++i) {
            double const share = static_cast<double>(i) / pieces;
            if (arc) {
                double const angle = arc->from + share * arc->sweep;
                points.push_back(arc->centre + arc->radius * Vec2(std::cos(angle), std::sin(angle)));
            } else {
                auto const& segment = std::get<geometry::Segment>(curve);
                points.push_back(segment.start + share * (segment.end - segment.start));
            }
        }
    }
    if (!outline.closed && !outline.curves.empty()) points.push_back(geometry::end_of(outline.curves.back()));
    return points;
}

}  // namespace view
