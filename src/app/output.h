// Standard output as a stream of data, every write of which is checked; and notes on standard error.
#pragma once

#include <string>
#include <string_view>

namespace app {

// Where a standard stream is closed, something that refuses to be written to takes its place, so that no file which
// is opened later is mistaken for it.
void hold_standard_streams();

// Throws std::runtime_error when standard output is closed or full, Interrupted when it blocks and Ctrl-C comes.
void write_to_stdout(std::string_view bytes);

// Collects lines and writes them in large blocks. What is not flushed is lost.
class Output {
public:
    void add(std::string_view text) { block_ += text; }
    void add(char letter) { block_ += letter; }
    void add(double number);  // 17 significant digits, as %.17g in the C locale
    void add(long long number);
    void flush();
    // For the end of a line: writes when the block is full.
    void end_line();

private:
    std::string block_;
};

std::string seventeen_digits(double number);

// One line on standard error, control characters made spaces.
void note(std::string const& text);

}  // namespace app
