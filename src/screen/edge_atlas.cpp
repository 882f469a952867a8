#include "screen/edge_atlas.h"

#include <algorithm>

namespace screen {

EdgeAtlas::EdgeAtlas() : texels_(static_cast<std::size_t>(edge_atlas_side) * edge_atlas_side) {
    EdgeTile whole;
    whole.values.fill(255);
    add(whole);
}

int EdgeAtlas::add(EdgeTile const& tile) {
    int const number = tiles_++;
    int const left = number % edge_tiles_across * tile_side, top = number / edge_tiles_across * tile_side;
    for (int row = 0; row < tile_side; ++row)
        std::copy_n(tile.values.begin() + row * tile_side, tile_side,
                    texels_.begin() + (top + row) * edge_atlas_side + left);
    return number;
}

int EdgeAtlas::rows() const { return (tiles_ + edge_tiles_across - 1) / edge_tiles_across * tile_side; }

}  // namespace screen
