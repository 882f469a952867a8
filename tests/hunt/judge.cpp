#include "hunt/judge.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "game/session.h"
#include "hunt/dice.h"
#include "hunt/otherwise.h"
#include "hunt/witness.h"

namespace hunt {

namespace {

constexpr double rows_per_second = 60;
constexpr double busy_span = 0.1;                      // s
constexpr double most_in_span = 100'000 * busy_span;    // events
constexpr long long enough_events = 300'000;           // of a run that is given up
constexpr double enough_seconds = 10;                  // s of processor time, the same
constexpr double most_seconds = 0.5, most_row = 4e-3;  // s of processor time, for 12 s and for a sixtieth

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

using LevelRef = std::shared_ptr<level::Level const>;

game::Session session_of(LevelRef const& level, Sketch const& sketch, physics::Method const& method) {
    return game::session_of(level, method, sketch.inputs, "run.json");
}

struct Played {
    game::Session session;
    double end = 0;
    double seconds = 0, worst_row = 0, worst_time = 0;  // s
    bool handed_over = false, given_up = false;
};

bool is_out(level::Level const& level, Vec2 const& place) {
    Vec2 const off = (place - level.size / 2).cwiseAbs();
    return off.x() > level.size.x() || off.y() > level.size.y();
}

// As the window does it, a row each sixtieth, until the ball has fallen out.
Played played_in_rows(LevelRef const& level, Sketch const& sketch, physics::Method const& method) {
    Played played{session_of(level, sketch, method)};
    int const rows = static_cast<int>(std::ceil(sketch.duration * rows_per_second));
    for (int row = 1; row <= rows; ++row) {
        played.end = std::min(sketch.duration, row / rows_per_second);
        double const before = processor_time();
        game::advance(played.session, played.end);
        double const spent = processor_time() - before;
        played.seconds += spent;
        if (spent > played.worst_row) {
            played.worst_row = spent;
            played.worst_time = played.end;
        }
        played.handed_over = played.handed_over || played.session.world.handed_over;
        auto const events = static_cast<long long>(played.session.history.events.size());
        played.given_up = events > enough_events || played.seconds > enough_seconds;
        if (played.given_up || is_out(*level, physics::state_at(played.session.history, 0, played.end).position)) break;
    }
    return played;
}

// The times of events, and how many crowd.
void count(Played const& played, Verdict& verdict, Findings& findings) {
    auto const& events = played.session.history.events;
    verdict.events = static_cast<long long>(events.size());
    std::size_t first = 0;
    for (std::size_t last = 0; last < events.size(); ++last) {
        physics::Event const& event = events[last];
        if (event.kind == physics::EventKind::handover) findings.note(Wrong::handover, 0, event.time);
        while (events[first].time < event.time - busy_span) ++first;
        double const crowd = static_cast<double>(last - first + 1);
        verdict.busiest = std::max(verdict.busiest, crowd);
        if (crowd > most_in_span) findings.note(Wrong::crowd, crowd, event.time);
    }
    if (played.handed_over) findings.note(Wrong::handover, 0, played.end);
}

// Asked once for all, and at odd times: the same bits at the end.
void ask_otherwise(LevelRef const& level, Sketch const& sketch, Played const& played, physics::Method const& method,
                   Findings& findings) {
    game::Session once = session_of(level, sketch, method), oddly = session_of(level, sketch, method);
    game::advance(once, played.end);
    Dice dice(1);
    for (double time = 0; time < played.end; time += dice.scaled(1e-3, 1)) game::advance(oddly, time);
    game::advance(oddly, played.end);
    std::string const hash = game::state_hash(played.session, played.end);
    Vec2 const place = physics::state_at(played.session.history, 0, played.end).position;
    for (game::Session const* other : {&once, &oddly})
        if (game::state_hash(*other, played.end) != hash)
            findings.note(Wrong::rows,
                          geometry::length(physics::state_at(other->history, 0, played.end).position - place),
                          played.end);
}

// Taken twice where it seems slow: others use the machine too.
void time(LevelRef const& level, Sketch const& sketch, Played const& played, physics::Method const& method,
          Verdict& verdict, Findings& findings) {
    verdict.seconds = played.seconds;
    verdict.worst_row = played.worst_row;
    for (int again = 0; again < 2 && (verdict.seconds > most_seconds || verdict.worst_row > most_row); ++again) {
        Played const other = played_in_rows(level, sketch, method);
        verdict.seconds = std::min(verdict.seconds, other.seconds);
        verdict.worst_row = std::min(verdict.worst_row, other.worst_row);
    }
    if (verdict.seconds > most_seconds) findings.note(Wrong::slow, verdict.seconds, played.end);
    if (verdict.worst_row > most_row) findings.note(Wrong::stall, verdict.worst_row, played.worst_time);
}

}  // namespace

char const* name_of(Wrong wrong) {
    constexpr char const* names[] = {"refused", "no-end", "not-finite", "handover", "depth",
                                     "drawn",   "jump",   "energy",     "hover",    "held",
                                     "rows",    "crowd",  "otherwise",  "slow",     "stall"};
    return names[static_cast<int>(wrong)];
}

Verdict judged(Sketch const& sketch, physics::Method const& method, Clock clock) {
    Verdict verdict;
    Findings findings;
    try {
        auto const level = std::make_shared<level::Level const>(level_of(sketch));
        Played const played = played_in_rows(level, sketch, method);
        verdict.end = played.end;
        count(played, verdict, findings);
        look(sketch, played.session, played.end, limits_of(sketch, method), findings);
        if (!played.given_up) ask_otherwise(level, sketch, played, method, findings);
        bool const is_exact = std::holds_alternative<physics::Exact>(method);
        if (is_exact && !played.given_up)
            if (auto const finding = moves_otherwise(sketch))
                findings.note(finding->wrong, finding->measured, finding->time, finding->words);
        if (clock == Clock::judged) time(level, sketch, played, method, verdict, findings);
    } catch (std::runtime_error const& error) {
        findings.note(Wrong::refused, 0, 0, error.what());
    }
    verdict.findings = findings.by_weight();
    return verdict;
}

}  // namespace hunt
