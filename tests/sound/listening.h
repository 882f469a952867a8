// Games made by hand, and what a listener measures of samples.
#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "scenes/levels.h"
#include "sound/hear.h"
#include "sound/samples.h"

namespace sound_test {

using namespace scenes;

// A floor at height 1, 16 m wide, and a ball of radius 0.4 m whose lowest point is so high above it.
inline level::Level floor_level(double height, physics::Material const& material = {}) {
    level::Level level = level_with({disc(0.4, {8, 1.4 + height})});
    level.surface_names = {"floor"};
    level.scene.terrain = physics::terrain_of({line({-20, 1}, {40, 1}, material)});
    return level;
}

// What is heard until a time, without a tune, in stretches of so many seconds.
inline sound::Score score_of(level::Level const& level, double until, double stretch = 10,
                             std::vector<game::Input> inputs = {}) {
    game::Session session = session_of(level, physics::Exact{}, std::move(inputs));
    sound::Score score;
    for (double from = -1, to = 0; from < until; from = to) {
        to = std::min(until, std::max(from, 0.0) + stretch);
        game::advance(session, to);
        sound::hear(score, session, from, to, {});
    }
    return score;
}

inline std::vector<double> left_of(std::vector<float> const& samples) {
    std::vector<double> left;
    for (std::size_t i = 0; i < samples.size(); i += 2) left.push_back(samples[i]);
    return left;
}

// |sum of x(n) exp(-2 pi i f n / rate)|
inline double strength_at(std::vector<double> const& samples, double frequency) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < samples.size(); ++n)
        sum += samples[n] * std::polar(1.0, -2 * M_PI * frequency * static_cast<double>(n) / sound::rate);
    return std::abs(sum);
}

inline double power_of(std::vector<double> const& samples) {
    double sum = 0;
    for (double const sample : samples) sum += sample * sample;
    return sum / static_cast<double>(samples.size());
}

// The first sample that is not silent, or -1.
inline long long onset_of(std::vector<float> const& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i] != 0) return static_cast<long long>(i / 2);
    return -1;
}

}  // namespace sound_test
