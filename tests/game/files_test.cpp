#include <cstdlib>
#include <filesystem>

#include <doctest/doctest.h>

#include "game/best_times.h"
#include "game/whole_file.h"
#include "scratch.h"

using game_test::message_of;
using game_test::Scratch;

TEST_CASE("a file is written whole, into a folder that is made for it, and nothing is left beside it") {
    Scratch const scratch;
    std::string const file = scratch.path("a/b/c.txt");
    game::write_whole_file(file, "first");
    game::write_whole_file(file, "second");
    CHECK(game::read_whole_file(file, 100) == "second");
    int files = 0;
    for (auto const& entry : std::filesystem::directory_iterator(scratch.path("a/b"))) files += entry.exists() ? 1 : 0;
    CHECK(files == 1);
}

TEST_CASE("what cannot be written or read is named") {
    Scratch const scratch;
    std::string const taken = scratch.file("taken", "");
    CHECK(message_of([&] { game::write_whole_file(taken + "/x", ""); }).find(taken) == 0);
    CHECK(message_of([&] { game::read_whole_file(scratch.path("nowhere"), 10); }).find(scratch.path("nowhere")) == 0);
    CHECK(message_of([&] { game::read_whole_file(scratch.path("."), 10); }).find("directory") != std::string::npos);
    CHECK(message_of([&] { game::read_whole_file(scratch.file("long", "12345"), 4); }).find("larger") !=
          std::string::npos);
}

TEST_CASE("only a shorter time replaces the best one") {
    Scratch const scratch;
    setenv("XDG_DATA_HOME", scratch.path("data").c_str(), 1);
    level::Level level;
    level.hash = "0123456789abcdef";
    CHECK_FALSE(game::best_time(level));
    CHECK(game::note_time(level, 12.5).rank == game::Rank::best);
    CHECK(game::note_time(level, 13).rank == game::Rank::behind);
    CHECK(game::best_time(level).value() == 12.5);
    CHECK_FALSE(game::note_time(level, 11).set_aside);
    CHECK(game::best_time(level).value() == 11);
}

TEST_CASE("a spoilt list of best times counts as none") {
    Scratch const scratch;
    setenv("XDG_DATA_HOME", scratch.path("").c_str(), 1);
    game::write_whole_file(scratch.path("smb2d/best.json"), "{\"x\": ");
    CHECK(game::best_times().empty());
    game::write_whole_file(scratch.path("smb2d/best.json"), "[1, 2]");
    game::best_times();  // whatever it is, it is read without harm
}

TEST_CASE("a spoilt list of best times is set aside before another is written, and never over another") {
    Scratch const scratch;
    setenv("XDG_DATA_HOME", scratch.path("").c_str(), 1);
    std::string const best = scratch.path("smb2d/best.json");
    level::Level level;
    level.hash = "0123456789abcdef";
    int count = 0;
    for (std::string const spoilt : {"{\"0000000000000001\": 3", "[1, 2]", "{\"0000000000000001\": \"3 s\"}", ""}) {
        CAPTURE(spoilt);
        game::write_whole_file(best, spoilt);
        game::Noted const noted = game::note_time(level, 5);
        CHECK(noted.rank == game::Rank::best);
        REQUIRE(noted.set_aside);
        CHECK(noted.set_aside->string() == best + ".spoilt" + (++count == 1 ? "" : "-" + std::to_string(count)));
        CHECK(game::read_whole_file(noted.set_aside->string(), 100) == spoilt);
        CHECK(game::best_times() == std::map<std::string, double>{{level.hash, 5}});
    }
}

TEST_CASE("a file that is a link stays one, and so does one whose target is not there yet") {
    namespace fs = std::filesystem;
    Scratch const scratch;
    setenv("XDG_DATA_HOME", scratch.path("data").c_str(), 1);
    fs::create_directories(scratch.path("data/smb2d"));
    fs::create_directories(scratch.path("synced"));
    fs::create_symlink("../../second", scratch.path("data/smb2d/best.json"));
    fs::create_symlink(scratch.path("synced/best.json"), scratch.path("second"));
    level::Level level;
    level.hash = "0123456789abcdef";
    auto const is_still_a_link = [&] {
        return fs::is_symlink(fs::symlink_status(scratch.path("data/smb2d/best.json")));
    };
    game::note_time(level, 5);
    CHECK(is_still_a_link());
    CHECK(fs::is_regular_file(fs::symlink_status(scratch.path("synced/best.json"))));
    CHECK(game::best_time(level).value() == 5);
    scratch.file("synced/best.json", "{");
    CHECK(game::note_time(level, 6).set_aside.value() == scratch.path("synced/best.json.spoilt"));
    CHECK(is_still_a_link());
    CHECK(game::best_time(level).value() == 6);
}

TEST_CASE("links without end are told") {
    Scratch const scratch;
    std::filesystem::create_symlink("b", scratch.path("a"));
    std::filesystem::create_symlink("a", scratch.path("b"));
    CHECK(message_of([&] { game::write_whole_file(scratch.path("a"), "x"); }).find(scratch.path("a")) == 0);
}
