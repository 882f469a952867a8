// Edge tiles of areas side by side, as the texture that the shaders read them from, until they have been drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "screen/coverage.h"

namespace screen {

inline constexpr int edge_tiles_across = 64;
inline constexpr int edge_atlas_side = edge_tiles_across * tile_side;  // texels

class EdgeAtlas {
public:
    static constexpr int full = 0;  // the number of a tile that is all inside, which is always there

    EdgeAtlas();
    bool is_empty() const { return tiles_ == 1; }  // but for that one
    bool is_full() const { return tiles_ == edge_tiles_across * edge_tiles_across; }
    int add(EdgeTile const& tile);  // its number, until the next clear()
    void clear() { tiles_ = 1; }

    int rows() const;  // of texels that are in use
    std::uint8_t const* texels() const { return texels_.data(); }

private:
    std::vector<std::uint8_t> texels_;
    int tiles_ = 0;
};

}  // namespace screen
