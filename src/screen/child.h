// Another program at the other end of pipes: fed bytes, listened to, waited for.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace screen {

// How a program ended.
struct Ending {
    int status = 0;  // of exit; meaningless when signalled
    int signal = 0;  // 0 when it ended by itself
};

// Runs in a process group of its own, so that the terminal's Ctrl-C is ours to handle; never through a shell.
class Child {
public:
    // The program is looked for along PATH. It finds a second input at descriptor 3. Throws std::runtime_error when it
    // cannot be started.
    explicit Child(std::vector<std::string> const& arguments);
    ~Child();  // ends its inputs and waits for it
    Child(Child const&) = delete;
    Child& operator=(Child const&) = delete;

    // False when the program no longer takes any. Never raises SIGPIPE.
    [[nodiscard]] bool feed(std::span<std::uint8_t const> bytes);
    // For the second input: kept here until the program takes it, be it while it takes what is fed, so that neither
    // waits for the other. Nothing where it takes no more.
    void feed_beside(std::span<std::uint8_t const> bytes);
    // Lets it have what is kept for the second input, ends its inputs, hears it out, waits.
    Ending wait();

    std::string const& output() const { return heard_[0].text; }  // its last words on stdout
    std::string const& errors() const { return heard_[1].text; }  // and on stderr

private:
    struct PipeReader {
        int descriptor = -1;
        std::string text;
    };
    void listen(int milliseconds, int writable);
    void pour_beside();
    static void hear(PipeReader& ear);

    pid_t process_ = -1;
    int input_ = -1, beside_ = -1;
    std::vector<std::uint8_t> kept_beside_;
    PipeReader heard_[2];
};

}  // namespace screen
