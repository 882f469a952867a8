#include "screen/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace screen {
namespace {

using geometry::FillRule;
using geometry::Vec2;

// What the edges inside one pixel add to a sum that runs along the row from the left.
struct Cell {
    int column = 0;
    double inside = 0;  // to this pixel's own value: the area to the right of the edges
    double beyond = 0;  // to every pixel further right: the height that the edges span
};

// Upwards to a multiple of tile_side.
int whole_tiles(int pixels) { return (pixels + tile_side - 1) / tile_side * tile_side; }

class Rows {
public:
    Rows(int right, int top, int bottom) : width_(right), top_(top), rows_(static_cast<std::size_t>(bottom - top)) {}

    void add_edge(Vec2 from, Vec2 to) {
        if (from.y() == to.y()) return;
        double const sign = from.y() < to.y() ? 1 : -1;
        if (sign < 0) std::swap(from, to);
        double const last = top_ + static_cast<double>(rows_.size());
        double const top = std::max<double>(from.y(), top_), bottom = std::min(to.y(), last);
        double const slope = (to.x() - from.x()) / (to.y() - from.y());
        double y = top, x = from.x() + (top - from.y()) * slope;
        while (y < bottom) {
            int const number = static_cast<int>(y);
            double const next_y = std::min(bottom, number + 1.0);
            double const next_x = from.x() + (next_y - from.y()) * slope;
            add_in_row(row(number), x, next_x, sign * (next_y - y));
            y = next_y;
            x = next_x;
        }
    }

    std::vector<Cell>& row(int number) { return rows_[static_cast<std::size_t>(number - top_)]; }

private:
    // An edge across part of one row, of the given signed height.
    void add_in_row(std::vector<Cell>& row, double x0, double x1, double height) const {
        if (x0 > x1) std::swap(x0, x1);
        double const width = width_;
        if (x0 >= width) return;
        if (x1 <= 0) return row.push_back({0, height, height});
        double const per_pixel = x1 > x0 ? height / (x1 - x0) : 0;
        if (x0 < 0) {
            row.push_back({0, -x0 * per_pixel, -x0 * per_pixel});
            height += x0 * per_pixel;
            x0 = 0;
        }
        x1 = std::min(x1, width);
        int const first = std::min(static_cast<int>(x0), width_ - 1);
        if (x1 <= first + 1.0) {
            row.push_back({first, height_to_area(height, x0, x1, first), height});
            return;
        }
        for (int column = first; column < x1; ++column) {
            double const a = std::max<double>(x0, column), b = std::min<double>(x1, column + 1);
            double const part = (b - a) * per_pixel;
            row.push_back({column, height_to_area(part, a, b, column), part});
        }
    }

    static double height_to_area(double height, double a, double b, int column) {
        return height * (column + 1 - (a + b) / 2);
    }

