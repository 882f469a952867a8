#include "game/preferences.h"

#include <cstdlib>

#include <doctest/doctest.h>

#include "scratch.h"

TEST_CASE("preferences are kept, and what is spoilt is set aside") {
    game_test::Scratch const scratch;
    char const* const before = std::getenv("XDG_DATA_HOME");
    std::string const kept = before ? before : "";
    setenv("XDG_DATA_HOME", scratch.path("data").c_str(), 1);

    CHECK(game::preferences() == game::Preferences{});
    CHECK(!game::keep({0.3, true}));
    CHECK(game::preferences() == game::Preferences{0.3, true});

    std::string const file = "data/smb2d/preferences.json";
    scratch.file(file, R"({"volume": 7, "muted": true, "of a later program": 1})");
    CHECK(game::preferences() == game::Preferences{game::Preferences{}.volume, true});
    scratch.file(file, "{\"volu");
    CHECK(game::preferences() == game::Preferences{});
    auto const aside = game::keep({0.5, false});
    REQUIRE(aside);
    CHECK(std::filesystem::exists(*aside));
    CHECK(game::preferences() == game::Preferences{0.5, false});

    if (before)
        setenv("XDG_DATA_HOME", kept.c_str(), 1);
    else
        unsetenv("XDG_DATA_HOME");
}
