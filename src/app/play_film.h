// A film of what has been played, made while the game goes on.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/play_game.h"

namespace app {

// One film, on a thread of its own that gives way to the game.
class Filming {
public:
    Filming(std::string const& run_file, std::string const& film_file);
    ~Filming();  // cuts it short where it is not done
    Filming(Filming const&) = delete;
    Filming& operator=(Filming const&) = delete;

    double share() const { return share_; }  // of its frames, in [0, 1]
    // Once it has ended: its file, or why there is none.
    struct Outcome {
        bool whole = false;
        std::string what;
    };
    std::optional<Outcome> outcome();

private:
    void run(std::string const& run_file, std::string const& film_file);

    std::atomic<double> share_ = 0;
    std::atomic<bool> given_up_ = false;
    std::mutex mutex_;
    std::optional<Outcome> outcome_;
    std::thread thread_;
};

class PlayFilm {
public:
    // Begins a film where the player wants one, tells how far it has come and what has come of it.
    void follow(PlayGame& game);

private:
    void start(PlayGame& game);

    std::optional<Filming> filming_;
};

}  // namespace app
