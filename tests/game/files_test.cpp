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
    CHECK(game::note_time(level, 12.5) == game::Rank::best);
    CHECK(game::note_time(level, 13) == game::Rank::behind);
    CHECK(game::best_time(level).value() == 12.5);
    CHECK(game::note_time(level, 11) == game::Rank::best);
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
