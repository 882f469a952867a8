#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <doctest/doctest.h>

#include "screen/film.h"
#include "support/folder.h"
#include "screen/offscreen.h"
#include "screen/samples.h"
#include "screen/video.h"

namespace {

namespace fs = std::filesystem;
using screen::Video;

std::string output_of(std::string const& command) {
    std::string text;
    std::FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe);
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
    pclose(pipe);
    return text;
}

std::string probed(fs::path const& file, std::string const& entry) {
    std::string text = output_of("ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + entry +
                                 " -of csv=p=0 '" + file.string() + "'");
    while (!text.empty() && (text.back() == '\n' || text.back() == ',')) text.pop_back();
    return text;
}

// PATH with another ffmpeg in it, for as long as it lives.
class OtherFfmpeg {
public:
    explicit OtherFfmpeg(std::string const& script) {
        if (!script.empty())
            fs::permissions(folder_.file("ffmpeg", "#!/bin/sh\n" + script + "\n"), fs::perms::owner_all);
    }

private:
    support::Folder folder_;
    support::Variable path_{"PATH", folder_.path().string()};
};

screen::VideoSettings small() { return {64, 48, 30, 1, 18}; }

screen::Pixels grey() { return samples::painted(samples::plain(64, 48, {0.5F, 0.5F, 0.5F, 1})); }

std::vector<screen::Pixels> moving(int count) {
    screen::Offscreen offscreen;
    std::vector<screen::Pixels> frames;
    for (int i = 0; i < count; ++i) {
        float const part = static_cast<float>(i) / static_cast<float>(count);
        frames.push_back(offscreen.paint(samples::plain(64, 48, {part, 1 - part, 0.5F, 1})));
    }
    return frames;
}

void record(fs::path const& file, int frames, screen::VideoSettings const& settings = small()) {
    auto const frame = grey();
    Video video(file, settings);
    for (int i = 0; i < frames; ++i) video.add(frame);
    CHECK(video.frames() == frames);
    video.finish();
}

// What is said when three frames are given to an ffmpeg that is the script.
std::string complaint(std::string const& script, fs::path const& file) {
    OtherFfmpeg const other(script);
    return support::message_of([&] { record(file, 3); });
}

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("grey has no chroma, white and black are the ends of the limited range") {
    auto const of = [](view::Colour const& colour) {
        return screen::yuv420_of(samples::painted(samples::plain(2, 2, colour))).bytes;
    };
    CHECK(of(samples::black) == std::vector<std::uint8_t>{16, 16, 16, 16, 128, 128});
    CHECK(of(samples::white) == std::vector<std::uint8_t>{235, 235, 235, 235, 128, 128});
    // BT.709: Y = 16 + 219 * 0.2126; Cb = 128 - 224 * 0.2126 / 1.8556; Cr = 128 + 112.
    CHECK(of(samples::red) == std::vector<std::uint8_t>{63, 63, 63, 63, 102, 240});
    // Y = 16 + 219 * 0.0722; Cb = 128 + 112; Cr = 128 - 224 * 0.0722 / 1.5748.
    CHECK(of(samples::blue) == std::vector<std::uint8_t>{32, 32, 32, 32, 240, 118});
}

TEST_CASE("a video holds every frame, at its rate, with its colours told") {
    support::Folder const folder;
    for (std::string const name : {"demo.mp4", "demo.mkv"}) {
        record(folder / name, 37);
        CHECK(probed(folder / name, "nb_read_frames") == "37");
        CHECK(probed(folder / name, "r_frame_rate") == "30/1");
        CHECK(probed(folder / name, "width,height,pix_fmt") == "64,48,yuv420p");
        CHECK(probed(folder / name, "color_range,color_space,color_transfer,color_primaries") ==
              "tv,bt709,bt709,bt709");
        CHECK_FALSE(fs::exists(screen::part_name(folder / name)));
    }
}

