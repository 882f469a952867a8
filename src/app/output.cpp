#include "app/output.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstring>
#include <stdexcept>

#include "app/interrupt.h"

namespace app {

namespace {

constexpr std::size_t block_size = 1u << 16;  // bytes
constexpr int patience = 100;                 // ms, for which Ctrl-C may go unheard while nobody reads

// Waits until a write of so many of the bytes will not block: a thread blocked in one would not hear Ctrl-C, which is
// told to another thread.
std::size_t writable_now(std::size_t wanted) {
    struct stat status {};
    if (::fstat(STDOUT_FILENO, &status) == 0 && S_ISREG(status.st_mode)) return wanted;
    pollfd output{STDOUT_FILENO, POLLOUT, 0};
    while (::poll(&output, 1, patience) <= 0) stop_if_interrupted();
    return std::min<std::size_t>(wanted, PIPE_BUF);
}

}  // namespace

void hold_standard_streams() {
    for (int descriptor = 0; descriptor < 3; ++descriptor) {
        if (::fcntl(descriptor, F_GETFD) >= 0) continue;
        int const opened = ::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        if (opened >= 0 && opened != descriptor) {
            ::dup2(opened, descriptor);
            ::close(opened);
        }
    }
}

void write_to_stdout(std::string_view bytes) {
    while (!bytes.empty()) {
        ssize_t const written = ::write(STDOUT_FILENO, bytes.data(), writable_now(bytes.size()));
        if (written < 0 && errno == EINTR) {
            stop_if_interrupted();
            continue;
        }
        if (written < 0 && errno == EBADF) throw std::runtime_error("standard output is closed");
        if (written < 0) throw std::runtime_error(std::string("standard output: ") + std::strerror(errno));
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void Output::add(double number) {
    char digits[40];
    auto const [end, error] = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 17);
    block_.append(digits, end);
}

void Output::add(long long number) {
    char digits[24];
    auto const [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    block_.append(digits, end);
}

void Output::flush() {
    write_to_stdout(block_);
    block_.clear();
}

void Output::end_line() {
    block_ += '\n';
    if (block_.size() >= block_size) flush();
}

std::string seventeen_digits(double number) {
    char digits[40];
    auto const [end, error] = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 17);
    return std::string(digits, end);
}

void note(std::string const& text) {
    std::string line = text;
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    line += '\n';
    // Where standard error is closed there is nobody left to tell.
    [[maybe_unused]] ssize_t const written = ::write(STDERR_FILENO, line.data(), line.size());
}

}  // namespace app
