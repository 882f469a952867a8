#include "screen/png.h"

#include <fcntl.h>
#include <libdeflate.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace screen {
namespace {

std::runtime_error failure(std::filesystem::path const& file, std::string const& reason) {
    return std::runtime_error(file.string() + ": " + reason);
}

// A new file that is gone again unless it was made whole and renamed.
class Draft {
public:
    explicit Draft(std::filesystem::path const& file) : file_(file) {
        static std::atomic<unsigned> count{0};
        draft_ = file.string() + ".tmp-" + std::to_string(getpid()) + "-" + std::to_string(count++);
        descriptor_ = open(draft_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (descriptor_ < 0) throw failure(file_, std::strerror(errno));
    }
    ~Draft() {
        if (descriptor_ >= 0) close(descriptor_);
        if (!draft_.empty()) unlink(draft_.c_str());
    }
    Draft(Draft const&) = delete;
    Draft& operator=(Draft const&) = delete;

    void write(std::vector<std::uint8_t> const& bytes) {
        for (std::size_t done = 0; done < bytes.size();) {
            ssize_t const written = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) throw failure(file_, std::strerror(errno));
            done += static_cast<std::size_t>(written);
        }
    }

    void keep() {
        int const closed = close(std::exchange(descriptor_, -1));
        if (closed != 0 || std::rename(draft_.c_str(), file_.c_str()) != 0) throw failure(file_, std::strerror(errno));
        draft_.clear();
    }

private:
    std::filesystem::path file_;
    std::string draft_;  // empty when there is none to remove
    int descriptor_ = -1;
};

// Keeps its memory from one picture to the next: fresh memory for each costs as much as packing it.
class Encoder {
public:
    // Valid until the next call.
    std::vector<std::uint8_t> const& png(Pixels const& pixels) {
        if (!compressor_) throw std::runtime_error("no memory to pack a picture");
        lay_out_rows(pixels);
        bytes_.assign({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        std::size_t const header = begin_chunk("IHDR");
        append_number(static_cast<std::uint32_t>(pixels.width));
        append_number(static_cast<std::uint32_t>(pixels.height));
        constexpr std::uint8_t bits = 8, rgb = 2;
        for (std::uint8_t const byte : {bits, rgb, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}})
            bytes_.push_back(byte);
        end_chunk(header);
        std::size_t const data = begin_chunk("IDAT");
        append_packed_rows();
        end_chunk(data);
        end_chunk(begin_chunk("IEND"));
        return bytes_;
    }

private:
    // Each row begins with the number of its filter: none, which is fastest to write and packs drawings well.
    void lay_out_rows(Pixels const& pixels) {
        auto const width = static_cast<std::size_t>(pixels.width), height = static_cast<std::size_t>(pixels.height);
        rows_.resize((1 + 3 * width) * height + 1);
        std::uint8_t* row = rows_.data();
        std::uint8_t const* from = pixels.rgba.data();
        for (std::size_t y = 0; y < height; ++y, row += 1 + 3 * width) {
            // Four bytes at a time: the fourth is overwritten by the next pixel, and the last one by the next row.
            for (std::size_t x = 0; x < width; ++x, from += 4) std::memcpy(row + 1 + 3 * x, from, 4);
            *row = 0;
        }
    }

    void append_packed_rows() {
        std::size_t const size = rows_.size() - 1, start = bytes_.size();
        bytes_.resize(start + libdeflate_zlib_compress_bound(compressor_.get(), size));
        std::size_t const packed = libdeflate_zlib_compress(compressor_.get(), rows_.data(), size,
                                                            bytes_.data() + start, bytes_.size() - start);
        bytes_.resize(start + packed);
    }

    void append_number(std::uint32_t number) {
        for (int shift = 24; shift >= 0; shift -= 8) bytes_.push_back(static_cast<std::uint8_t>(number >> shift));
    }

    // A chunk is the length of its data, its kind, the data, and a check of the last two (PNG 1.2, 3.2).
    std::size_t begin_chunk(char const* kind) {
        std::size_t const start = bytes_.size();
        append_number(0);
        bytes_.insert(bytes_.end(), kind, kind + 4);
        return start;
    }
    void end_chunk(std::size_t start) {
        auto const length = static_cast<std::uint32_t>(bytes_.size() - start - 8);
        for (std::size_t i = 0; i < 4; ++i) bytes_[start + i] = static_cast<std::uint8_t>(length >> (24 - 8 * i));
        append_number(libdeflate_crc32(0, bytes_.data() + start + 4, length + 4));
    }

    // The fastest level: a sequence of pictures is limited by how fast they are packed.
    static constexpr int level_ = 1;
    std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor_{
        libdeflate_alloc_compressor(level_), libdeflate_free_compressor};
    std::vector<std::uint8_t> rows_, bytes_;
};

Encoder& encoder_of_this_thread() {
    thread_local Encoder encoder;
    return encoder;
}

}  // namespace

void write_png(std::filesystem::path const& file, Pixels const& pixels) {
    auto const& bytes = encoder_of_this_thread().png(pixels);
    Draft draft(file);
    draft.write(bytes);
    draft.keep();
}

}  // namespace screen