    int width_, top_;
    std::vector<std::vector<Cell>> rows_;
};

std::uint8_t filled(double winding, FillRule rule) {
    double value = std::abs(winding);
    if (rule == FillRule::nonzero) {
        value = std::min(value, 1.0);
    } else {
        value -= 2 * std::floor(value / 2);
        if (value > 1) value = 2 - value;
    }
    return static_cast<std::uint8_t>(value * 255 + 0.5);
}

// Fills the pixels of one row from the box's left edge.
void fill_row(std::vector<Cell>& cells, FillRule rule, std::uint8_t* values, Box const& box) {
    std::sort(cells.begin(), cells.end(), [](Cell const& a, Cell const& b) { return a.column < b.column; });
    double sum = 0;
    for (std::size_t i = 0; i < cells.size();) {
        int const column = cells[i].column;
        double own = sum;
        for (; i < cells.size() && cells[i].column == column; ++i) {
            own += cells[i].inside;
            sum += cells[i].beyond;
        }
        values[column - box.left] = filled(own, rule);
        int const next = i < cells.size() ? cells[i].column : box.right;
        if (auto const value = filled(sum, rule))
            std::fill(values + column + 1 - box.left, values + next - box.left, value);
    }
}

bool are_finite(std::vector<Vec2> const& ring) {
    return std::all_of(ring.begin(), ring.end(), [](Vec2 const& point) { return geometry::is_finite(point); });
}

// The box of the tiles that the rings reach, cut at the frame.
Box reach(std::vector<std::vector<Vec2>> const& rings, int frame_width, int frame_height) {
    double const width = whole_tiles(frame_width), height = whole_tiles(frame_height);
    double left = width, right = 0, top = height, bottom = 0;
    for (auto const& ring : rings)
        for (Vec2 const& point : ring) {
            left = std::min(left, point.x());
            right = std::max(right, point.x());
            top = std::min(top, point.y());
            bottom = std::max(bottom, point.y());
        }
    return {whole_tiles(static_cast<int>(std::max(left, 0.0)) - tile_side + 1),
            whole_tiles(static_cast<int>(std::max(top, 0.0)) - tile_side + 1),
            whole_tiles(static_cast<int>(std::ceil(std::min(right, width)))),
            whole_tiles(static_cast<int>(std::ceil(std::min(bottom, height))))};
}

enum class Inside { none, some, all };

// Of a tile within rows of the given length.
Inside inside(std::uint8_t const* corner, std::size_t stride) {
    std::uint64_t any = 0, all = ~std::uint64_t{0};
    for (int row = 0; row < tile_side; ++row, corner += stride)
        for (int eighth = 0; eighth < tile_side; eighth += 8) {
            std::uint64_t pixels = 0;
            std::memcpy(&pixels, corner + eighth, sizeof pixels);
            any |= pixels;
            all &= pixels;
        }
    return any == 0 ? Inside::none : ~all == 0 ? Inside::all : Inside::some;
}

EdgeTile edge_tile(int left, int top, std::uint8_t const* corner, std::size_t stride) {
    EdgeTile tile{left, top, {}};
    for (std::size_t row = 0; row < tile_side; ++row)
        std::copy_n(corner + row * stride, tile_side, tile.values.begin() + row * tile_side);
    return tile;
}

// One row of tiles; a run of inner tiles grows the box above it where it is as wide.
void add_tiles(Coverage& coverage, std::uint8_t const* row, Box const& box, int top) {
    auto const stride = static_cast<std::size_t>(box.right - box.left);
    for (int left = box.left; left < box.right;) {
        std::uint8_t const* const corner = row + (left - box.left);
        Inside const kind = inside(corner, stride);
        if (kind == Inside::some) coverage.edges.push_back(edge_tile(left, top, corner, stride));
        int right = left + tile_side;
        if (kind == Inside::all) {
            while (right < box.right && inside(row + (right - box.left), stride) == Inside::all) right += tile_side;
            auto const above = std::find_if(coverage.inside.begin(), coverage.inside.end(), [&](Box const& other) {
                return other.bottom == top && other.left == left && other.right == right;
            });
            if (above != coverage.inside.end())
                above->bottom += tile_side;
            else
                coverage.inside.push_back({left, top, right, top + tile_side});
        }
        left = right;
    }
}

}  // namespace

Box seen_part_of(EdgeTile const& tile) {
    constexpr int block = 4;  // pixels
    int left = tile_side, top = tile_side, right = 0, bottom = 0;
    for (int y = 0; y < tile_side; ++y)
        for (int x = 0; x < tile_side; x += block) {
            std::uint32_t pixels = 0;
            std::memcpy(&pixels, &tile.values[static_cast<std::size_t>(y * tile_side + x)], sizeof pixels);
            if (pixels == 0) continue;
            int const row = y / block * block;
            left = std::min(left, x);
            right = std::max(right, x + block);
            top = std::min(top, row);
            bottom = row + block;
        }
    if (left >= right) return {tile.left, tile.top, tile.left, tile.top};
    return {tile.left + left, tile.top + top, tile.left + right, tile.top + bottom};
}

Coverage coverage_of(std::vector<std::vector<Vec2>> const& rings, FillRule rule, int frame_width, int frame_height) {
    Box const box = reach(rings, frame_width, frame_height);
    if (box.left >= box.right || box.top >= box.bottom) return {};
    Rows rows(box.right, box.top, box.bottom);
    for (auto const& ring : rings) {
        if (!are_finite(ring)) continue;
        for (std::size_t i = 0; i < ring.size(); ++i) rows.add_edge(ring[i], ring[(i + 1) % ring.size()]);
    }
    Coverage coverage;
    auto const width = static_cast<std::size_t>(box.right - box.left);
    std::vector<std::uint8_t> values(width * tile_side);
    for (int top = box.top; top < box.bottom; top += tile_side) {
        std::fill(values.begin(), values.end(), std::uint8_t{0});
        for (int row = 0; row < tile_side; ++row)
            fill_row(rows.row(top + row), rule, values.data() + static_cast<std::size_t>(row) * width, box);
        add_tiles(coverage, values.data(), box, top);
    }
    return coverage;
}

}  // namespace screen
