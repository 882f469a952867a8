// Whether OpenGL can be more than software here, told without starting it.
#pragma once

#include <filesystem>

namespace screen {

// False where a Linux system has no device of a graphics card: starting OpenGL only to learn that it is software takes
// most of the time to a window's first picture. True elsewhere, and where it is not known.
bool may_have_graphics_card(std::filesystem::path const& devices = "/dev");

}  // namespace screen
