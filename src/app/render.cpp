// smb2d render: a sequence of pictures, without a display.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/command.h"
#include "app/frame_names.h"
#include "app/output.h"
#include "app/sequence.h"
#include "screen/png.h"

namespace app {

namespace {

struct RenderOptions {
    SequenceOptions sequence;
    std::string start_number = "0";
};

void expect_png(std::string const& pattern) {
    std::string ending = std::filesystem::path(pattern).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending != ".png")
        throw UsageError("--output must end in .png, or be - for raw frames, got \"" + pattern + "\"");
}

[[noreturn]] void refuse_to_replace(std::string const& name) {
    throw std::runtime_error(name + ": is there already; --overwrite replaces it");
}

void expect_unused(std::string const& name) {
    std::error_code error;
    if (std::filesystem::exists(std::filesystem::symlink_status(name, error))) refuse_to_replace(name);
}

// All names of the sequence are looked at before the first is written: by what lies in their folder, since there may
// be millions of them.
void expect_unused(FrameNames const& names, long long first, long long count) {
    if (!names.has_number()) return expect_unused(names.name_of(first));
    if (names.numbers_folders()) {
        for (long long i = 0; i < count; ++i) expect_unused(names.name_of(first + i));
        return;
    }
    std::filesystem::path const folder = std::filesystem::path(names.name_of(first)).parent_path();
    std::error_code missing;
    std::optional<long long> least;
    for (auto const& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, missing)) {
        auto const number = names.number_in(entry.path().filename().string());
        if (number && *number >= first && *number < first + count && (!least || *number < *least)) least = number;
    }
    if (least) refuse_to_replace(names.name_of(*least));
}

void make_folder_of(std::filesystem::path const& file) {
    if (!file.has_parent_path()) return;
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw std::runtime_error(file.parent_path().string() + ": " + error.message());
}

void render_files(RenderOptions const& options, Sequence& sequence, FrameNames const& names, long long first) {
    if (!names.has_number() && sequence.count > 1)
        throw UsageError("--output needs a number such as %05d for " + std::to_string(sequence.count) + " frames");
    if (!options.sequence.overwrite) expect_unused(names, first, sequence.count);
    FrameJob job;
    job.make = [&](long long frame, screen::Pixels const& pixels) -> std::vector<std::uint8_t> {
        std::string const name = names.name_of(first + frame);
        make_folder_of(name);
        screen::write_png(name, pixels);
        return {};
    };
    make_frames(sequence, job);
}

std::vector<std::uint8_t> rgb_of(screen::Pixels const& pixels) {
    std::vector<std::uint8_t> rgb(pixels.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgb.size() / 3; ++i)
        std::copy_n(pixels.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                    rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
    return rgb;
}

void render_raw(Sequence& sequence) {
    FrameJob job;
    job.make = [](long long, screen::Pixels const& pixels) { return rgb_of(pixels); };
    job.deliver = [](std::vector<std::uint8_t> const& rgb) {
        write_to_stdout({reinterpret_cast<char const*>(rgb.data()), rgb.size()});
    };
    make_frames(sequence, job);
}

int render(RenderOptions const& options) {
    long long const first = whole_number_from("--start-number", options.start_number, 0, 1'000'000'000'000);
    bool const raw = options.sequence.output == "-";
    FrameNames const names(options.sequence.output);
    if (!raw) expect_png(options.sequence.output);
    Sequence sequence = sequence_for(options.sequence);
    if (raw)
        render_raw(sequence);
    else
        render_files(options, sequence, names, first);
    expect_tolerance_kept(options.sequence.file, sequence.session);
    return done;
}

}  // namespace

Command render_command(CommandLine& program) {
    auto const options = std::make_shared<RenderOptions>();
    Subcommand command = program.add("render", "A sequence of pictures (PNG), no display needed");
    declare(command, options->sequence);
    command.needs("-o,--output", options->sequence.output, "frames/%05d.png, or - for raw RGB24 on stdout", "PATTERN");
    command.takes("--start-number", options->start_number, "the first file's number (default: 0)", "N");
    command.ends_help_with("Example: smb2d render assets/levels/01-sunny-hills.svg -o frames/%05d.png --to 5");
    return {command, [options] { return render(*options); }};
}

}  // namespace app
