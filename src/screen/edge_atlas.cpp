#include "screen/edge_atlas.h"

#include <algorithm>

namespace screen {

int EdgeAtlas::add(EdgeTile const& tile) {
    texels_.resize(static_cast<std::size_t>(edge_atlas_side) * edge_atlas_side);
    int const number = tiles_++;
    int const left = number % edge_tiles_across * tile_side, top = number / edge_tiles_across * tile_side;
    for (int row = 0; row < tile_side; ++row)
        std::copy_n(tile.values.begin() + row * tile_side, tile_side,
                    texels_.begin() + (top + row) * edge_atlas_side + left);
    return number;
}

int EdgeAtlas::rows() const { return (tiles_ + edge_tiles_across - 1) / edge_tiles_across * tile_side; }

}  // namespace screen
