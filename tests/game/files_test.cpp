#include <filesystem>

#include <doctest/doctest.h>

#include "game/best_times.h"
#include "game/whole_file.h"
#include "support/folder.h"

using support::DataFolder;
using support::Folder;
using support::message_of;

namespace {

level::Level level_of_hash(std::string const& hash) {
    level::Level level;
    level.hash = hash;
    return level;
}

level::Level const some_level = level_of_hash("0123456789abcdef");

}  // namespace

TEST_CASE("a file is written whole, into a folder that is made for it, and nothing is left beside it") {
    Folder const folder;
    std::string const file = folder.path("a/b/c.txt");
    game::write_whole_file(file, "first");
    game::write_whole_file(file, "second");
    CHECK(game::read_whole_file(file, 100) == "second");
    CHECK(std::distance(std::filesystem::directory_iterator(folder / "a/b"), {}) == 1);
}

TEST_CASE("what cannot be written or read is named") {
    Folder const folder;
    std::string const taken = folder.file("taken", "");
    CHECK(message_of([&] { game::write_whole_file(taken + "/x", ""); }).find(taken) == 0);
    CHECK(message_of([&] { game::read_whole_file(folder.path("nowhere"), 10); }).find(folder.path("nowhere")) == 0);
    CHECK(message_of([&] { game::read_whole_file(folder.path("."), 10); }).find("directory") != std::string::npos);
    CHECK(message_of([&] { game::read_whole_file(folder.file("long", "12345"), 4); }).find("larger") !=
          std::string::npos);
}

TEST_CASE("only a shorter time replaces the best one") {
    DataFolder const folder;
    CHECK_FALSE(game::best_time(some_level));
    CHECK(game::note_time(some_level, 12.5).rank == game::Rank::best);
    CHECK(game::note_time(some_level, 13).rank == game::Rank::behind);
    CHECK(game::best_time(some_level).value() == 12.5);
    CHECK_FALSE(game::note_time(some_level, 11).set_aside);
    CHECK(game::best_time(some_level).value() == 11);
}

TEST_CASE("a spoilt list of best times is set aside before another is written, and never over another") {
    DataFolder const folder;
    std::string const best = folder.path("best.json");
    int count = 0;
    for (std::string const spoilt : {"{\"0000000000000001\": 3", "[1, 2]", "{\"0000000000000001\": \"3 s\"}", ""}) {
        CAPTURE(spoilt);
        folder.file("best.json", spoilt);
        if (spoilt != "[1, 2]") CHECK(game::best_times().empty());
        game::Noted const noted = game::note_time(some_level, 5);
        CHECK(noted.rank == game::Rank::best);
        REQUIRE(noted.set_aside);
        CHECK(noted.set_aside->string() == best + ".spoilt" + (++count == 1 ? "" : "-" + std::to_string(count)));
        CHECK(game::read_whole_file(noted.set_aside->string(), 100) == spoilt);
        CHECK(game::best_times() == std::map<std::string, double>{{some_level.hash, 5}});
    }
}

TEST_CASE("a file that is a link stays one, and so does one whose target is not there yet") {
    namespace fs = std::filesystem;
    DataFolder const data;
    Folder const& folder = data.folder;
    fs::path const link = data.path("best.json"), target = folder / "synced/best.json";
    fs::create_directories(link.parent_path());
    fs::create_directories(target.parent_path());
    fs::create_symlink("../../second", link);
    fs::create_symlink(target, folder / "second");
    game::note_time(some_level, 5);
    CHECK(fs::is_symlink(fs::symlink_status(link)));
    CHECK(fs::is_regular_file(fs::symlink_status(target)));
    CHECK(game::best_time(some_level).value() == 5);
    folder.file("synced/best.json", "{");
    CHECK(game::note_time(some_level, 6).set_aside.value() == target.string() + ".spoilt");
    CHECK(fs::is_symlink(fs::symlink_status(link)));
    CHECK(game::best_time(some_level).value() == 6);
}

TEST_CASE("links without end are told") {
    Folder const folder;
    std::filesystem::create_symlink("b", folder.path("a"));
    std::filesystem::create_symlink("a", folder.path("b"));
    CHECK(message_of([&] { game::write_whole_file(folder.path("a"), "x"); }).find(folder.path("a")) == 0);
}
