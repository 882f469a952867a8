// A static tree of boxes: finds those that overlap a given one in time that grows with the answer, not with the whole.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "geometry/curve.h"

namespace geometry {

// All that lies within `reach` of a straight way; `box` bounds it.
struct Stroke {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    double reach = 0;
    Box box;
};
Stroke stroke_of(Vec2 const& from, Vec2 const& to, double reach);

class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Box> const& boxes);
    // A tree of curves also knows how they lean: next to a chain of short chords hardly any of them is visited.
    explicit BoxTree(std::span<Curve const> curves);

    // Calls visit(index) for every box that overlaps `box`, in an order that depends on the tree alone.
    template <typename Visit>
    void each_overlapping(Box const& box, Visit&& visit) const {
        each_that([&box](Bound const& bound) { return overlap(bound.box, box); }, visit);
    }

    bool overlaps_any(Box const& box) const {
        bool found = false;
        each_overlapping(box, [&found](int) { found = true; });
        return found;
    }

    // Calls visit(index) for every curve that comes within reach, and for some that nearly do, in such an order.
    template <typename Visit>
    void each_near(Stroke const& stroke, Visit&& visit) const {
        auto const is_near = [&stroke](Bound const& bound) {
            if (!overlap(bound.box, stroke.box)) return false;
            double const along = gap_between(bound.along, bound.way, stroke);
            double const across = gap_between(bound.across, turned_left(bound.way), stroke);
            return along * along + across * across <= stroke.reach * stroke.reach;
        };
        each_that(is_near, visit);
    }

private:
    // An upright box, and one aslant that holds the same curves: how far they reach along `way` and across it. Without
    // curves it is a point that everything is near to.
    struct Bound {
        Box box;
        Vec2 way = Vec2::Zero();
        Extent along{0, 0}, across{0, 0};
    };
    struct Node {
        Bound bound;
        int first = 0;  // a leaf's first entry, or the left child; the right child follows it
        int count = 0;  // entries of a leaf, 0 for an inner node
    };
    struct Leaf {
        Bound bound;
        int index = 0;
    };

    template <typename Admits, typename Visit>
    void each_that(Admits const& admits, Visit&& visit) const {
        if (!parts_) return;
        std::vector<Node> const& nodes = parts_->nodes;
        std::vector<Leaf> const& leaves = parts_->leaves;
        int stack[64];
        int depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            Node const& node = nodes[stack[--depth]];
            if (!admits(node.bound)) continue;
            if (node.count > 0) {
                for (int i = node.first; i < node.first + node.count; ++i)
                    if (admits(leaves[i].bound)) visit(leaves[i].index);
            } else {
                stack[depth++] = node.first + 1;
                stack[depth++] = node.first;
            }
        }
    }
    static double gap_between(Extent const& extent, Vec2 const& direction, Stroke const& stroke) {
        double const a = dot(direction, stroke.from), b = dot(direction, stroke.to);
        return std::max({0.0, extent.low - std::max(a, b), std::min(a, b) - extent.high});
    }
    struct Parts {
        std::vector<Node> nodes;
        std::vector<Leaf> leaves;
    };
    struct Entry;
    static Parts grown_over(std::vector<Box> const& boxes);
    static void split(std::vector<Node>& nodes, int node, int first, std::span<Entry> entries,
                      std::vector<Box> const& boxes);
    template <typename Reach>
    static Bound leaning_by(Box const& box, Reach const& reach);
    static Bound leaning(Box const& box, std::span<Curve const> curves);
    static Bound leaning(Box const& box, Bound const& left, Bound const& right);
    static Extent extent_of(Bound const& bound, Vec2 const& direction);

    std::shared_ptr<Parts const> parts_;  // shared by copies; none where there are no boxes
};

}  // namespace geometry
