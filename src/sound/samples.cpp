#include "sound/samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sound/motion.h"
#include "sound/timbre.h"
#include "sound/tune.h"

namespace sound {

namespace {

struct Block {
    std::array<double, block> left{}, right{};
};

// Block number b of samples [b * block, (b + 1) * block).
Block block_at(Score const& score, long long number) {
    Block result;
    long long const first = number * block;
    for (Note const& note : score.notes) {
        if (note.start >= first + block) break;
        add_note(note, first, block, result.left.data(), result.right.data());
    }
    add_motions(score.motions, first, block, result.left.data(), result.right.data());
    if (score.tune) add_tune(*score.tune, first, block, result.left.data(), result.right.data());
    return result;
}

long long block_of(long long sample) { return sample >= 0 ? sample / block : -((block - 1 - sample) / block); }

}  // namespace

double limited(double sample) {
    constexpr double straight = 0.6;
    double const size = std::abs(sample);
    if (size <= straight) return sample;
    double const over = (size - straight) / (1 - straight);
    // A float nearest to what lies just below 1 must not be 1.
    return std::copysign(std::min(straight + (1 - straight) * over / (1 + over), 0.999), sample);
}

void write_samples(Score const& score, long long first, long long count, float* target) {
    for (long long sample = first; sample < first + count;) {
        long long const number = block_of(sample);
        long long const end = std::min((number + 1) * block, first + count);
        Block const now = block_at(score, number);
        for (; sample < end; ++sample) {
            auto const i = static_cast<std::size_t>(sample - number * block);
            *target++ = static_cast<float>(limited(now.left[i]));
            *target++ = static_cast<float>(limited(now.right[i]));
        }
    }
}

std::vector<float> samples(Score const& score, long long first, long long count) {
    std::vector<float> both(static_cast<std::size_t>(2 * count));
    write_samples(score, first, count, both.data());
    return both;
}

void forget_before(Score& score, long long sample) {
    std::erase_if(score.notes, [&](Note const& note) { return note.start + length_of(note) <= sample; });
    Motions& motions = score.motions;
    long long const kept = block_of(sample) * block / motion_step - 1;
    while (motions.first < kept && !motions.rows.empty() && motions.rows.front().size() > 1) {
        for (auto& rows : motions.rows) rows.pop_front();
        ++motions.first;
    }
}

}  // namespace sound
