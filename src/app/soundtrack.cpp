#include "app/soundtrack.h"

#include <algorithm>
#include <cmath>

#include "app/chunked_advance.h"
#include "sound/samples.h"
#include "sound/timbre.h"
#include "view/camera.h"

namespace app {

namespace {

constexpr double hearing_stretch = 0.25;  // s, well within what the session remembers
constexpr sound::Clock film_clock;        // sample 0 is the session's beginning

}  // namespace

Soundtrack::Soundtrack(game::Session& session, double from)
    : heard_(from - sound::longest_note), delivered_(sound::sample_at(film_clock, from)) {
    score_.tune = sound::Playing{sound::world_of(*session.level), 0};
    if (heard_ > 0) advance_in_chunks(session, heard_, view::camera_memory);
    hear(session, from);
}

void Soundtrack::hear(game::Session& session, double until) {
    while (heard_ < until) {
        double const next = std::min(until, std::max(heard_, 0.0) + hearing_stretch);
        advance_in_chunks(session, next, view::camera_memory);
        sound::hear(score_, session, heard_, next, film_clock);
        heard_ = next;
    }
}

std::vector<float> Soundtrack::on_to(game::Session& session, double until) {
    std::vector<float> samples;
    while (heard_ < until) {
        hear(session, std::min(until, heard_ + hearing_stretch));
        long long const end = sound::sample_at(film_clock, heard_);
        sound::forget_before(score_, delivered_);
        auto const more = sound::samples(score_, delivered_, end - delivered_);
        samples.insert(samples.end(), more.begin(), more.end());
        delivered_ = end;
    }
    return samples;
}

}  // namespace app
