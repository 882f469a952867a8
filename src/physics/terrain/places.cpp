#include "physics/terrain/places.h"

#include <algorithm>
#include <numeric>

#include "physics/terrain/cell_lists.h"

namespace physics {

namespace {

bool comes_before(Vec2 const& a, Vec2 const& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

// The chains of points, sorted, that lie within `vertex_reach` of each other: of each point the first of its chain.
class Chains {
public:
    explicit Chains(std::vector<Vec2> const& points) : points_(points), first_(points.size()), cells_(points.size()) {
        std::iota(first_.begin(), first_.end(), 0);
        for (int i = 0; i < static_cast<int>(points_.size()); ++i) join_neighbours(i);
    }

    int root(int i) {
        while (first_[i] != i) i = first_[i] = first_[first_[i]];
        return i;
    }

private:
    void join_neighbours(int i) {
        constexpr double width = cell_widths * vertex_reach, reach = cell_slack * vertex_reach;
        Vec2 const& point = points_[i];
        std::int64_t const right = cell_at(point.x() + reach, width), top = cell_at(point.y() + reach, width);
        for (std::int64_t column = cell_at(point.x() - reach, width); column <= right; ++column)
            for (std::int64_t row = cell_at(point.y() - reach, width); row <= top; ++row)
                cells_.each_in(joined_key(joined_key(0, column), row), [&](int j) {
                    if (geometry::length(points_[j] - point) > vertex_reach) return;
                    int const a = root(i), b = root(j);
                    first_[std::max(a, b)] = std::min(a, b);
                });
        cells_.add(joined_key(joined_key(0, cell_at(point.x(), width)), cell_at(point.y(), width)), i);
    }

    std::vector<Vec2> const& points_;
    std::vector<int> first_;
    CellLists cells_;
};

}  // namespace

Places places_of(std::vector<Vec2> const& ends) {
    struct End {
        Vec2 point;
        int number;
    };
    // Along a path every end is the next piece's start: it is sorted once.
    auto const repeats = [&](std::size_t i) { return i > 0 && ends[i] == ends[i - 1]; };
    std::vector<End> sorted;
    sorted.reserve(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (!repeats(i)) sorted.push_back({ends[i], static_cast<int>(i)});
    std::sort(sorted.begin(), sorted.end(), [](End const& a, End const& b) {
        return comes_before(a.point, b.point) || (a.point == b.point && a.number < b.number);
    });
    Places places;
    places.of_end.resize(ends.size());
    std::vector<Vec2> distinct;
    distinct.reserve(sorted.size());
    for (End const& end : sorted) {
        if (distinct.empty() || distinct.back() != end.point) distinct.push_back(end.point);
        places.of_end[end.number] = static_cast<int>(distinct.size()) - 1;
    }
    Chains chains(distinct);
    std::vector<int> place_of_point(distinct.size());
    for (int i = 0; i < static_cast<int>(distinct.size()); ++i) {
        int const root = chains.root(i);
        if (root == i) places.points.push_back(distinct[i]);
        place_of_point[i] = root == i ? static_cast<int>(places.points.size()) - 1 : place_of_point[root];
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
        places.of_end[i] = repeats(i) ? places.of_end[i - 1] : place_of_point[places.of_end[i]];
    return places;
}

}  // namespace physics
