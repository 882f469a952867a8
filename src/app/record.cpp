// smb2d record: a video, without a display.
#include <algorithm>
#include <climits>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/sequence.h"
#include "screen/video.h"

namespace app {

namespace {

int even(int side) { return side + side % 2; }

void expect_container(std::string const& file) {
    std::string const ending = std::filesystem::path(file).extension().string();
    if (ending != ".mp4" && ending != ".mkv")
        throw UsageError("--output must end in .mp4 or .mkv, got \"" + file + "\"");
}

void make_way_for(std::filesystem::path const& file, bool overwrite) {
    std::error_code error;
    if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(file, error)))
        throw std::runtime_error(file.string() + ": is there already; --overwrite replaces it");
    if (!file.has_parent_path()) return;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw std::runtime_error(file.parent_path().string() + ": " + error.message());
}

void round_up(Size& size, SequenceOptions const& options) {
    Size const rounded{even(size.width), even(size.height)};
    if (!options.quiet && (rounded.width != size.width || rounded.height != size.height))
        note("smb2d: video needs even sizes: " + std::to_string(rounded.width) + "x" + std::to_string(rounded.height));
    size = rounded;
}

screen::VideoSettings settings_for(Sequence const& sequence) {
    bool const is_whole = std::floor(sequence.rate.numerator) == sequence.rate.numerator;
    if (!is_whole || sequence.rate.numerator > INT_MAX || sequence.rate.denominator > INT_MAX)
        throw UsageError("--fps has too many digits for a video");
    screen::VideoSettings settings;
    settings.width = sequence.size.width;
    settings.height = sequence.size.height;
    settings.rate_numerator = static_cast<int>(sequence.rate.numerator);
    settings.rate_denominator = static_cast<int>(sequence.rate.denominator);
    return settings;
}

FrameJob craft_for(screen::Video& video, Size const& size) {
    FrameJob job;
    job.make = [](long long, screen::Pixels const& pixels) { return screen::yuv420_of(pixels).bytes; };
    job.deliver = [&video, size](std::vector<std::uint8_t> bytes) {
        video.add(screen::Yuv420{size.width, size.height, std::move(bytes)});
    };
    return job;
}

// What was recorded before a failure is named, unless the failure names it already.
std::string with_part(std::string const& what, screen::Video& video) {
    auto const part = video.abandon();
    if (!part || what.find(part->string()) != std::string::npos) return what;
    return what + "; what was recorded until then is in " + part->string();
}

int record(SequenceOptions const& options) {
    expect_container(options.output);
    Sequence sequence = sequence_for(options);
    round_up(sequence.size, options);
    screen::VideoSettings const settings = settings_for(sequence);
    make_way_for(options.output, options.overwrite);
    screen::Video video(options.output, settings);
    try {
        make_frames(sequence, craft_for(video, sequence.size));
        video.finish();
    } catch (Interrupted const& interruption) {
        throw Interrupted(with_part(interruption.what(), video));
    } catch (std::runtime_error const& error) {
        throw std::runtime_error(with_part(error.what(), video));
    }
    expect_tolerance_kept(options.file, sequence.session);
    return done;
}

}  // namespace

Command record_command(CommandLine& program) {
    auto const options = std::make_shared<SequenceOptions>();
    Subcommand command = program.add("record", "A video, no display needed");
    declare(command, *options);
    command.needs("-o,--output", options->output, "demo.mp4 or demo.mkv", "FILE");
    command.ends_help_with("Example: smb2d record assets/levels/01-sunny-hills.svg -o demo.mp4 --to 5");
    return {command, [options] { return record(*options); }};
}

}  // namespace app
