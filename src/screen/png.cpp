#include "screen/png.h"

#include <fcntl.h>
#include <libdeflate.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

namespace {

// zlib at its fastest level: a sequence of pictures is limited by how fast they are packed.
unsigned char* packed(unsigned char* data, int length, int* packed_length, int) {
    constexpr int level = 1;
    std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> const compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) return nullptr;
    auto const size = static_cast<std::size_t>(length);
    std::size_t const room = libdeflate_zlib_compress_bound(compressor.get(), size);
    auto* const out = static_cast<unsigned char*>(std::malloc(room));
    if (!out) return nullptr;
    *packed_length = static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, size, out, room));
    return out;
}

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STBIW_ZLIB_COMPRESS packed
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#pragma GCC diagnostic pop

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

std::vector<std::uint8_t> without_alpha(Pixels const& pixels) {
    std::size_t const count = pixels.rgba.size() / 4;
    std::vector<std::uint8_t> rgb(3 * count + 1);
    // Four bytes at a time, the fourth is overwritten by the next pixel.
    for (std::size_t i = 0; i < count; ++i) std::memcpy(rgb.data() + 3 * i, pixels.rgba.data() + 4 * i, 4);
    return rgb;
}

}  // namespace

std::vector<std::uint8_t> png_of(Pixels const& pixels) {
    static int const no_filter = stbi_write_force_png_filter = 0;
    static_cast<void>(no_filter);
    int length = 0;
    std::unique_ptr<unsigned char, decltype(&std::free)> const bytes(
        stbi_write_png_to_mem(without_alpha(pixels).data(), 3 * pixels.width, pixels.width, pixels.height, 3, &length),
        std::free);
    if (!bytes) throw std::runtime_error("no memory to pack a picture");
    return {bytes.get(), bytes.get() + length};
}

void write_png(std::filesystem::path const& file, Pixels const& pixels) {
    auto const bytes = png_of(pixels);
    Draft draft(file);
    draft.write(bytes);
    draft.keep();
}

Pixels read_png(std::filesystem::path const& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw failure(file, std::strerror(errno));
    std::vector<char> const bytes{std::istreambuf_iterator<char>(stream), {}};
    Pixels pixels;
    int channels = 0;
    std::unique_ptr<unsigned char, decltype(&std::free)> const decoded(
        stbi_load_from_memory(reinterpret_cast<unsigned char const*>(bytes.data()), static_cast<int>(bytes.size()),
                              &pixels.width, &pixels.height, &channels, 4),
        std::free);
    if (!decoded) throw failure(file, stbi_failure_reason());
    pixels.rgba.assign(decoded.get(), decoded.get() + 4 * static_cast<std::size_t>(pixels.width) *
                                                          static_cast<std::size_t>(pixels.height));
    return pixels;
}

}  // namespace screen
