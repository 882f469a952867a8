// PNG files, whole or not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "screen/pixels.h"

namespace screen {

// RGB, 8 bits a channel; alpha is left out.
std::vector<std::uint8_t> png_of(Pixels const& pixels);

// Written beside the name and renamed when whole; replaces what was there. The folder must exist. Throws
// std::runtime_error("NAME: reason") and leaves nothing behind when it cannot be written. Safe from several threads.
void write_png(std::filesystem::path const& file, Pixels const& pixels);

// Throws std::runtime_error("NAME: reason").
Pixels read_png(std::filesystem::path const& file);

}  // namespace screen
