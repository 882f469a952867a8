#include "app/sequence.h"

#include <algorithm>
#include <thread>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/chunked_advance.h"
#include "app/frame_workers.h"

namespace app {

namespace {

constexpr double most_frames = 1e9;

int jobs_from(std::optional<std::string> const& text) {
    if (text) return static_cast<int>(whole_number_from("--jobs", *text, 1, 256));
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

view::Overlays overlays_in(std::string const& list) {
    if (list.empty()) return {};
    auto const overlays = view::overlays_from(list);
    if (!overlays) throw UsageError("--overlay must list figures, forces, energy, or be all, got \"" + list + "\"");
    return *overlays;
}

long long count_of(Sequence const& sequence, game::Fraction const& to, std::string const& rate) {
    double const seconds = to.value() - sequence.from.value();
    if (!(seconds > 0)) throw UsageError("there is nothing to show: --to must be greater than --from");
    if (seconds * sequence.rate.value() > most_frames)
        throw UsageError("--fps must make at most 1e9 frames of the time from --from to --to, got \"" + rate + "\"");
    return game::frames_between(sequence.from, to, sequence.rate);
}

FrameOrder order_for(Sequence& sequence, long long frame) {
    game::Session& session = sequence.session;
    double const time = game::frame_time(sequence.from, frame, sequence.rate);
    advance_in_chunks(session, time, view::camera_memory);
    game::forget_before(session, std::max(0.0, time - view::camera_memory));
    FrameOrder order;
    order.frame = frame;
    order.moment = view::moment_of(session, time, view::recall_for(sequence.overlays));
    geometry::Vec2 const size(sequence.size.width, sequence.size.height);
    order.camera = view::camera_of(session, time, size, sequence.turning);
    return order;
}

}  // namespace

void declare(Subcommand& command, SequenceOptions& options) {
    command.needs("file", options.file, "a level (.svg) or a run (.json)", "LEVEL|RUN");
    declare(command, options.method);
    command.takes("-r,--fps", options.rate, "frames a second (default: 60)", "F");
    command.takes("-s,--size", options.size, "pixels (default: 1280x720)", "WxH");
    command.takes("--from", options.from, "the first frame's time (default: 0)", "S");
    command.takes("--to", options.to, "the end (default: the run's duration, else 10)", "S");
    command.takes("--overlay", options.overlay, "figures, forces, energy, with commas, or all", "LIST");
    command.takes_flag("--no-turn", options.no_turn, "the picture does not turn as the stage is tilted");
    command.takes("--jobs", options.jobs, "threads that paint (default: one a core)", "N");
    command.takes_flag("--overwrite", options.overwrite, "replace files that are there already");
    command.takes_flag("-q,--quiet", options.quiet, "neither progress nor notes");
}

Sequence sequence_for(SequenceOptions const& options) {
    Sequence sequence;
    game::MethodWish const wish = wish_from(options.method);
    sequence.size = size_from(options.size);
    sequence.overlays = overlays_in(options.overlay);
    sequence.from = time_from("--from", options.from);
    sequence.rate = positive_fraction_from("--fps", options.rate);
    sequence.quiet = options.quiet;
    if (options.no_turn) sequence.turning = view::Turning::never;
    int const jobs = jobs_from(options.jobs);
    std::optional<game::Fraction> to;
    if (options.to) to = time_from("--to", *options.to);
    if (to) count_of(sequence, *to, options.rate);
    Opened const opening = opened(options.file);
    if (!options.quiet) {
        note_changed_level(opening);
        note_misspellings(*opening.level);
        note_choice(opening, wish);
    }
    sequence.session = watched_session_for(opening, wish);
    sequence.count = count_of(sequence, to ? *to : duration_of(opening.run), options.rate);
    sequence.jobs = static_cast<int>(std::min<long long>(jobs, sequence.count));
    sequence.stage = view::stage_of(opening.level);
    return sequence;
}

void make_frames(Sequence& sequence, FrameJob const& job) {
    Progress progress(sequence.count, sequence.quiet ? Progress::Bar::never : Progress::Bar::on_terminal);
    FrameWorkers frame_workers(sequence.stage, sequence.overlays, job, sequence.jobs);
    for (long long frame = 0; frame < sequence.count; ++frame) {
        stop_if_interrupted();
        FrameOrder order = order_for(sequence, frame);
        if (job.order) job.order(frame);
        frame_workers.take(std::move(order));
        progress.show(frame_workers.finished());
    }
    frame_workers.close();
    while (frame_workers.finished() < sequence.count) {
        frame_workers.wait_a_little();
        progress.show(frame_workers.finished());
    }
}

}  // namespace app
