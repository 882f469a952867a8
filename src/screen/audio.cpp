#include "screen/audio.h"

#include <SDL.h>

#include <fcntl.h>
#include <unistd.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace screen {
namespace {

constexpr Uint16 samples_at_once = 256;  // 5 ms
constexpr int sides = 2;

void fill_for_sdl(void* fill, Uint8* bytes, int count) {
    int const samples = count / static_cast<int>(sides * sizeof(float));
    (*static_cast<FillSound*>(fill))(reinterpret_cast<float*>(bytes), samples);
}

// ALSA tells standard error at length that it has found no device, which is nobody's concern. What is written there
// while this lives is lost.
class QuietErrors {
public:
    QuietErrors() : kept_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
        int const nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) close(nowhere);
    }
    ~QuietErrors() {
        if (kept_ < 0) return;
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }
    QuietErrors(QuietErrors const&) = delete;
    QuietErrors& operator=(QuietErrors const&) = delete;

private:
    int kept_;
};

}  // namespace

struct Audio::Body {
    // SDL's audio while it lives.
    struct System {
        System() {
            if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0)
                throw std::runtime_error(std::string("no sound: ") + SDL_GetError());
        }
        ~System() { SDL_QuitSubSystem(SDL_INIT_AUDIO); }
        System(System const&) = delete;
        System& operator=(System const&) = delete;
    };

    FillSound fill;
    std::optional<System> system;
    SDL_AudioDeviceID device = 0;

    Body(int rate, FillSound fill_wanted) : fill(std::move(fill_wanted)) {
        QuietErrors const quiet;
        system.emplace();
        SDL_AudioSpec wanted{};
        wanted.freq = rate;
        wanted.format = AUDIO_F32SYS;
        wanted.channels = sides;
        wanted.samples = samples_at_once;
        wanted.callback = fill_for_sdl;
        wanted.userdata = &fill;
        device = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
        if (device == 0) throw std::runtime_error(std::string("no sound: ") + SDL_GetError());
        SDL_PauseAudioDevice(device, 0);
    }
    ~Body() { SDL_CloseAudioDevice(device); }
    Body(Body const&) = delete;
    Body& operator=(Body const&) = delete;
};

Audio::Audio(int rate, FillSound fill) : body_(std::make_unique<Body>(rate, std::move(fill))) {}
Audio::~Audio() = default;
Audio::Audio(Audio&&) noexcept = default;
Audio& Audio::operator=(Audio&&) noexcept = default;

}  // namespace screen
