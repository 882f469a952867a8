#include "screen/graphics_card.h"

#include <doctest/doctest.h>

#include <fstream>

#include "support/folder.h"

#ifdef __linux__

TEST_CASE("a system without a device of a graphics card has software alone to draw with") {
    for (char const* device : {"dri", "nvidiactl", "dxg"}) {
        support::Folder const folder;
        std::ofstream(folder / "null");
        CHECK_FALSE(screen::may_have_graphics_card(folder.path()));
        std::ofstream(folder / device);
        CHECK(screen::may_have_graphics_card(folder.path()));
    }
}

#endif
