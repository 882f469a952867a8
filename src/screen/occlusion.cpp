#include "screen/occlusion.h"

#include <algorithm>

namespace screen {
namespace {

int squares_in(int pixels) { return (pixels + tile_side - 1) / tile_side; }

}  // namespace

Occlusion::Occlusion(int width, int height)
    : columns_(squares_in(width)),
      rows_(squares_in(height)),
      last_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1) {}

void Occlusion::cover(Box const& box, int shape) {
    int const right = std::min(box.right / tile_side, columns_), bottom = std::min(box.bottom / tile_side, rows_);
    for (int row = std::max(box.top / tile_side, 0); row < bottom; ++row)
        for (int column = std::max(box.left / tile_side, 0); column < right; ++column) {
            int& last = last_[static_cast<std::size_t>(row * columns_ + column)];
            last = std::max(last, shape);
        }
}

bool Occlusion::hides(Box const& box, int shape) const {
    int const left = std::max(box.left, 0) / tile_side, top = std::max(box.top, 0) / tile_side;
    int const right = std::min(squares_in(std::max(box.right, 0)), columns_);
    int const bottom = std::min(squares_in(std::max(box.bottom, 0)), rows_);
    if (left >= right || top >= bottom) return false;
    for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column)
            if (last(column, row) <= shape) return false;
    return true;
}

std::vector<Box> Occlusion::seen(Box const& box, int shape) const {
    std::vector<Box> seen;
    int const end = std::min(box.right / tile_side, columns_), bottom = std::min(box.bottom / tile_side, rows_);
    std::size_t above = 0;  // where the boxes begin that end at the row above
    for (int row = box.top / tile_side; row < bottom; ++row) {
        std::size_t const begun = seen.size();
        std::vector<Box> here;
        for (int column = box.left / tile_side; column < end; ++column) {
            if (last(column, row) > shape) continue;
            int right = column + 1;
            while (right < end && last(right, row) <= shape) ++right;
            here.push_back({column * tile_side, row * tile_side, right * tile_side, (row + 1) * tile_side});
            column = right;
        }
        // A row that is seen as the one above lengthens its boxes.
        bool const same = here.size() == begun - above &&
                          std::equal(here.begin(), here.end(), seen.begin() + static_cast<std::ptrdiff_t>(above),
                                     [](Box const& a, Box const& b) { return a.left == b.left && a.right == b.right; });
        if (same && !here.empty()) {
            for (std::size_t i = above; i < begun; ++i) seen[i].bottom += tile_side;
            continue;
        }
        above = begun;
        seen.insert(seen.end(), here.begin(), here.end());
    }
    return seen;
}

}  // namespace screen
