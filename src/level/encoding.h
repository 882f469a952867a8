// From the bytes of a file to UTF-8: which encoding they are in, and whether they are what it allows.
#pragma once

#include <string>

namespace level {

struct Decoded {
    std::string text;   // UTF-8 without a byte order mark; up to the first byte that the encoding does not allow
    std::string wrong;  // what that byte is, or empty
};

// UTF-16 by its first bytes, else as the XML declaration says, else UTF-8.
Decoded decoded(std::string bytes);

}  // namespace level
