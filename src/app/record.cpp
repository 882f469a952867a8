// smb2d record: a film with its sound, or the sound alone, without a display.
#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/filming.h"
#include "app/progress.h"
#include "app/soundtrack.h"
#include "screen/wav.h"

namespace app {

namespace {

enum class Container { film, sound };
Container container_of(FilmOptions const& options) {
    std::string const& file = options.sequence.output;
    std::string const ending = std::filesystem::path(file).extension().string();
    if (ending == ".wav" && options.no_sound) throw UsageError("--no-sound leaves nothing to write into a .wav file");
    if (ending == ".wav") return Container::sound;
    if (ending == ".mp4" || ending == ".mkv") return Container::film;
    throw UsageError("--output must end in .mp4, .mkv or .wav, got \"" + file + "\"");
}

// As long as the film of the same options.
void record_sound(Sequence& sequence, FilmOptions const& options) {
    double const seconds = time_of(sequence, sequence.count) - sequence.from.value();
    if (seconds * sound::rate > screen::most_wav_samples)
        throw UsageError("a .wav file holds at most " + std::to_string(screen::most_wav_samples / sound::rate) + " s");
    make_way_for(options.sequence.output, options.sequence.overwrite);
    screen::Wav wav(options.sequence.output, sound::rate);
    keep_what_is_left(wav, [&] {
        Progress progress(sequence.count, sequence.quiet ? Progress::Bar::never : Progress::Bar::on_terminal);
        Soundtrack soundtrack(sequence.session, sequence.from.value());
        for (long long frame = 1; frame <= sequence.count; ++frame) {
            wav.add(soundtrack.on_to(sequence.session, time_of(sequence, frame)));
            progress.show(frame);
        }
    });
}

int record(FilmOptions const& options) {
    Container const container = container_of(options);
    Sequence sequence = sequence_for(options.sequence);
    if (container == Container::film)
        write_film(sequence, options);
    else
        record_sound(sequence, options);
    expect_tolerance_kept(options.sequence.file, sequence.session);
    return done;
}

}  // namespace

Command record_command(CommandLine& program) {
    auto const options = std::make_shared<FilmOptions>();
    Subcommand command = program.add("record", "A film with its sound, no display needed");
    declare(command, options->sequence);
    command.needs("-o,--output", options->sequence.output, "demo.mp4, demo.mkv, or demo.wav for the sound alone",
                  "FILE");
    command.takes_flag("--no-sound", options->no_sound, "a silent film");
    command.ends_help_with("Example: smb2d record assets/levels/01-sunny-hills.svg -o demo.mp4 --to 5");
    return {command, [options] { return record(*options); }};
}

}  // namespace app
