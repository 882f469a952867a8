// A sequence of pictures: the options that render and record share, and the frames themselves, painted on several
// threads.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/opening.h"
#include "app/options.h"
#include "screen/pixels.h"
#include "view/scene_picture.h"
#include "view/turning.h"

namespace app {

struct SequenceOptions {
    std::string file, output;
    MethodOptions method;
    std::string rate = "60", size = "1280x720", from = "0", overlay;
    std::optional<std::string> to, jobs;
    bool overwrite = false;
    bool quiet = false;
    bool no_turn = false;
};
void declare(Subcommand& command, SequenceOptions& options);

// What the options mean for one level or run.
struct Sequence {
    game::Session session;
    view::Stage stage;
    view::Overlays overlays;
    view::Turning turning = view::Turning::with_gravity;
    Size size;
    game::Fraction from, rate;
    long long count = 0;  // frames
    int jobs = 1;         // threads that paint
    bool quiet = false;
};
// Throws UsageError, std::runtime_error. Opens the file last, so that wrong usage is told before a broken level.
Sequence sequence_for(SequenceOptions const& options);

inline double time_of(Sequence const& sequence, long long frame) {  // s
    return game::frame_time(sequence.from, frame, sequence.rate);
}

// What becomes of a frame, whose moment is settled when it is ordered: `make` runs on many threads at once, `deliver` on one at a time, in order of the frames.
struct FrameJob {
    std::function<std::vector<std::uint8_t>(long long frame, screen::Pixels const& pixels)> make;
    std::function<void(std::vector<std::uint8_t> product)> deliver;  // empty: nothing is left to do in order
    std::function<void(long long frame)> order;  // on the calling thread, before the frame is painted; may be empty
};

// Every frame of the sequence, with progress on a terminal. Throws what the first failing frame threw; frames
// delivered before stay.
void make_frames(Sequence& sequence, FrameJob const& job);

}  // namespace app
