// Which of many things are near each other, in time that grows with their number: lists by cell of a fine grid.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace physics {

// Lists of numbers by cell of a grid of any dimension, whose cells are found by a hash: two cells may share a list, so
// what is in it has still to be looked at.
class CellLists {
public:
    explicit CellLists(std::size_t most_numbers) : next_(most_numbers, -1) {
        int bits = 4;
        while ((std::size_t{1} << bits) < 2 * most_numbers) ++bits;
        first_.assign(std::size_t{1} << bits, -1);
        shift_ = 64 - bits;
    }

    void add(std::uint64_t cell, int number) {
        next_[static_cast<std::size_t>(number)] = first_[slot_of(cell)];
        first_[slot_of(cell)] = number;
    }

    template <typename Visit>
    void each_in(std::uint64_t cell, Visit&& visit) const {
        for (int i = first_[slot_of(cell)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) visit(i);
    }

private:
    std::size_t slot_of(std::uint64_t cell) const { return (cell * 0x9E3779B97F4A7C15ULL) >> shift_; }

    std::vector<int> first_, next_;
    int shift_ = 0;
};

// The cell along one axis, and its name among those of all axes.
inline std::int64_t cell_at(double x, double width) { return static_cast<std::int64_t>(std::floor(x / width)); }
inline std::uint64_t joined_key(std::uint64_t key, std::int64_t cell) {
    return (key ^ static_cast<std::uint64_t>(cell)) * 0xD6E8FEB86659FD93ULL + (key >> 32);
}

// Cells are much wider than what is near, so that hardly any point has to look into its neighbours.
inline constexpr double cell_widths = 16;  // of the reach
inline constexpr double cell_slack = 1.5;  // of the reach, for the rounding of far coordinates

}  // namespace physics
