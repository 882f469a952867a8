#include "screen/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace screen {
namespace {

using geometry::Vec2;

// What the edges inside one pixel add to a sum that runs along the row from the left.
struct Cell {
    int column = 0;
    double inside = 0;  // to this pixel's own value: the area to the right of the edges
    double beyond = 0;  // to every pixel further right: the height that the edges span
};

class Rows {
public:
    Rows(int width, int height) : width_(width), rows_(static_cast<std::size_t>(height)) {}

    void add_edge(Vec2 from, Vec2 to) {
        if (from.y() == to.y()) return;
        double const sign = from.y() < to.y() ? 1 : -1;
        if (sign < 0) std::swap(from, to);
        double const top = std::max(from.y(), 0.0), bottom = std::min(to.y(), static_cast<double>(rows_.size()));
        double const slope = (to.x() - from.x()) / (to.y() - from.y());
        double y = top, x = from.x() + (top - from.y()) * slope;
        while (y < bottom) {
            int const row = static_cast<int>(y);
            double const next_y = std::min(bottom, row + 1.0);
            double const next_x = from.x() + (next_y - from.y()) * slope;
            add_in_row(rows_[static_cast<std::size_t>(row)], x, next_x, sign * (next_y - y));
            y = next_y;
            x = next_x;
        }
    }

    std::vector<std::vector<Cell>>& rows() { return rows_; }

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

    int width_;
    std::vector<std::vector<Cell>> rows_;
};

std::uint8_t even_odd(double winding) {
    double value = std::abs(winding);
    value -= 2 * std::floor(value / 2);
    if (value > 1) value = 2 - value;
    return static_cast<std::uint8_t>(value * 255 + 0.5);
}

void fill_row(std::vector<Cell>& cells, std::uint8_t* values, int left, int width) {
    std::sort(cells.begin(), cells.end(), [](Cell const& a, Cell const& b) { return a.column < b.column; });
    double sum = 0;
    for (std::size_t i = 0; i < cells.size();) {
        int const column = cells[i].column;
        double own = sum;
        for (; i < cells.size() && cells[i].column == column; ++i) {
            own += cells[i].inside;
            sum += cells[i].beyond;
        }
        values[column - left] = even_odd(own);
        int const next = i < cells.size() ? cells[i].column : left + width;
        if (auto const value = even_odd(sum)) std::fill(values + column + 1 - left, values + next - left, value);
    }
}

bool are_finite(std::vector<Vec2> const& ring) {
    return std::all_of(ring.begin(), ring.end(), [](Vec2 const& point) { return geometry::is_finite(point); });
}

}  // namespace

Coverage even_odd_coverage(std::vector<std::vector<Vec2>> const& rings, int frame_width, int frame_height) {
    double least_x = frame_width, most_x = 0, least_y = frame_height, most_y = 0;
    for (auto const& ring : rings)
        for (Vec2 const& point : ring) {
            least_x = std::min(least_x, point.x());
            most_x = std::max(most_x, point.x());
            least_y = std::min(least_y, point.y());
            most_y = std::max(most_y, point.y());
        }
    Coverage coverage;
    coverage.left = static_cast<int>(std::max(0.0, std::floor(least_x)));
    coverage.top = static_cast<int>(std::max(0.0, std::floor(least_y)));
    coverage.width = static_cast<int>(std::min<double>(frame_width, std::ceil(most_x))) - coverage.left;
    coverage.height = static_cast<int>(std::min<double>(frame_height, std::ceil(most_y))) - coverage.top;
    if (coverage.width <= 0 || coverage.height <= 0) return {};
    Rows rows(frame_width, frame_height);
    for (auto const& ring : rings) {
        if (!are_finite(ring)) continue;
        for (std::size_t i = 0; i < ring.size(); ++i) rows.add_edge(ring[i], ring[(i + 1) % ring.size()]);
    }
    auto const width = static_cast<std::size_t>(coverage.width);
    coverage.values.resize(width * static_cast<std::size_t>(coverage.height));
    for (int row = 0; row < coverage.height; ++row)
        fill_row(rows.rows()[static_cast<std::size_t>(coverage.top + row)],
                 coverage.values.data() + static_cast<std::size_t>(row) * width, coverage.left, coverage.width);
    return coverage;
}

}  // namespace screen
