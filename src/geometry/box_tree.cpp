#include "geometry/box_tree.h"

#include <algorithm>
#include <cmath>

namespace geometry {

namespace {
constexpr double extent_rounding = 1e-15;  // of the coordinates, by which boxes aslant are larger
constexpr double bound_rounding = 4e-15;   // the same, of those around other boxes aslant
constexpr int leaf_size = 4;               // boxes; fewer make a deeper tree, more make longer scans
}  // namespace

Stroke stroke_of(Vec2 const& from, Vec2 const& to, double reach) {
    return {from, to, reach, grown({from.cwiseMin(to), from.cwiseMax(to)}, reach)};
}

BoxTree::BoxTree(std::vector<Box> const& boxes) {
    if (!boxes.empty()) parts_ = std::make_shared<Parts const>(grown_over(boxes));
}

BoxTree::BoxTree(std::span<Curve const> curves) {
    if (curves.empty()) return;
    std::vector<Box> boxes;
    boxes.reserve(curves.size());
    for (Curve const& curve : curves) boxes.push_back(box_of(curve));
    Parts parts = grown_over(boxes);
    for (Leaf& leaf : parts.leaves) leaf.bound = leaning(leaf.bound.box, curves.subspan(leaf.index, 1));
    std::vector<Curve> held;
    // Children come after their parents.
    for (auto node = parts.nodes.rbegin(); node != parts.nodes.rend(); ++node) {
        if (node->count == 0) {
            Bound const &left = parts.nodes[node->first].bound, &right = parts.nodes[node->first + 1].bound;
            node->bound = leaning(node->bound.box, left, right);
            continue;
        }
        held.clear();
        for (int i = node->first; i < node->first + node->count; ++i) held.push_back(curves[parts.leaves[i].index]);
        node->bound = leaning(node->bound.box, held);
    }
    parts_ = std::make_shared<Parts const>(std::move(parts));
}

struct BoxTree::Entry {
    Vec2 twice_middle;
    int index;
};

BoxTree::Parts BoxTree::grown_over(std::vector<Box> const& boxes) {
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (Box const& box : boxes) entries.push_back({box.low + box.high, static_cast<int>(entries.size())});
    Parts parts;
    parts.nodes.reserve(2 * boxes.size());
    parts.nodes.emplace_back();
    split(parts.nodes, 0, 0, entries, boxes);
    parts.leaves.reserve(boxes.size());
    for (Entry const& entry : entries) parts.leaves.push_back({{boxes[entry.index]}, entry.index});
    return parts;
}

// Along the one diagonal of the box or the other, whichever is the narrower; `reach(direction)` is the extent.
template <typename Reach>
BoxTree::Bound BoxTree::leaning_by(Box const& box, Reach const& reach) {
    Vec2 const diagonal = box.high - box.low;
    double const size = length(diagonal);
    if (!(size > 0)) return {box};
    Vec2 const up = diagonal / size, down(up.x(), -up.y());
    Extent const across_up = reach(turned_left(up)), across_down = reach(turned_left(down));
    if (across_up.high - across_up.low < across_down.high - across_down.low) return {box, up, reach(up), across_up};
    return {box, down, reach(down), across_down};
}

BoxTree::Bound BoxTree::leaning(Box const& box, std::span<Curve const> curves) {
    return leaning_by(box, [&](Vec2 const& direction) {
        Extent whole;
        for (Curve const& curve : curves) {
            Extent const extent = extent_along(curve, direction);
            whole = {std::min(whole.low, extent.low), std::max(whole.high, extent.high)};
        }
        double const rounding = extent_rounding * std::max(std::abs(whole.low), std::abs(whole.high));
        return Extent{whole.low - rounding, whole.high + rounding};
    });
}

// From the bounds of its halves alone, so that a tree takes time that grows with its leaves.
BoxTree::Bound BoxTree::leaning(Box const& box, Bound const& left, Bound const& right) {
    return leaning_by(box, [&](Vec2 const& direction) {
        Extent const a = extent_of(left, direction), b = extent_of(right, direction);
        return Extent{std::min(a.low, b.low), std::max(a.high, b.high)};
    });
}

// Of what lies in both of its boxes, or more.
Extent BoxTree::extent_of(Bound const& bound, Vec2 const& direction) {
    auto const share_of = [](Extent const& extent, double share) {
        return share >= 0 ? Extent{share * extent.low, share * extent.high}
                          : Extent{share * extent.high, share * extent.low};
    };
    auto const sum = [](Extent const& a, Extent const& b) { return Extent{a.low + b.low, a.high + b.high}; };
    Extent extent = sum(share_of({bound.box.low.x(), bound.box.high.x()}, direction.x()),
                        share_of({bound.box.low.y(), bound.box.high.y()}, direction.y()));
    if (bound.way != Vec2::Zero()) {
        Extent const aslant = sum(share_of(bound.along, dot(bound.way, direction)),
                                  share_of(bound.across, dot(turned_left(bound.way), direction)));
        extent = {std::max(extent.low, aslant.low), std::min(extent.high, aslant.high)};
    }
    double const farthest = std::max(bound.box.low.cwiseAbs().maxCoeff(), bound.box.high.cwiseAbs().maxCoeff());
    return {extent.low - bound_rounding * farthest, extent.high + bound_rounding * farthest};
}

// Halves the entries at the median of the longer axis, equals by index, and leaves them in order of index: which
// entries a node holds and how they follow each other hangs on the boxes alone.
void BoxTree::split(std::vector<Node>& nodes, int node, int first, std::span<Entry> entries,
                    std::vector<Box> const& boxes) {
    Box whole;
    for (Entry const& entry : entries) whole = united(whole, boxes[entry.index]);
    nodes[node].bound.box = whole;
    auto const count = static_cast<int>(entries.size());
    if (count <= leaf_size) {
        // Standard libraries leave the two sides of a median in orders of their own.
        std::sort(entries.begin(), entries.end(), [](Entry const& a, Entry const& b) { return a.index < b.index; });
        nodes[node].first = first;
        nodes[node].count = count;
        return;
    }
    int const axis = whole.high.x() - whole.low.x() >= whole.high.y() - whole.low.y() ? 0 : 1;
    int const half = count / 2;
    std::nth_element(entries.begin(), entries.begin() + half, entries.end(), [axis](Entry const& a, Entry const& b) {
        double const p = a.twice_middle[axis], q = b.twice_middle[axis];
        return p != q ? p < q : a.index < b.index;
    });
    int const left = static_cast<int>(nodes.size());
    nodes[node].first = left;
    nodes.emplace_back();
    nodes.emplace_back();
    split(nodes, left, first, entries.first(half), boxes);
    split(nodes, left + 1, first + half, entries.subspan(half), boxes);
}

}  // namespace geometry