TEST_CASE("a player shows the colours that were painted") {
    support::Folder const folder;
    for (view::Colour const colour :
         {view::Colour{0.30F, 0.62F, 0.95F, 1}, {0.9F, 0.2F, 0.1F, 1}, {0.2F, 0.6F, 0.2F, 1}}) {
        auto const frame = samples::painted(samples::plain(64, 48, colour));
        {
            Video video(folder / "a.mp4", small());
            video.add(frame);
            video.finish();
        }
        std::string const rgb = output_of("ffmpeg -v error -i '" + (folder / "a.mp4").string() +
                                          "' -frames:v 1 -f rawvideo -pix_fmt rgb24 -");
        REQUIRE(rgb.size() == 64 * 48 * 3);
        std::size_t const middle = 24 * 64 + 32;
        for (std::size_t c = 0; c < 3; ++c) {
            int const shown = static_cast<unsigned char>(rgb[3 * middle + c]);
            // Limited range and two roundings cost a level each way; the encoder at this quality another.
            CHECK(std::abs(shown - frame.rgba[4 * middle + c]) <= 3);
        }
    }
}

TEST_CASE("a fraction of a frame a second is kept as it was given") {
    support::Folder const folder;
    record(folder / "a.mkv", 5, {64, 48, 30000, 1001, 18});
    CHECK(probed(folder / "a.mkv", "r_frame_rate") == "30000/1001");
}

TEST_CASE("a missing ffmpeg is told, with the package that has it") {
    support::Folder const folder;
    std::string const said = complaint("", folder / "demo.mp4");
    CHECK(has(said, "demo.mp4: ffmpeg cannot be started: No such file"));
    CHECK(has(said, "package ffmpeg"));
    CHECK(folder.is_empty());
}

TEST_CASE("an ffmpeg that fails at once is told in its own last words") {
    support::Folder const folder;
    std::string const said =
        complaint("echo 'first words' >&2; echo \"Unknown encoder 'libx264'\" >&2; exit 1", folder / "demo.mp4");
    CHECK(has(said, "demo.mp4: ffmpeg ended with status 1: Unknown encoder 'libx264'"));
    CHECK(folder.is_empty());
}

TEST_CASE("an ffmpeg that is killed is told with the signal") {
    support::Folder const folder;
    CHECK(has(complaint("kill -9 $$", folder / "demo.mp4"), "ffmpeg was ended by signal 9"));
    CHECK_FALSE(fs::exists(folder / "demo.mp4"));
}

TEST_CASE("an ffmpeg that ends well but early is found out by counting") {
    support::Folder const folder;
    CHECK(has(complaint("while read -r line; do :; done; echo frame=2", folder / "demo.mp4"), "wrote 2 of 3 frames"));
    CHECK(complaint("exit 0", folder / "demo.mp4") != "nothing was thrown");
    CHECK_FALSE(fs::exists(folder / "demo.mp4"));
}

TEST_CASE("what is whole of a film is counted, wherever it is cut") {
    support::Folder const folder;
    for (std::string const name : {"a.mp4", "a.mkv"}) {
        CAPTURE(name);
        Video video(folder / name, small());
        for (auto const& frame : moving(100)) video.add(frame);
        video.finish();
        screen::Film const whole = screen::film_in(folder / name);
        CHECK(whole.frames == 100);
        CHECK(whole.complete);
        auto const size = fs::file_size(folder / name);
        CHECK(whole.whole_bytes < size);
        fs::path const cut = folder / ("cut-" + name);
        for (auto const length : {size - 1, whole.whole_bytes, whole.whole_bytes - 1, size / 2, size / 4}) {
            CAPTURE(length);
            fs::copy_file(folder / name, cut, fs::copy_options::overwrite_existing);
            fs::resize_file(cut, length);
            screen::Film const film = screen::film_in(cut);
            CHECK_FALSE(film.complete);
            CHECK(film.whole_bytes <= length);
            CHECK((film.frames == 100) == (length >= whole.whole_bytes));
            if (film.frames == 0) continue;
            fs::resize_file(cut, film.whole_bytes);
            CHECK(probed(cut, "nb_read_frames") == std::to_string(film.frames));
        }
    }
}

