// A static tree of boxes: finds those that overlap a given one in time that grows with the answer, not with the whole.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace geometry {

class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Box> const& boxes);

    // Calls visit(index) for every box that overlaps `box`, in an order that depends on the tree alone.
    template <typename Visit>
    void each_overlapping(Box const& box, Visit&& visit) const {
        if (nodes_.empty()) return;
        int stack[64];
        int depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            Node const& node = nodes_[stack[--depth]];
            if (!overlap(node.box, box)) continue;
            if (node.count > 0) {
                for (int i = node.first; i < node.first + node.count; ++i)
                    if (overlap(leaves_[i].box, box)) visit(leaves_[i].index);
            } else {
                stack[depth++] = node.first + 1;
                stack[depth++] = node.first;
            }
        }
    }

    bool overlaps_any(Box const& box) const {
        bool found = false;
        each_overlapping(box, [&found](int) { found = true; });
        return found;
    }

private:
    struct Node {
        Box box;
        int first = 0;  // a leaf's first entry, or the left child; the right child follows it
        int count = 0;  // entries of a leaf, 0 for an inner node
    };
    struct Leaf {
        Box box;
        int index = 0;
    };
    void split(int node, int first, int last);

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

}  // namespace geometry
