#include "screen/graphics_card.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace screen {

bool may_have_graphics_card(std::filesystem::path const& devices) {
#ifdef __linux__
    // Of the kernel's own drivers, NVIDIA's, and Windows' below a Linux.
    std::array<char const*, 3> const names{"dri", "nvidiactl", "dxg"};
    return std::any_of(names.begin(), names.end(), [&](char const* name) {
        std::error_code unknown;
        return std::filesystem::exists(devices / name, unknown) || unknown;
    });
#else
    return !devices.empty();
#endif
}

}  // namespace screen