TEST_CASE("what is no film has no frames") {
    support::Folder const folder;
    for (std::string const name : {"a.mp4", "a.mkv"}) {
        CHECK(screen::film_in(folder / name).frames == 0);
        for (std::string const& bytes :
             {std::string(), std::string("a"), std::string(1000, '\xff'), std::string(1000, '\0')}) {
            std::ofstream(folder / name) << bytes;
            CHECK(screen::film_in(folder / name).frames == 0);
            CHECK_FALSE(screen::film_in(folder / name).complete);
        }
    }
}

TEST_CASE("an ffmpeg that says that all is well of a film that is cut is found out") {
    support::Folder const folder;
    std::string const script =
        "PATH=/usr/local/bin:/usr/bin:/bin; for last; do :; done; ffmpeg \"$@\"; truncate -s -200 \"${last#file:}\"; "
        "exit 0";
    for (std::string const name : {"demo.mp4", "demo.mkv"}) {
        CHECK(has(complaint(script, folder / name), name + ": the file is not whole, with 0 of 3 frames"));
        CHECK(folder.is_empty());
    }
}

TEST_CASE("a part that does not play is not left") {
    support::Folder const folder;
    std::string const script = "for last; do :; done; printf 'no film' > \"${last#file:}\"; ";
    for (std::string const end : {"kill -9 $$", "exit 1", "exit 0"}) {
        CHECK(complaint(script + end, folder / "demo.mp4") != "nothing was thrown");
        CHECK(folder.is_empty());
    }
}

TEST_CASE("an ffmpeg that talks without end does not block") {
    support::Folder const folder;
    std::string const talk =
        "i=0; while [ $i -lt 3000 ]; do echo 'many words of warning, again and again' >&2; i=$((i+1)); done; exit 1";
    CHECK(has(complaint(talk, folder / "demo.mp4"), "again and again"));
}

TEST_CASE("a video that is cut short plays as far as it goes") {
    support::Folder const folder;
    auto const frame = grey();
    {
        Video video(folder / "demo.mp4", small());
        for (int i = 0; i < 40; ++i) video.add(frame);
    }
    CHECK_FALSE(fs::exists(folder / "demo.mp4"));
    CHECK(probed(folder / "demo.part.mp4", "nb_read_frames") == "40");
}

TEST_CASE("a video without a frame leaves no part behind") {
    support::Folder const folder;
    { Video const video(folder / "demo.mp4", small()); }
    CHECK(folder.is_empty());
}

TEST_CASE("a folder that is not there is told, and so are odd sizes and unknown endings") {
    support::Folder const folder;
    auto const attempt = [&](std::string const& name, screen::VideoSettings const& settings) {
        record(folder / name, 1, settings);
    };
    CHECK_THROWS_WITH_AS(attempt("none/a.mp4", small()), doctest::Contains("No such file"), std::runtime_error);
    CHECK_THROWS_WITH_AS(attempt("a.avi", small()), doctest::Contains("a.avi: a video's name must end in"),
                         std::runtime_error);
    CHECK_THROWS_WITH_AS(attempt("a.mp4", {63, 48, 30, 1, 18}), doctest::Contains("even"), std::runtime_error);
    CHECK_THROWS_WITH_AS(attempt("a.mp4", {62, 48, 30, 1, 18}), doctest::Contains("another size"), std::runtime_error);
}

TEST_CASE("a broken pipe leaves the program's own signal handling alone") {
    support::Folder const folder;
    CHECK(complaint("exit 1", folder / "a.mp4") != "nothing was thrown");
    struct sigaction action {};
    sigaction(SIGPIPE, nullptr, &action);
    CHECK((action.sa_handler == SIG_DFL));
    sigset_t blocked;
    pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    CHECK_FALSE(sigismember(&blocked, SIGPIPE));
}
