#include "view/surface_signs.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace view {

namespace {

// A place so far along an edge, by its length, and the frame there.
struct Station {
    Vec2 place, along, into;
};

// Calls at even spacings, half of one from either end, with the number of the station.
void each_station(Edge const& edge, double spacing, std::function<void(Station const&, int)> const& call) {
    double whole = 0;
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
        whole += geometry::length(edge.points[i + 1] - edge.points[i]);
    int const count = static_cast<int>(std::clamp(std::round(whole / spacing), 1.0, 20000.0));
    double const step = whole / count;
    double passed = 0;
    int number = 0;
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
        Vec2 const way = edge.points[i + 1] - edge.points[i];
        double const length = geometry::length(way);
        for (; number < count && (number + 0.5) * step <= passed + length && length > 0; ++number) {
            double const share = ((number + 0.5) * step - passed) / length;
            Vec2 const into = edge.into[i] + share * (edge.into[i + 1] - edge.into[i]);
            double const depth = geometry::length(into);
            if (depth > 0) call({edge.points[i] + share * way, way / length, into / depth}, number);
        }
        passed += length;
    }
}

// A lit line just below the edge, and slanting glints in threes as on glass.
void add_ice(std::vector<Mark>& marks, Edge const& edge) {
    double const depth = edge.depth;
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
        marks.push_back({edge.points[i] + 0.14 * depth * edge.into[i],
                         edge.points[i + 1] + 0.14 * depth * edge.into[i + 1], 0.2 * depth, Sign::sheen});
    each_station(edge, 5 * depth, [&](Station const& at, int number) {
        int const glints = number % 2 == 0 ? 3 : 2;
        for (int i = 0; i < glints; ++i) {
            Vec2 const top = at.place + 0.42 * depth * at.into + 0.45 * depth * (i - 1) * at.along;
            Vec2 const bottom = top + 0.4 * depth * at.into - 0.4 * depth * at.along;
            marks.push_back({top, bottom, (i == 1 ? 0.14 : 0.08) * depth, Sign::glint});
        }
    });
}

// Drops that hang from a thick layer, of two lengths.
void add_mud(std::vector<Mark>& marks, Edge const& edge) {
    double const depth = edge.depth;
    each_station(edge, 1.1 * depth, [&](Station const& at, int number) {
        double const length = (number % 3 == 0 ? 0.75 : number % 3 == 1 ? 0.2 : 0.45) * depth;
        Vec2 const from = at.place + 0.75 * depth * at.into;
        marks.push_back({from, from + length * at.into, 0.8 * depth, Sign::drop});
    });
}

// Studs across the edge, as a tread's.
void add_tread(std::vector<Mark>& marks, Edge const& edge) {
    double const depth = edge.depth;
    each_station(edge, 0.9 * depth, [&](Station const& at, int number) {
        double const length = number % 2 == 0 ? 0.85 : 0.5;
        Vec2 const from = at.place + 0.1 * depth * at.into;
        marks.push_back({from, from + (length - 0.1) * depth * at.into, 0.34 * depth, Sign::stud});
    });
}

// The coil of a spring within the band.
void add_coil(std::vector<Mark>& marks, Edge const& edge) {
    double const depth = edge.depth;
    Vec2 last = Vec2::Zero();
    each_station(edge, 0.75 * depth, [&](Station const& at, int number) {
        Vec2 const place = at.place + (number % 2 == 0 ? 0.2 : 0.8) * depth * at.into;
        if (number > 0) marks.push_back({last, place, 0.2 * depth, Sign::coil});
        last = place;
    });
}

}  // namespace

void add_signs(std::vector<Mark>& marks, Edge const& edge, SurfaceLook const& look) {
    if (edge.points.size() < 2 || !(edge.depth > 0)) return;
    if (look.base == Base::ice) add_ice(marks, edge);
    if (look.base == Base::mud) add_mud(marks, edge);
    if (look.base == Base::tread) add_tread(marks, edge);
    if (look.bouncy) add_coil(marks, edge);
}

}  // namespace view
