#include "level/encoding.h"

#include <algorithm>
#include <cerrno>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <vector>

#include <iconv.h>

#include "level/faults.h"

namespace level {

namespace {

bool begins_with(std::string_view bytes, std::initializer_list<int> mark) {
    return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin(),
                                                     [](int a, char b) { return a == static_cast<unsigned char>(b); });
}

// The name in encoding="..." of an XML declaration; UTF-8 where there is none.
std::string declared_encoding(std::string_view bytes) {
    constexpr std::string_view usual = "UTF-8";
    if (bytes.substr(0, 5) != "<?xml") return std::string(usual);
    std::string_view const head = bytes.substr(0, std::min<std::size_t>(bytes.find("?>"), 1000));
    std::size_t const name = head.find("encoding");
    std::size_t const quote = head.find_first_of("\"'", std::min(name, head.size()));
    if (quote == std::string_view::npos) return std::string(usual);
    std::size_t const end = head.find(head[quote], quote + 1);
    if (end == std::string_view::npos) return std::string(usual);
    std::string encoding(head.substr(quote + 1, end - quote - 1));
    std::transform(encoding.begin(), encoding.end(), encoding.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return encoding;
}

// How many bytes from the front are UTF-8 (RFC 3629: the shortest form, no surrogates, up to U+10FFFF).
std::size_t length_of_utf8(std::string_view bytes) {
    std::size_t i = 0;
    auto const byte = [&](std::size_t at) { return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0; };
    while (i < bytes.size()) {
        int const first = byte(i), second = byte(i + 1);
        std::size_t const tail = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
        bool sound = first < 0x80 || (first >= 0xc2 && first < 0xf5);
        for (std::size_t k = 1; k <= tail; ++k) sound = sound && (byte(i + k) & 0xc0) == 0x80;
        bool const longer_than_needed = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
        bool const surrogate = first == 0xed && second >= 0xa0, beyond = first == 0xf4 && second >= 0x90;
        if (!sound || longer_than_needed || surrogate || beyond) return i;
        i += 1 + tail;
    }
    return i;
}

std::string shown_byte(char c) {
    int const value = static_cast<unsigned char>(c);
    return std::string("0x") + "0123456789abcdef"[value >> 4] + "0123456789abcdef"[value & 15];
}

Decoded as_utf8(std::string bytes) {
    std::size_t const sound = length_of_utf8(bytes);
    if (sound == bytes.size()) return {std::move(bytes), {}};
    std::string wrong = "the byte " + shown_byte(bytes[sound]) + " is not UTF-8";
    bytes.resize(sound);
    return {std::move(bytes), std::move(wrong)};
}

struct Closer {
    void operator()(void* converter) const { iconv_close(converter); }
};

Decoded converted(std::string bytes, std::string const& encoding) {
    Decoded const unknown{{}, "the encoding " + quoted(encoding) + " is not known"};
    // To iconv no name is that of the locale, and what follows a slash is an order.
    if (encoding.empty() || encoding.find('/') != std::string::npos) return unknown;
    iconv_t const opened = iconv_open("UTF-8", encoding.c_str());
    if (opened == reinterpret_cast<iconv_t>(-1)) return unknown;
    std::unique_ptr<void, Closer> const converter(opened);
    Decoded result;
    std::vector<char> part(1 << 16);
    char* from = bytes.data();
    std::size_t left = bytes.size();
    while (left > 0) {
        char* to = part.data();
        std::size_t room = part.size();
        std::size_t const done = iconv(opened, &from, &left, &to, &room);
        result.text.append(part.data(), to);
        if (done != static_cast<std::size_t>(-1) || errno == E2BIG) continue;
        result.wrong = "the byte " + shown_byte(*from) + " is not " + encoding;
        break;
    }
    return result;
}

}  // namespace

Decoded decoded(std::string bytes) {
    if (begins_with(bytes, {0xef, 0xbb, 0xbf})) return as_utf8(bytes.substr(3));
    if (begins_with(bytes, {0xff, 0xfe})) return converted(bytes.substr(2), "UTF-16LE");
    if (begins_with(bytes, {0xfe, 0xff})) return converted(bytes.substr(2), "UTF-16BE");
    if (begins_with(bytes, {'<', 0})) return converted(std::move(bytes), "UTF-16LE");
    if (begins_with(bytes, {0, '<'})) return converted(std::move(bytes), "UTF-16BE");
    std::string const encoding = declared_encoding(bytes);
    if (encoding == "UTF-8" || encoding == "UTF8") return as_utf8(std::move(bytes));
    // The declaration was read byte by byte, which those of two bytes would not allow.
    if (encoding.substr(0, 6) == "UTF-16" || encoding.substr(0, 3) == "UCS" || encoding.substr(0, 6) == "UTF-32")
        return {{}, "it is not in the encoding that it declares, " + quoted(encoding)};
    return converted(std::move(bytes), encoding);
}

}  // namespace level
