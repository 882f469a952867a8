// smb2d simulate: numbers on standard output, a row for every ball at every time, or for every event.
#include <algorithm>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/opening.h"
#include "app/options.h"
#include "app/chunked_advance.h"
#include "app/trace.h"

namespace app {

namespace {

struct SimulateOptions {
    std::string file;
    MethodOptions method;
    std::optional<std::string> to;
    std::string every = "1/60";
    bool events = false;
    std::string format = "csv";
};

constexpr double most_rows = 1e9;

void expect_few_rows(SimulateOptions const& options, game::Fraction const& every, game::Fraction const& to) {
    if (!options.events && to.value() / every.value() > most_rows)
        throw UsageError("--every must make at most 1e9 rows until --to, got \"" + options.every + "\"");
}

void print_rows(game::Session& session, game::Fraction const& every, double to, Trace& trace) {
    trace.header(Trace::Rows::times);
    for (long long i = 0;; ++i) {
        double const time = game::multiple(i, every);
        if (!(time <= to)) break;
        advance_in_chunks(session, time);
        trace.add_balls(session, time);
        game::forget_before(session, time);
    }
    trace.flush();
}

// Every event up to `to`, taken out of the history once it is printed.
void print_known_events(game::Session& session, double to, Trace& trace) {
    auto& events = session.history.events;
    for (; !events.empty() && events.front().time <= to; events.pop_front()) trace.add_event(session, events.front());
}

constexpr double events_stretch = 0.25;  // s, after which the events so far are printed

void print_events(game::Session& session, double to, Trace& trace) {
    trace.header(Trace::Rows::events);
    for (double time = 0; time < to;) {
        time = std::min(time + events_stretch, to);
        stop_if_interrupted();
        game::advance(session, time);
        print_known_events(session, std::min(session.world.time, to), trace);
        game::forget_before(session, time);
    }
    game::advance(session, to);
    print_known_events(session, to, trace);
    trace.flush();
}

int simulate(SimulateOptions const& options) {
    game::MethodWish const wish = wish_from(options.method);
    game::Fraction const every = positive_fraction_from("--every", options.every);
    std::optional<game::Fraction> to;
    if (options.to) to = time_from("--to", *options.to);
    if (to) expect_few_rows(options, every, *to);
    if (options.format != "csv" && options.format != "json")
        throw UsageError("--format must be csv or json, got \"" + options.format + "\"");
    Opened const opening = opened(options.file);
    note_changed_level(opening);
    note_misspellings(*opening.level);
    note_choice(opening, wish);
    game::Session session = watched_session_for(opening, wish);
    game::Fraction const end = to ? *to : duration_of(opening.run);
    expect_few_rows(options, every, end);
    Trace trace(options.format == "json" ? Trace::Format::json : Trace::Format::csv);
    if (options.events)
        print_events(session, end.value(), trace);
    else
        print_rows(session, every, end.value(), trace);
    expect_tolerance_kept(options.file, session);
    return done;
}

}  // namespace

Command simulate_command(CommandLine& program) {
    auto const options = std::make_shared<SimulateOptions>();
    Subcommand command = program.add("simulate", "Numbers on standard output, no picture, no display");
    command.needs("file", options->file, "a level (.svg) or a run (.json)", "LEVEL|RUN");
    declare(command, options->method);
    command.takes("--to", options->to, "until this time (default: the run's duration, else 10)", "S");
    command.takes("--every", options->every, "a row every so often, such as 0.01 or 1/24 (default: 1/60)", "S");
    command.takes_flag("--events", options->events, "a row for every event in place of a row every so often");
    command.takes("--format", options->format, "csv or json (default: csv)", "NAME");
    command.ends_help_with("Example: smb2d simulate assets/lab/ramp.svg --to 2 --every 1/24");
    return {command, [options] { return simulate(*options); }};
}

}  // namespace app
