#include "screen/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <utility>

extern char** environ;  // NOLINT: POSIX asks for this declaration

namespace screen {
namespace {

constexpr std::size_t kept_words = 4096;  // bytes of what a program says: the end of it is what matters

constexpr int second_input = 3;

void close_if_open(int& descriptor) {
    if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

struct Pipe {
    int out = -1, in = -1;

    Pipe() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
        out = ends[0];
        in = ends[1];
    }
    ~Pipe() {
        close_if_open(out);
        close_if_open(in);
    }
    Pipe(Pipe const&) = delete;
    Pipe& operator=(Pipe const&) = delete;
};

// Keeps SIGPIPE from the thread while it writes, and swallows the one that a write raised.
class NoBrokenPipeSignal {
public:
    NoBrokenPipeSignal() {
        sigemptyset(&only_);
        sigaddset(&only_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &only_, &before_);
    }
    ~NoBrokenPipeSignal() {
        if (!sigismember(&before_, SIGPIPE)) {
            timespec const now{};
            while (sigtimedwait(&only_, nullptr, &now) < 0 && errno == EINTR) {
            }
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoBrokenPipeSignal(NoBrokenPipeSignal const&) = delete;
    NoBrokenPipeSignal& operator=(NoBrokenPipeSignal const&) = delete;

private:
    sigset_t only_{}, before_{};
};

// Starts the program with the pipes as its stdin, stdout, stderr and second input, and signals as a fresh program finds
// them.
int spawn(pid_t& process, std::vector<std::string> const& arguments, Pipe const& input, Pipe const& output,
          Pipe const& errors, Pipe const& beside) {
    std::vector<char*> words;
    for (std::string const& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input.out, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output.in, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, errors.in, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&files, beside.out, second_input);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none, usual;
    sigemptyset(&none);
    sigemptyset(&usual);
    for (int const signal : {SIGPIPE, SIGINT, SIGTERM, SIGXFSZ}) sigaddset(&usual, signal);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    int const error = posix_spawnp(&process, words[0], &files, &attributes, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return error;
}

}  // namespace

Child::Child(std::vector<std::string> const& arguments) {
    Pipe input, output, errors, beside;
    int const error = spawn(process_, arguments, input, output, errors, beside);
    if (error != 0) throw std::runtime_error(arguments[0] + " cannot be started: " + std::strerror(error));
    input_ = std::exchange(input.in, -1);
    heard_[0].descriptor = std::exchange(output.out, -1);
    heard_[1].descriptor = std::exchange(errors.out, -1);
    beside_ = std::exchange(beside.in, -1);
    for (int const descriptor : {input_, beside_}) fcntl(descriptor, F_SETFL, O_NONBLOCK);
    constexpr int room = 1 << 20;  // bytes: a whole small picture, where the system grants it
    fcntl(input_, F_SETPIPE_SZ, room);
}

Child::~Child() {
    if (process_ > 0) wait();
}

bool Child::feed(std::span<std::uint8_t const> bytes) {
    NoBrokenPipeSignal const quiet;
    while (!bytes.empty()) {
        if (input_ < 0) return false;
        ssize_t const written = write(input_, bytes.data(), bytes.size());
        if (written > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno == EAGAIN) {
            listen(-1, input_);
        } else if (errno != EINTR) {
            return false;
        }
    }
    listen(0, -1);
    return true;
}

void Child::feed_beside(std::span<std::uint8_t const> bytes) {
    if (beside_ < 0) return;
    kept_beside_.insert(kept_beside_.end(), bytes.begin(), bytes.end());
    NoBrokenPipeSignal const quiet;
    pour_beside();
}

// As much as the program takes now.
void Child::pour_beside() {
    std::size_t poured = 0;
    while (beside_ >= 0 && poured < kept_beside_.size()) {
        ssize_t const written = write(beside_, kept_beside_.data() + poured, kept_beside_.size() - poured);
        if (written > 0)
            poured += static_cast<std::size_t>(written);
        else if (errno == EAGAIN)
            break;
        else if (errno != EINTR)
            close_if_open(beside_);
    }
    kept_beside_.erase(kept_beside_.begin(), kept_beside_.begin() + static_cast<std::ptrdiff_t>(poured));
    if (beside_ < 0) kept_beside_.clear();
}

// Hears what there is, until an input can take more; a program that nobody listens to would wait for us for ever.
void Child::listen(int milliseconds, int writable) {
    std::array<pollfd, 4> ends{{{heard_[0].descriptor, POLLIN, 0},
                                {heard_[1].descriptor, POLLIN, 0},
                                {writable, POLLOUT, 0},
                                {kept_beside_.empty() ? -1 : beside_, POLLOUT, 0}}};
    if (poll(ends.data(), ends.size(), milliseconds) <= 0) return;
    if (ends[3].revents != 0) pour_beside();
    for (std::size_t i = 0; i < 2; ++i)
        if (ends[i].revents != 0) hear(heard_[i]);
}

void Child::hear(PipeReader& ear) {
    std::array<char, 4096> words{};
    ssize_t const count = read(ear.descriptor, words.data(), words.size());
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) return close_if_open(ear.descriptor);
    ear.text.append(words.data(), static_cast<std::size_t>(count));
    if (ear.text.size() > kept_words) ear.text.erase(0, ear.text.size() - kept_words);
}

Ending Child::wait() {
    NoBrokenPipeSignal const quiet;
    close_if_open(input_);
    while (!kept_beside_.empty()) listen(-1, -1);
    close_if_open(beside_);
    while (heard_[0].descriptor >= 0 || heard_[1].descriptor >= 0) listen(-1, -1);
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (WIFSIGNALED(status)) return {0, WTERMSIG(status)};
    return {WEXITSTATUS(status), 0};
}

}  // namespace screen
