#include "level/source.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <sys/stat.h>

namespace level {

namespace {

[[noreturn]] void refuse(std::string const& file, int error) {
    throw std::runtime_error(file + ": cannot be read: " + std::strerror(error));
}

void append_utf8(std::string& text, std::uint32_t code) {
    auto const tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xc0 | (code >> 6));
        tail(0);
    } else if (code < 0x10000) {
        text += static_cast<char>(0xe0 | (code >> 12));
        tail(6);
        tail(0);
    } else {
        text += static_cast<char>(0xf0 | (code >> 18));
        tail(12);
        tail(6);
        tail(0);
    }
}

enum class Order { low_first, high_first };

std::string utf8_of_utf16(std::string const& bytes, std::size_t first, Order order) {
    std::string text;
    auto const unit = [&](std::size_t i) -> std::uint32_t {
        std::uint32_t const a = static_cast<unsigned char>(bytes[i]), b = static_cast<unsigned char>(bytes[i + 1]);
        return order == Order::low_first ? a | b << 8 : a << 8 | b;
    };
    for (std::size_t i = first; i + 1 < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        bool const pair = code >= 0xd800 && code < 0xdc00 && i + 3 < bytes.size();
        if (pair) {
            code = 0x10000 + ((code - 0xd800) << 10) + ((unit(i + 2) - 0xdc00) & 0x3ff);
            i += 2;
        }
        append_utf8(text, code);
    }
    return text;
}

bool declares_latin1(std::string const& bytes) {
    if (bytes.compare(0, 5, "<?xml") != 0) return false;
    std::string head = bytes.substr(0, std::min<std::size_t>(bytes.find("?>"), 200));
    std::transform(head.begin(), head.end(), head.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
    return head.find("iso-8859-1") != std::string::npos || head.find("latin1") != std::string::npos;
}

bool begins_with(std::string const& bytes, std::initializer_list<int> mark) {
    return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin(),
                                                     [](int a, char b) { return a == static_cast<unsigned char>(b); });
}

}  // namespace

std::string bytes_of(std::string const& file) {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> const stream(std::fopen(file.c_str(), "rb"), std::fclose);
    if (!stream) refuse(file, errno);
    struct stat status {};
    if (fstat(fileno(stream.get()), &status) == 0 && S_ISDIR(status.st_mode)) refuse(file, EISDIR);
    std::string bytes;
    std::vector<char> part(1 << 16);
    // One byte past the limit tells a file that is too large from one that just fits, whatever stat says of it.
    while (bytes.size() <= largest_file) {
        std::size_t const count = std::fread(part.data(), 1, part.size(), stream.get());
        bytes.append(part.data(), count);
        if (count < part.size()) break;
    }
    if (std::ferror(stream.get())) refuse(file, errno);
    return bytes;
}

std::string utf8_of(std::string bytes) {
    if (begins_with(bytes, {0xef, 0xbb, 0xbf})) return bytes.substr(3);
    if (begins_with(bytes, {0xff, 0xfe})) return utf8_of_utf16(bytes, 2, Order::low_first);
    if (begins_with(bytes, {0xfe, 0xff})) return utf8_of_utf16(bytes, 2, Order::high_first);
    if (begins_with(bytes, {'<', 0})) return utf8_of_utf16(bytes, 0, Order::low_first);
    if (begins_with(bytes, {0, '<'})) return utf8_of_utf16(bytes, 0, Order::high_first);
    if (!declares_latin1(bytes)) return bytes;
    std::string text;
    for (char const c : bytes) append_utf8(text, static_cast<unsigned char>(c));
    return text;
}

Lines::Lines(std::string const& text) {
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 1))
        ends_.push_back(static_cast<std::ptrdiff_t>(i));
}

int Lines::line_at(std::ptrdiff_t offset) const {
    return 1 + static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), offset) - ends_.begin());
}

}  // namespace level
