#include "physics/terrain/doubles.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "physics/terrain/cell_lists.h"

namespace physics {

using geometry::Arc;
using geometry::Curve;
using geometry::Segment;

namespace {

Vec2 middle_of(Curve const& curve) {
    if (auto const* segment = std::get_if<Segment>(&curve)) return 0.5 * (segment->start + segment->end);
    Arc const& arc = std::get<Arc>(curve);
    return geometry::start_of(Arc{arc.centre, arc.radius, arc.from + arc.sweep / 2, arc.sweep});
}

// Pieces between the same two points lie on each other where their middles do; whole circles by centre and radius.
bool lie_on_each_other(MergedPieces const& all, int i, int j) {
    if (std::minmax(all.start[i], all.end[i]) != std::minmax(all.start[j], all.end[j])) return false;
    Curve const &a = all.pieces[i].curve, &b = all.pieces[j].curve;
    if (all.start[i] >= 0) return geometry::length(middle_of(a) - middle_of(b)) <= lies_on;
    Arc const &p = std::get<Arc>(a), &q = std::get<Arc>(b);
    return geometry::length(p.centre - q.centre) <= lies_on && std::abs(p.radius - q.radius) <= lies_on;
}

// In the order of the file; whole circles after the others, by centre.
std::vector<int> by_precedence(MergedPieces const& all) {
    std::vector<int> order(all.pieces.size());
    std::iota(order.begin(), order.end(), 0);
    auto const circles = std::stable_partition(order.begin(), order.end(), [&](int i) { return all.start[i] >= 0; });
    std::stable_sort(circles, order.end(), [&](int i, int j) {
        return std::get<Arc>(all.pieces[i].curve).centre.x() < std::get<Arc>(all.pieces[j].curve).centre.x();
    });
    return order;
}

// What is alike for pieces that lie on each other, to rounding.
struct Likeness {
    std::uint64_t ends = 0;
    double numbers[3] = {0, 0, 0};  // m
};
Likeness likeness_of(MergedPieces const& all, int i) {
    if (all.start[i] < 0) {
        Arc const& arc = std::get<Arc>(all.pieces[i].curve);
        return {0, {arc.centre.x(), arc.centre.y(), arc.radius}};
    }
    auto const [low, high] = std::minmax(all.start[i], all.end[i]);
    Vec2 const middle = middle_of(all.pieces[i].curve);
    return {joined_key(joined_key(1, low), high), {middle.x(), middle.y(), 0}};
}

template <typename Visit>
void each_cell_near(Likeness const& likeness, Visit const& visit) {
    constexpr double width = cell_widths * lies_on, reach = cell_slack * lies_on;
    auto const low = [&](int axis) { return cell_at(likeness.numbers[axis] - reach, width); };
    auto const high = [&](int axis) { return cell_at(likeness.numbers[axis] + reach, width); };
    for (std::int64_t a = low(0); a <= high(0); ++a)
        for (std::int64_t b = low(1); b <= high(1); ++b)
            for (std::int64_t c = low(2); c <= high(2); ++c)
                visit(joined_key(joined_key(joined_key(likeness.ends, a), b), c));
}

// Pieces that have gone into another, which has taken over their materials.
std::vector<bool> taken_over(MergedPieces& all) {
    constexpr double width = cell_widths * lies_on;
    std::vector<int> const order = by_precedence(all);
    std::vector<Likeness> likenesses;
    likenesses.reserve(order.size());
    CellLists cells(order.size());
    for (std::size_t at = 0; at < order.size(); ++at) {
        Likeness const& own = likenesses.emplace_back(likeness_of(all, order[at]));
        std::uint64_t key = own.ends;
        for (double const number : own.numbers) key = joined_key(key, cell_at(number, width));
        cells.add(key, static_cast<int>(at));
    }
    std::vector<bool> gone(all.pieces.size());
    for (int at = 0; at < static_cast<int>(order.size()); ++at) {
        if (gone[order[at]]) continue;
        Piece& stays = all.pieces[order[at]];
        each_cell_near(likenesses[at], [&](std::uint64_t cell) {
            cells.each_in(cell, [&](int other) {
                if (other <= at || gone[order[other]] || !lie_on_each_other(all, order[at], order[other])) return;
                take_over(stays.material, all.pieces[order[other]].material);
                stays.surface = std::min(stays.surface, all.pieces[order[other]].surface);
                gone[order[other]] = true;
            });
        });
    }
    return gone;
}

}  // namespace

bool leave_out_doubles(MergedPieces& all) {
    std::vector<bool> const gone = taken_over(all);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < gone.size(); ++i) {
        if (gone[i]) continue;
        all.pieces[kept] = all.pieces[i];
        all.start[kept] = all.start[i];
        all.end[kept] = all.end[i];
        ++kept;
    }
    all.pieces.resize(kept);
    all.start.resize(kept);
    all.end.resize(kept);
    return kept < gone.size();
}

}  // namespace physics
