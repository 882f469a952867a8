// The sound device: owns SDL's audio, which asks for samples from a thread of its own.
#pragma once

#include <functional>
#include <memory>

namespace screen {

// Writes 2 * count numbers, both sides in turn. Called on another thread.
using FillSound = std::function<void(float* samples, int count)>;

class Audio {
public:
    // At `rate` samples a second, asked for 256 at a time. Throws std::runtime_error where there is no device.
    Audio(int rate, FillSound fill);
    ~Audio();  // after which nothing is asked for any more
    Audio(Audio&&) noexcept;
    Audio& operator=(Audio&&) noexcept;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace screen
