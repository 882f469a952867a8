#include <csignal>
#include <fstream>

#include <sys/resource.h>

#include <doctest/doctest.h>

#include "screen/folder.h"
#include "screen/png.h"
#include "screen/samples.h"

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
    Folder const folder;
    for (auto const& picture :
         {samples::balls(), samples::plain(1, 1, samples::red), samples::plain(3, 200, samples::blue)}) {
        auto const pixels = samples::painted(picture);
        screen::write_png(folder / "a.png", pixels);
        auto const back = screen::read_png(folder / "a.png");
        CHECK(back.width == pixels.width);
        CHECK(back.height == pixels.height);
        CHECK(back.rgba == pixels.rgba);
    }
}

TEST_CASE("the same picture is the same file, and replaces what was there") {
    Folder const folder;
    auto const pixels = samples::painted(samples::shapes());
    CHECK(screen::png_of(pixels) == screen::png_of(pixels));
    std::ofstream(folder / "a.png") << "something else, and longer than nothing";
    screen::write_png(folder / "a.png", pixels);
    CHECK(screen::read_png(folder / "a.png").rgba == pixels.rgba);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a disk that fills up is told with the file's name, and leaves nothing behind") {
    Folder const folder;
    auto const pixels = samples::painted(samples::balls());
    {
        FullDisk const full(1000);
        CHECK_THROWS_WITH_AS(screen::write_png(folder / "frame.png", pixels),
                             doctest::Contains("frame.png: File too large"), std::runtime_error);
    }
    CHECK(folder.is_empty());
}

TEST_CASE("what was whole before a failure stays") {
    Folder const folder;
    auto const pixels = samples::painted(samples::balls());
    screen::write_png(folder / "frame.png", pixels);
    {
        FullDisk const full(1000);
        CHECK_THROWS_AS(screen::write_png(folder / "frame.png", pixels), std::runtime_error);
    }
    CHECK(screen::read_png(folder / "frame.png").rgba == pixels.rgba);
}

TEST_CASE("a folder that is not there and a file that is no PNG are told with the name") {
    Folder const folder;
    auto const pixels = samples::painted(samples::plain(2, 2, samples::red));
    CHECK_THROWS_WITH_AS(screen::write_png(folder / "none/a.png", pixels),
                         doctest::Contains("none/a.png: No such file"), std::runtime_error);
    CHECK_THROWS_WITH_AS(screen::read_png(folder / "a.png"), doctest::Contains("a.png: No such file"),
                         std::runtime_error);
    std::ofstream(folder / "text.png") << "hello";
    CHECK_THROWS_WITH_AS(screen::read_png(folder / "text.png"), doctest::Contains("text.png: "), std::runtime_error);
}
