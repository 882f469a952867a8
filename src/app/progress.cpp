#include "app/progress.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace app {

namespace {

constexpr auto redraw = std::chrono::milliseconds(100);
constexpr int bar_width = 30;  // characters

void write_to_stderr(std::string const& text) {
    [[maybe_unused]] ssize_t const written = ::write(STDERR_FILENO, text.data(), text.size());
}

Progress::Look look_wanted() {
    char const* const refusal = std::getenv("NO_COLOR");  // https://no-color.org: present and not empty
    return refusal && refusal[0] ? Progress::Look::plain : Progress::Look::coloured;
}

std::string bar_for(double share, Progress::Look look) {
    int const filled = static_cast<int>(share * bar_width);
    std::string const full(filled, '#'), empty(bar_width - filled, '.');
    return look == Progress::Look::coloured ? "\033[32m" + full + "\033[0m" + empty : full + empty;
}

std::string numbers_for(long long finished, long long total, double seconds) {
    double const rate = seconds > 0 ? static_cast<double>(finished) / seconds : 0;
    long long const left = rate > 0 ? static_cast<long long>(static_cast<double>(total - finished) / rate + 0.5) : 0;
    char numbers[128];
    std::snprintf(numbers, sizeof numbers, " %lld/%lld  %.1f frames/s  %lld:%02lld left", finished, total, rate,
                  left / 60, left % 60);
    return numbers;
}

}  // namespace

Progress::Progress(long long total, Bar bar)
    : total_(total), look_(look_wanted()), visible_(bar == Bar::on_terminal && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (drawn_) write_to_stderr("\r\033[K");
}

void Progress::show(long long finished) {
    Clock::time_point const now = Clock::now();
    if (!visible_ || now - last_ < redraw) return;
    last_ = now;
    drawn_ = true;
    double const seconds = std::chrono::duration<double>(now - begun_).count();
    double const share = static_cast<double>(finished) / static_cast<double>(total_);
    write_to_stderr("\r[" + bar_for(share, look_) + "]" + numbers_for(finished, total_, seconds) + "\033[K");
}

}  // namespace app
