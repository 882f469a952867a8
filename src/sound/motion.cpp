#include "sound/motion.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "sound/noise.h"

namespace sound {

double smooth_noise(double at, std::uint64_t seed) {
    double const whole = std::floor(at), share = at - whole;
    auto const number = static_cast<std::int64_t>(whole);
    double const before = hashed(number, seed), after = hashed(number + 1, seed);
    return before + (after - before) * share * share * share * (10 + share * (6 * share - 15));
}

namespace {

constexpr int fading_rows = 30;  // after the last row: 80 ms

Motion between(Motion const& a, Motion const& b, double share) {
    auto const mixed = [&](double x, double y) { return x + (y - x) * share; };
    return {mixed(a.roll, b.roll), mixed(a.way, b.way),       mixed(a.hardness, b.hardness),
            mixed(a.slip, b.slip), mixed(a.scrape, b.scrape), mixed(a.tension, b.tension),
            mixed(a.pan, b.pan)};
}

Motion faded(Motion motion, double gain) {
    motion.roll *= gain;
    motion.slip *= gain;
    motion.tension *= gain;
    return motion;
}

// Row `i` counted from the first: silent before, fading after the last.
Motion row_at(std::deque<Motion> const& rows, long long i) {
    auto const count = static_cast<long long>(rows.size());
    if (i < 0) return faded(rows.front(), 0);
    if (i < count) return rows[static_cast<std::size_t>(i)];
    return faded(rows.back(), std::max(0.0, 1 - static_cast<double>(i - count + 1) / fading_rows));
}

// Rolling over rough ground is heard at the ground's own scales: three of them, the finer the harder the ground.
double rolling(Motion const& motion, std::uint64_t ball) {
    double const soft = 1 - motion.hardness;
    return soft *
               (0.62 * smooth_noise(motion.way, 3 * ball + 1) + 0.28 * smooth_noise(2.3 * motion.way, 3 * ball + 2)) +
           (0.1 + 0.3 * motion.hardness) * smooth_noise(5.1 * motion.way, 3 * ball + 3) +
           0.2 * motion.hardness * smooth_noise(11.7 * motion.way, 3 * ball + 4);
}

// Slipping hisses: bands of noise that do not move, more of the higher ones the faster it is.
double slipping(Motion const& motion, double seconds, std::uint64_t ball) {
    return (1 - motion.scrape) * 0.6 * smooth_noise(700 * seconds, 5 * ball + 101) +
           0.35 * smooth_noise(1900 * seconds, 5 * ball + 102) +
           motion.scrape * 0.3 * smooth_noise(5200 * seconds, 5 * ball + 103);
}

constexpr double spring_loudness = 0.05;

// A stretched spring hums a chord of fixed tones, the more of the higher ones the more it is stretched.
double humming(double tension, double seconds) {
    if (tension <= 0) return 0;
    constexpr double tones[] = {98, 147, 196, 294};  // Hz
    double sum = 0, order = 0;
    for (double const tone : tones) {
        double const share = std::clamp(4 * tension - order, 0.0, 1.0);
        double const cycles = tone * seconds;
        sum += share * share * (3 - 2 * share) / (1 + order) *
               geometry::sine_cosine(2 * geometry::pi * (cycles - std::floor(cycles))).sine;
        ++order;
    }
    return spring_loudness * 0.5 * sum;
}

void add_motion(std::deque<Motion> const& rows, long long first_row, std::uint64_t ball, long long first, int count,
                double* left, double* right) {
    for (int i = 0; i < count; ++i) {
        long long const sample = first + i;
        long long const row = sample >= 0 ? sample / motion_step : -((motion_step - 1 - sample) / motion_step);
        double const share = static_cast<double>(sample - row * motion_step) / motion_step;
        // From the row before to this one, a step late: what comes next need not be known.
        Motion const before = row_at(rows, row - 1 - first_row), after = row_at(rows, row - first_row);
        Motion const now = between(before, after, share);
        double const seconds = static_cast<double>(sample) / rate;
        double sum = 0;
        if (now.roll > 0) sum += now.roll * rolling(now, ball);
        if (now.slip > 0) sum += now.slip * slipping(now, seconds, ball);
        sum += humming(now.tension, seconds);
        // At the sides louder by 1.3 dB at most, for want of a sine a sample.
        left[i] += sum * (1 - now.pan) * 0.7071;
        right[i] += sum * (1 + now.pan) * 0.7071;
    }
}

}  // namespace

void add_motions(Motions const& motions, long long first, int count, double* left, double* right) {
    for (std::size_t ball = 0; ball < motions.rows.size(); ++ball) {
        auto const& rows = motions.rows[ball];
        if (rows.empty()) continue;
        long long const end = motions.first + static_cast<long long>(rows.size()) + fading_rows;
        if (first + count <= (motions.first - 1) * motion_step || first > end * motion_step) continue;
        add_motion(rows, motions.first, ball, first, count, left, right);
    }
}

}  // namespace sound
