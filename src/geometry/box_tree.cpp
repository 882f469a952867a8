#include "geometry/box_tree.h"

#include <algorithm>
#include <cmath>

namespace geometry {

namespace {
constexpr double extent_rounding = 1e-15;  // of the coordinates, by which boxes aslant are larger
constexpr int leaf_size = 4;               // boxes; fewer make a deeper tree, more make longer scans
}  // namespace

Stroke stroke_of(Vec2 const& from, Vec2 const& to, double reach) {
    return {from, to, reach, grown({from.cwiseMin(to), from.cwiseMax(to)}, reach)};
}

BoxTree::BoxTree(std::vector<Box> const& boxes) {
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i) leaves_.push_back({{boxes[i]}, i});
    grow();
}

BoxTree::BoxTree(std::span<Curve const> curves) {
    for (int i = 0; i < static_cast<int>(curves.size()); ++i) leaves_.push_back({{box_of(curves[i])}, i});
    grow();
    for (Node& node : nodes_) node.bound = leaning(node.bound, leaves_under(node), curves);
    for (Leaf& leaf : leaves_) leaf.bound = leaning(leaf.bound, {&leaf, 1}, curves);
}

void BoxTree::grow() {
    if (leaves_.empty()) return;
    nodes_.reserve(2 * leaves_.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<int>(leaves_.size()));
}

std::span<BoxTree::Leaf const> BoxTree::leaves_under(Node const& node) const {
    Node const* first = &node;
    while (first->count == 0) first = &nodes_[first->first];
    Node const* last = &node;
    while (last->count == 0) last = &nodes_[last->first + 1];
    return std::span(leaves_).subspan(first->first, last->first + last->count - first->first);
}

Extent BoxTree::extent_of(std::span<Leaf const> leaves, std::span<Curve const> curves, Vec2 const& direction) {
    Extent whole;
    for (Leaf const& leaf : leaves) {
        Extent const extent = extent_along(curves[leaf.index], direction);
        whole = {std::min(whole.low, extent.low), std::max(whole.high, extent.high)};
    }
    double const rounding = extent_rounding * std::max(std::abs(whole.low), std::abs(whole.high));
    return {whole.low - rounding, whole.high + rounding};
}

// Along the one diagonal of the box or the other, whichever is the narrower.
BoxTree::Bound BoxTree::leaning(Bound const& bound, std::span<Leaf const> leaves, std::span<Curve const> curves) {
    Vec2 const diagonal = bound.box.high - bound.box.low;
    double const size = length(diagonal);
    if (!(size > 0)) return bound;
    Vec2 const up = diagonal / size, down(up.x(), -up.y());
    Extent const across_up = extent_of(leaves, curves, turned_left(up));
    Extent const across_down = extent_of(leaves, curves, turned_left(down));
    if (across_up.high - across_up.low < across_down.high - across_down.low)
        return {bound.box, up, extent_of(leaves, curves, up), across_up};
    return {bound.box, down, extent_of(leaves, curves, down), across_down};
}

// Halves the entries at the median of the longer axis, equals by index, and leaves them in order of index: which
// entries a node holds and how they follow each other hangs on the boxes alone.
void BoxTree::split(int node, int first, int last) {
    Box whole;
    for (int i = first; i < last; ++i) whole = united(whole, leaves_[i].bound.box);
    nodes_[node].bound.box = whole;
    if (last - first <= leaf_size) {
        // Standard libraries leave the two sides of a median in orders of their own.
        std::sort(leaves_.begin() + first, leaves_.begin() + last,
                  [](Leaf const& a, Leaf const& b) { return a.index < b.index; });
        nodes_[node].first = first;
        nodes_[node].count = last - first;
        return;
    }
    int const axis = whole.high.x() - whole.low.x() >= whole.high.y() - whole.low.y() ? 0 : 1;
    int const middle = (first + last) / 2;
    auto const before = [axis](Leaf const& a, Leaf const& b) {
        double const p = a.bound.box.low[axis] + a.bound.box.high[axis];
        double const q = b.bound.box.low[axis] + b.bound.box.high[axis];
        return p != q ? p < q : a.index < b.index;
    };
    std::nth_element(leaves_.begin() + first, leaves_.begin() + middle, leaves_.begin() + last, before);
    int const left = static_cast<int>(nodes_.size());
    nodes_[node].first = left;
    nodes_.emplace_back();
    nodes_.emplace_back();
    split(left, first, middle);
    split(left + 1, middle, last);
}

}  // namespace geometry
