#include <csignal>

#include <sys/resource.h>

#include <doctest/doctest.h>

#include "game/whole_file.h"
#include "screen/png.h"
#include "screen/samples.h"
#include "support/folder.h"

namespace {

// While it lives, no file may grow beyond a few bytes: a full disk that needs no disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : before_action_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, before_action_);
    }
    FullDisk(FullDisk const&) = delete;
    FullDisk& operator=(FullDisk const&) = delete;

private:
    rlimit before_{};
    void (*before_action_)(int);
};

}  // namespace

TEST_CASE("a picture comes back from its PNG file as it was, opaque") {
    support::Folder const folder;
    for (auto const& picture :
         {samples::balls(), samples::plain(1, 1, samples::red), samples::plain(3, 200, samples::blue)}) {
        auto const pixels = samples::painted(picture);
        screen::write_png(folder / "a.png", pixels);
        auto const back = samples::read_png(folder / "a.png");
        CHECK(back.width == pixels.width);
        CHECK(back.height == pixels.height);
        CHECK(back.rgba == pixels.rgba);
    }
}

TEST_CASE("the same picture is the same file, and replaces what was there") {
    support::Folder const folder;
    auto const pixels = samples::painted(samples::shapes());
    folder.file("a.png", "something else, and longer than nothing");
    for (char const* name : {"a.png", "b.png"}) screen::write_png(folder / name, pixels);
    CHECK(samples::read_png(folder / "a.png").rgba == pixels.rgba);
    CHECK(game::read_whole_file(folder.path("a.png"), 1 << 20) == game::read_whole_file(folder.path("b.png"), 1 << 20));
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 2);
}

TEST_CASE("a disk that fills up is told with the file's name, and leaves nothing behind") {
    support::Folder const folder;
    auto const pixels = samples::painted(samples::balls());
    {
        FullDisk const full(1000);
        CHECK_THROWS_WITH_AS(screen::write_png(folder / "frame.png", pixels),
                             doctest::Contains("frame.png: File too large"), std::runtime_error);
    }
    CHECK(folder.is_empty());
}

TEST_CASE("what was whole before a failure stays") {
    support::Folder const folder;
    auto const pixels = samples::painted(samples::balls());
    screen::write_png(folder / "frame.png", pixels);
    {
        FullDisk const full(1000);
        CHECK_THROWS_AS(screen::write_png(folder / "frame.png", pixels), std::runtime_error);
    }
    CHECK(samples::read_png(folder / "frame.png").rgba == pixels.rgba);
}

TEST_CASE("a folder that is not there is told with the name") {
    support::Folder const folder;
    auto const pixels = samples::painted(samples::plain(2, 2, samples::red));
    CHECK_THROWS_WITH_AS(screen::write_png(folder / "none/a.png", pixels),
                         doctest::Contains("none/a.png: No such file"), std::runtime_error);
}
