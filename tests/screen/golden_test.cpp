// Run with SMB2D_REMAKE_GOLDEN=1 to make the golden pictures anew, then look at them.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "screen/offscreen.h"
#include "screen/png.h"
#include "screen/samples.h"

namespace {

// Other instruction sets round differently: by 2 in 0.2 % of the bytes.
constexpr int largest_difference = 2;
constexpr double different_share = 0.002;

void compare(std::string const& name, view::Picture const& picture) {
    std::filesystem::path const file = std::filesystem::path(TEST_DATA) / "screen/golden" / (name + ".png");
    auto const pixels = screen::Offscreen().paint(picture);
    if (std::getenv("SMB2D_REMAKE_GOLDEN")) screen::write_png(file, pixels);
    auto const golden = samples::read_png(file);
    REQUIRE(golden.width == pixels.width);
    REQUIRE(golden.height == pixels.height);
    int largest = 0;
    std::size_t different = 0;
    for (std::size_t i = 0; i < pixels.rgba.size(); ++i) {
        int const difference = std::abs(pixels.rgba[i] - golden.rgba[i]);
        largest = std::max(largest, difference);
        if (difference > 0) ++different;
    }
    INFO(name);
    CHECK(largest <= largest_difference);
    CHECK(static_cast<double>(different) <= different_share * static_cast<double>(pixels.rgba.size()));
}

}  // namespace

TEST_CASE("pictures look as they did when someone looked at them") {
    compare("shapes", samples::shapes());
    compare("ground", samples::ground());
    compare("balls", samples::balls());
    compare("letters", samples::letters());
}
