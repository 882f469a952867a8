#include "sound/timbre.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/elementary.h"

namespace sound {

namespace {

constexpr double two_pi = 2 * geometry::pi;
constexpr double unheard = 1e-5;        // of a note's loudness: a partial below is left out
constexpr double released_share = 0.2;  // of a note's length, over which it ends

// Bars and plates ring at 1 : 2.76 : 5.40 and the like (Fletcher and Rossing, "The Physics of Musical
// Instruments", 2.15).
constexpr Partial wood[] = {{1, 0.7, 26}, {2.76, 0.3, 48}, {5.4, 0.12, 90}};
constexpr Partial glass[] = {{1, 0.5, 8}, {2.32, 0.28, 12}, {4.25, 0.16, 18}, {6.63, 0.08, 27}};
constexpr Partial rubber[] = {{1, 0.75, 11}, {1.98, 0.2, 20}, {3.1, 0.08, 36}};
constexpr Partial marble[] = {{1, 0.6, 70}, {2.6, 0.3, 100}, {4.9, 0.12, 140}};
constexpr Partial twang[] = {{1, 0.45, 6}, {2, 0.25, 8}, {3, 0.16, 11}, {4, 0.1, 15}, {5, 0.05, 20}};
constexpr Partial pling[] = {{1, 0.72, 5.5}, {2, 0.18, 9}, {3.01, 0.1, 14}};
constexpr Partial bell[] = {{1, 0.6, 2.2}, {2, 0.24, 3.4}, {3, 0.11, 5}, {4.2, 0.06, 9}};
constexpr Partial whistle[] = {{1, 0.9, 1.4}, {2, 0.1, 2}};
constexpr Partial gong[] = {{1, 0.5, 2}, {1.52, 0.25, 3}, {2.37, 0.15, 5}, {3.1, 0.1, 8}};
constexpr Partial kalimba[] = {{1, 0.84, 5}, {2, 0.1, 9}, {5.8, 0.06, 34}};
constexpr Partial oud[] = {{1, 0.46, 4.5}, {2, 0.26, 6}, {3, 0.15, 8.5}, {4, 0.09, 12}, {5, 0.04, 17}};
constexpr Partial celesta[] = {{1, 0.7, 3}, {2, 0.14, 4.5}, {4, 0.13, 8}, {6.3, 0.03, 18}};
constexpr Partial vibraphone[] = {{1, 0.52, 1.5}, {1.0035, 0.36, 1.5}, {4, 0.12, 6}};
constexpr Partial bass[] = {{1, 0.76, 2.6}, {2, 0.19, 4.5}, {3, 0.05, 8}};
constexpr Partial pad[] = {{1, 0.4, 0.25}, {1.003, 0.32, 0.25}, {2, 0.2, 0.4}, {2.994, 0.08, 0.6}};
constexpr Partial drum[] = {{1, 0.62, 13}, {1.59, 0.25, 20}, {2.14, 0.13, 30}};

constexpr std::array<Voice, 16> voices{{{wood, 0.0012, 0.4, 0},
                                        {glass, 0.001, 1.1, 0},
                                        {rubber, 0.003, 0.7, 0},
                                        {marble, 0.0006, 0.15, 0},
                                        {twang, 0.002, 1, 0},
                                        {pling, 0.002, 1.2, 0},
                                        {bell, 0.003, 2, 0},
                                        {whistle, 0.03, 1.3, 1.1},
                                        {gong, 0.004, 2, 0},
                                        {kalimba, 0.003, 1.2, 0},
                                        {oud, 0.002, 1.4, 0},
                                        {celesta, 0.003, 1.8, 0},
                                        {vibraphone, 0.006, 3, 0},
                                        {bass, 0.012, 1.6, 0},
                                        {pad, 0.9, 5, 0},
                                        {drum, 0.002, 0.4, 0}}};
static_assert(static_cast<std::size_t>(Timbre::drum) + 1 == voices.size());

double raised_cosine(double share) { return 0.5 - 0.5 * geometry::sine_cosine(geometry::pi * share).cosine; }

struct Envelope {
    double attack, release, end;  // samples

