// PNG files, whole or not there.
#pragma once

#include <filesystem>

#include "screen/pixels.h"

namespace screen {

// RGB, 8 bits a channel; alpha is left out. Written beside the name and renamed when whole; replaces what was there. The
// folder must exist. Throws std::runtime_error("NAME: reason") and leaves nothing behind when it cannot be written. Safe
// from several threads.
void write_png(std::filesystem::path const& file, Pixels const& pixels);

}  // namespace screen
