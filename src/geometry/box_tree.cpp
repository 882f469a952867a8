#include "geometry/box_tree.h"

#include <algorithm>

namespace geometry {

namespace {
constexpr int leaf_size = 4;  // boxes; fewer make a deeper tree, more make longer scans
}

BoxTree::BoxTree(std::vector<Box> const& boxes) {
    if (boxes.empty()) return;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i) leaves_.push_back({boxes[i], i});
    nodes_.reserve(2 * boxes.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<int>(boxes.size()));
}

// Halves the entries at the median of the longer axis; ties are broken by index, so the tree is always the same.
void BoxTree::split(int node, int first, int last) {
    Box whole;
    for (int i = first; i < last; ++i) whole = united(whole, leaves_[i].box);
    nodes_[node].box = whole;
    if (last - first <= leaf_size) {
        nodes_[node].first = first;
        nodes_[node].count = last - first;
        return;
    }
    int const axis = whole.high.x() - whole.low.x() >= whole.high.y() - whole.low.y() ? 0 : 1;
    int const middle = (first + last) / 2;
    auto const before = [axis](Leaf const& a, Leaf const& b) {
        double const p = a.box.low[axis] + a.box.high[axis];
        double const q = b.box.low[axis] + b.box.high[axis];
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