    double at(double n) const {
        double gain = 1;
        if (n < attack) gain = raised_cosine(n / attack);
        if (n > end - release) gain *= raised_cosine((end - n) / release);
        return gain;
    }
};

// A sample of sine and cosine that turns and shrinks by the same factor from one to the next.
struct Turning {
    double sine, cosine;            // times the amplitude
    double turn_sine, turn_cosine;  // times the factor

    double next() {
        double const now = sine;
        sine = now * turn_cosine + cosine * turn_sine;
        cosine = cosine * turn_cosine - now * turn_sine;
        return now;
    }
};

Turning turning_at(double frequency, double decay, double seconds) {
    double const cycles = frequency * seconds;
    auto const angle = geometry::sine_cosine(two_pi * (cycles - std::floor(cycles)));
    auto const turn = geometry::sine_cosine(two_pi * frequency / rate);
    double const amplitude = geometry::exponential(-decay * seconds);
    double const factor = geometry::exponential(-decay / rate);
    return {amplitude * angle.sine, amplitude * angle.cosine, factor * turn.sine, factor * turn.cosine};
}

// The pitch falls as exp(-glide t): so many cycles have gone by.
double cycles_of_glide(double frequency, double glide, double seconds) {
    return frequency / glide * (1 - geometry::exponential(-glide * seconds));
}

double gain_of(Partial const& partial, Note const& note) {
    bool const is_first = partial.ratio == 1;
    return partial.gain * note.loudness * (is_first ? 1 : note.brightness);
}

}  // namespace

Voice const& voice_of(Timbre timbre) { return voices[static_cast<std::size_t>(timbre)]; }

long long length_of(Note const& note) { return std::llround(voice_of(note.timbre).length * rate); }

void add_note(Note const& note, long long first, int count, double* left, double* right) {
    Voice const& voice = voice_of(note.timbre);
    long long const end = note.start + length_of(note);
    long long const from = std::max(first, note.start), to = std::min(first + count, end);
    if (from >= to) return;
    // Counted from one: the sample at which a note begins is not silent.
    double const since = static_cast<double>(from - note.start + 1);
    auto const samples = static_cast<std::size_t>(to - from);
    std::array<double, block> sum{};
    for (Partial const& partial : voice.partials) {
        double const frequency = partial.ratio * note.pitch, gain = gain_of(partial, note);
        if (frequency > 0.45 * rate ||
            gain * geometry::exponential(-partial.decay * since / rate) < unheard * note.loudness)
            continue;
        if (voice.glide > 0) {
            for (std::size_t i = 0; i < samples; ++i) {
                double const seconds = (since + static_cast<double>(i)) / rate;
                double const cycles = cycles_of_glide(frequency, voice.glide, seconds);
                sum[i] += gain * geometry::exponential(-partial.decay * seconds) *
                          geometry::sine_cosine(two_pi * (cycles - std::floor(cycles))).sine;
            }
            continue;
        }
        Turning turning = turning_at(frequency, partial.decay, since / rate);
        for (std::size_t i = 0; i < samples; ++i) sum[i] += gain * turning.next();
    }
    double const length = static_cast<double>(end - note.start);
    Envelope const envelope{voice.attack * rate, released_share * length, length + 1};
    auto const sides = geometry::sine_cosine((note.pan + 1) * geometry::pi / 4);
    for (std::size_t i = 0; i < samples; ++i) {
        double const sample = sum[i] * envelope.at(since + static_cast<double>(i));
        left[from - first + static_cast<long long>(i)] += sides.cosine * sample;
        right[from - first + static_cast<long long>(i)] += sides.sine * sample;
    }
}

}  // namespace sound
