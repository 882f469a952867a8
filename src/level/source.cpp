#include "level/source.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <libdeflate.h>
#include <sys/stat.h>

#include "level/faults.h"

namespace level {

namespace {

[[noreturn]] void refuse(std::string const& file, int error) {
    throw std::runtime_error(file + ": cannot be read: " + std::strerror(error));
}

struct Releaser {
    void operator()(libdeflate_decompressor* unpacker) const { libdeflate_free_decompressor(unpacker); }
};

bool is_packed(std::string_view bytes) { return bytes.substr(0, 2) == "\x1f\x8b"; }

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

std::string unpacked(std::string bytes) {
    if (!is_packed(bytes)) return bytes;
    std::unique_ptr<libdeflate_decompressor, Releaser> const unpacker(libdeflate_alloc_decompressor());
    // One byte past the limit tells what is too large from what just fits. Not written to, it costs no memory.
    std::size_t const room = largest_file + 1;
    std::unique_ptr<char[]> const text(new char[room]);
    std::size_t size = 0;
    // Gzip lets one member follow another.
    for (std::string_view rest = bytes; !rest.empty();) {
        std::size_t taken = 0, given = 0;
        auto const result = libdeflate_gzip_decompress_ex(unpacker.get(), rest.data(), rest.size(), text.get() + size,
                                                          room - size, &taken, &given);
        if (result == LIBDEFLATE_INSUFFICIENT_SPACE) return std::string(room, ' ');
        if (result != LIBDEFLATE_SUCCESS) throw Broken("svgz: the packed data is damaged or cut short");
        size += given;
        rest.remove_prefix(taken);
    }
    return {text.get(), size};
}

Lines::Lines(std::string const& text) {
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 1))
        ends_.push_back(static_cast<std::ptrdiff_t>(i));
}

int Lines::line_at(std::ptrdiff_t offset) const {
    return 1 + static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), offset) - ends_.begin());
}

}  // namespace level
