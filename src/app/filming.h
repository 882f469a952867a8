// Writing a film of a sequence, with its sound.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include "app/interrupt.h"
#include "app/sequence.h"

namespace app {

struct FilmOptions {
    SequenceOptions sequence;
    bool no_sound = false;
    std::function<void(long long frame)>
        told;  // before each frame, on the calling thread; what it throws ends the film
};

// Throws UsageError, Interrupted, std::runtime_error, the last two with the name of what is left of the film.
void write_film(Sequence& sequence, FilmOptions const& options);

// Makes the folder of what is to be written. Throws std::runtime_error where the file is there already.
void make_way_for(std::filesystem::path const& file, bool overwrite);

// What was recorded before a failure is named, unless the failure names it already.
template <typename Recording>
std::string with_part(std::string const& what, Recording& recording) {
    auto const part = recording.abandon();
    if (!part || what.find(part->string()) != std::string::npos) return what;
    return what + "; what was recorded until then is in " + part->string();
}

// Runs `work` to its end, else says what of the recording is left.
template <typename Recording, typename Work>
void keep_what_is_left(Recording& recording, Work work) {
    try {
        work();
        recording.finish();
    } catch (Interrupted const& interruption) {
        throw Interrupted(with_part(interruption.what(), recording));
    } catch (std::runtime_error const& error) {
        throw std::runtime_error(with_part(error.what(), recording));
    }
}

}  // namespace app
