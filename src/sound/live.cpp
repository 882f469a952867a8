#include "sound/live.h"

#include <algorithm>

#include "sound/hear.h"
#include "sound/samples.h"

namespace sound {

namespace {

constexpr double shortest_lead = 0.008;   // s
constexpr double lead_of_a_frame = 1.25;  // frames: the next one may come late
constexpr double ramp_step = 1 / (Live::ramp * rate);

double towards(double now, double wanted) { return now + std::clamp(wanted - now, -ramp_step, ramp_step); }

}  // namespace

void Live::begin(World world) {
    std::scoped_lock const lock(mutex_);
    Score fresh;
    bool const goes_on = score_.tune && score_.tune->world == world;
    fresh.tune = goes_on ? *score_.tune : Playing{world, playhead_};
    next_ = std::move(fresh);
    known_ = playhead_;
}

void Live::hear(game::Session const& session, double from, double until, double elapsed) {
    if (!(until > from)) return;
    std::scoped_lock const lock(mutex_);
    double const lead = std::clamp(lead_of_a_frame * elapsed, shortest_lead, longest_lead);
    long long const first = std::max(known_, playhead_);
    long long const last = std::max(first + 1, playhead_ + static_cast<long long>(lead * rate));
    Clock const clock{from, first, static_cast<double>(last - first) / (until - from)};
    Score& score = next_ ? *next_ : score_;
    sound::hear(score, session, from, until, clock);
    forget_before(score, playhead_);
    known_ = last;
}

void Live::gate(Gate gate) {
    std::scoped_lock const lock(mutex_);
    gate_ = gate;
}

void Live::set_volume(double volume) {
    std::scoped_lock const lock(mutex_);
    volume_ = volume;
}

void Live::fill(float* target, int count) {
    std::scoped_lock const lock(mutex_);
    for (int done = 0; done < count;) {
        if (next_ && opening_ == 0) {
            score_ = std::move(*next_);
            next_.reset();
        }
        bool const is_wanted = gate_ == Gate::open && !next_;
        if (!is_wanted && opening_ == 0) {
            std::fill(target, target + 2 * (count - done), 0.0f);
            return;
        }
        // While it fades for what is next, no further than to the silence between.
        int const most = next_ ? static_cast<int>(opening_ / ramp_step) + 1 : count;
        int const stretch = std::min(count - done, most);
        write_samples(score_, playhead_, stretch, target);
        for (int i = 0; i < stretch; ++i, target += 2) {
            opening_ = towards(opening_, is_wanted ? 1 : 0);
            volume_now_ = towards(volume_now_, volume_);
            float const gain = static_cast<float>(opening_ * volume_now_);
            target[0] *= gain;
            target[1] *= gain;
        }
        playhead_ += stretch;
        done += stretch;
    }
}

}  // namespace sound
