#include "game/preferences.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "game/whole_file.h"
#include "support/folder.h"

using support::DataFolder;

TEST_CASE("preferences are kept") {
    DataFolder const folder;
    CHECK(game::read_preferences().preferences == game::Preferences{});
    game::Preferences const other{0.3, true, false, true, true, game::Language::german, {{"pause", {"P", "Space"}}}};
    CHECK(!game::keep(other));
    game::ReadPreferences const read = game::read_preferences();
    CHECK(read.preferences == other);
    CHECK(read.faults.empty());
    CHECK(read.file == folder.path("preferences.json"));
    CHECK(!game::keep({}));
    CHECK(game::read_preferences().preferences == game::Preferences{});
}

TEST_CASE("a file of preferences that is spoilt is told and set aside") {
    DataFolder const folder;
    for (char const* text : {"{\"volu", "[1]"}) {
        folder.file("preferences.json", text);
        game::ReadPreferences const read = game::read_preferences();
        CHECK(read.preferences == game::Preferences{});
        CHECK(read.faults.size() == 1);
        game::Preferences softer;
        softer.volume = 0.5;
        auto const aside = game::keep(softer);
        REQUIRE(aside);
        CHECK(std::filesystem::exists(*aside));
        CHECK(game::read_preferences().preferences == softer);
    }
}

TEST_CASE("what of the preferences cannot be understood is told, a line each, and the rest holds") {
    DataFolder const folder;
    folder.file("preferences.json",
                R"({"volume": 7, "muted": true, "turning": 1, "language": "dutch", "keys": {"pause": [1], "save": "F7"},
                    "high_contrast": "yes"})");
    game::ReadPreferences const read = game::read_preferences();
    game::Preferences expected;
    expected.muted = true;
    expected.keys = {{"save", {"F7"}}};
    CHECK(read.preferences == expected);
    CHECK(read.faults == std::vector<std::string>{"volume: must be a number from 0 to 1, got 7",
                                                  "turning: must be true or false, got 1",
                                                  "high_contrast: must be true or false, got \"yes\"",
                                                  "language: must be system, english or german, got \"dutch\"",
                                                  "keys: pause: must be a list of names of keys"});
}

TEST_CASE("what a later program keeps beside the preferences stays") {
    DataFolder const folder;
    folder.file("preferences.json", R"({"of a later program": {"a": 1}, "keys": {"jump": ["J"]}})");
    game::Preferences preferences = game::read_preferences().preferences;
    preferences.volume = 0.4;
    CHECK(!game::keep(preferences));
    auto const content = nlohmann::json::parse(game::read_whole_file(folder.path("preferences.json"), 1 << 20));
    CHECK(content["of a later program"]["a"] == 1);
    CHECK(content["keys"]["jump"][0] == "J");
    CHECK(content["volume"] == 0.4);
}
