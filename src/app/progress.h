// Progress on standard error: a bar with frames a second and the time left, on a terminal only.
#pragma once

#include <chrono>

namespace app {

class Progress {
public:
    enum class Bar { never, on_terminal };
    enum class Look { plain, coloured };
    Progress(long long total, Bar bar);
    ~Progress();  // clears the line
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    void show(long long finished);

private:
    using Clock = std::chrono::steady_clock;
    long long total_;
    Look look_;
    bool visible_;
    bool drawn_ = false;
    Clock::time_point begun_ = Clock::now(), last_ = begun_;
};

}  // namespace app
