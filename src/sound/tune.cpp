#include "sound/tune.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "geometry/elementary.h"
#include "sound/timbre.h"

namespace sound {

namespace {

// A voice's part: one letter a step; 1 to 9 and a to f are steps of the scale, from the root up, a dot is none.
struct Part {
    Timbre timbre;
    int octave;       // above the root's
    double loudness;  // of 1
    double pan;
    double echo;  // of the loudness, of a second one three steps later at the other side; 0 = none
    std::string_view steps;
};

struct Tune {
    int root;                  // MIDI
    std::array<int, 7> scale;  // semitones above the root
    int step;                  // samples
    std::array<Part, 4> parts;
};

// Bars of eight steps. Parts may be of different lengths, each of which divides the longest.
constexpr Tune meadow{60,
                      {0, 2, 4, 5, 7, 9, 11},
                      14400,
                      {{{Timbre::kalimba, 1, 0.075, 0.15, 0.25,
                         "5..3..5.6..5..3.4.6.8.6.5...2..."
                         "5..3..5.7..5..3.4.6.5.7.8......."
                         "8.6.3.6.7.5.3.5.6.4.1.4.5.3...3."
                         "4.4.6.8.7.5.2.5.6.4.5.2.1......."},
                        {Timbre::kalimba, 0, 0.035, -0.3, 0,
                         ".3.5.8.5.3.6.8.6.4.6.8.6.2.5.7.5"
                         ".3.5.8.5.3.5.7.5.4.6.2.5.3.5.8.5"
                         ".3.6.8.6.3.5.7.5.4.6.8.6.3.5.8.5"
                         ".4.6.8.6.2.5.7.5.4.6.2.5.1.3.5.."},
                        {Timbre::bass, -2, 0.085, 0, 0,
                         "1...5...6...a...4...8...5...9..."
                         "1...5...3...7...4...5...1......."
                         "6...a...3...7...4...8...1...5..."
                         "4...8...5...9...4...5...1...5..."},
                        {Timbre::pad, 0, 0.018, 0.1, 0,
                         "1.......1.......1.......2......."
                         "1.......3.......4.......1......."
                         "1.......3.......1.......1......."
                         "4.......2.......4.......1......."}}}};
constexpr Tune desert{62,
                      {0, 1, 4, 5, 7, 8, 10},
                      17000,
                      {{{Timbre::oud, 0, 0.07, -0.1, 0.2,
                         "1..2.3..3.4.3.2.1.......5..6.5.4"
                         "3..4.3.2.3......4.3.2.1.1......."
                         "8..7.6.55.6.5.4.5.......6..5.4.3"
                         "4..3.2.12.3.....4.3.2.1.1......."},
                        {Timbre::drum, -2, 0.075, 0.2, 0, "1..1..1.1..11.1."},
                        {Timbre::bass, -2, 0.075, 0, 0, "1.......1.......1.....5.1......."},
                        {Timbre::pad, -1, 0.026, 0, 0, "1.......5......."}}}};
constexpr Tune ice{64,
                   {0, 2, 4, 6, 7, 9, 11},
                   19200,
                   {{{Timbre::celesta, 1, 0.055, 0.2, 0.4,
                      "5...3...2...5...7...5...4......."
                      "8...7...5...4...3...2...1......."
                      "3.5.9...8...7.5.6...4...5......."
                      "6.5.4...3...2...1...2...1......."},
                     {Timbre::celesta, 0, 0.022, -0.35, 0,
                      "1.3.5.8.9.8.5.3.1.3.5.7.9.7.5.3."
                      "6.8.a.8.2.4.6.9.1.3.5.8.9.8.5.3."},
                     {Timbre::bass, -2, 0.06, 0, 0,
                      "1...............3..............."
                      "6.......2.......1..............."},
                     {Timbre::pad, 0, 0.028, -0.1, 0,
                      "1.......5.......3.......7......."
                      "1.......2.......3.......5......."}}}};
constexpr Tune night{57,
                     {0, 2, 3, 5, 7, 9, 10},
                     24000,
                     {{{Timbre::vibraphone, 1, 0.055, 0.2, 0.3,
                        "5.....3.4...5...7.....5.6......."
                        "5.....4.3...1...2.....3.1......."
                        "8.....7.5...3...4.....5.6......."
                        "5.....3.2...4...3.....2.1......."},
                       {Timbre::kalimba, 0, 0.022, -0.35, 0.4, "..5...8.....6...8...5.....7...9."},
                       {Timbre::bass, -1, 0.06, 0, 0, "1.......4.......1.......7......."},
                       {Timbre::pad, 0, 0.034, 0, 0, "3...1...4...6...5...3...7...2..."}}}};
constexpr std::array<Tune, 4> tunes{meadow, desert, ice, night};

Tune const& tune_of(World world) { return tunes[static_cast<std::size_t>(world)]; }

// Every part's length divides that of the first.
constexpr bool all_divide() {
    for (Tune const& tune : tunes)
        for (Part const& part : tune.parts)
            if (part.steps.empty() || tune.parts[0].steps.size() % part.steps.size() != 0) return false;
    return true;
}
static_assert(all_divide());

constexpr int echo_after = 3;         // steps
constexpr double longest_ring = 5.1;  // s, of a tune's note
constexpr double fading_in = 1;       // s, at the beginning of the first loop

int scale_step_of(char letter) { return letter <= '9' ? letter - '1' : letter - 'a' + 9; }

std::size_t letter_at(Part const& part, long long step) {
    return static_cast<std::size_t>(step % static_cast<long long>(part.steps.size()));
}

// The first step of a bar is a little louder, those off the beat softer.
double accent_of(long long step) { return step % 8 == 0 ? 1.1 : step % 2 == 0 ? 1 : 0.8; }

template <typename Visit>
void each_note(Playing const& tune, long long first, long long last, Visit visit) {
    Tune const& sheet = tune_of(tune.world);
    long long const from = std::max(0LL, first - tune.since);
    auto const tell = [&](Part const& part, long long step, long long shown, double loudness, double pan) {
        char const letter = part.steps[letter_at(part, step)];
        if (letter == '.') return;
        double const rise = std::min(1.0, static_cast<double>(shown) * sheet.step / (fading_in * rate) + 0.2);
        int const scale_step = scale_step_of(letter) + 7 * part.octave;
        visit(Note{tune.since + shown * sheet.step, part.timbre, pitch_in(tune.world, scale_step),
                   loudness * accent_of(step) * rise, 1, pan});
    };
    for (long long step = (from + sheet.step - 1) / sheet.step; tune.since + step * sheet.step < last; ++step)
        for (Part const& part : sheet.parts) {
            tell(part, step, step, part.loudness, part.pan);
            if (part.echo > 0 && step >= echo_after)
                tell(part, step - echo_after, step, part.loudness * part.echo, -part.pan);
        }
}

}  // namespace

long long loop_of(World world) {
    Tune const& sheet = tune_of(world);
    return static_cast<long long>(sheet.parts[0].steps.size()) * sheet.step;
}

double pitch_in(World world, int step) {
    Tune const& sheet = tune_of(world);
    int const octave = step >= 0 ? step / 7 : -((6 - step) / 7);
    int const semitones = sheet.root - 69 + 12 * octave + sheet.scale[static_cast<std::size_t>(step - 7 * octave)];
    double const ln_2 = geometry::logarithm(2);
    return 440 * geometry::exponential(ln_2 / 12 * semitones);
}

std::vector<Note> tune_notes(Playing const& tune, long long first, long long last) {
    std::vector<Note> notes;
    each_note(tune, first, last, [&](Note const& note) { notes.push_back(note); });
    return notes;
}

void add_tune(Playing const& tune, long long first, int count, double* left, double* right) {
    auto const ring = static_cast<long long>(longest_ring * rate);
    each_note(tune, first - ring, first + count, [&](Note const& note) { add_note(note, first, count, left, right); });
}

}  // namespace sound
