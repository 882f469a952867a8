#include "screen/film.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <optional>

namespace screen {
namespace {

class Bytes {
public:
    explicit Bytes(std::filesystem::path const& file) : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
        struct stat status {};
        if (descriptor_ >= 0 && fstat(descriptor_, &status) == 0) size_ = static_cast<std::uint64_t>(status.st_size);
    }
    ~Bytes() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    Bytes(Bytes const&) = delete;
    Bytes& operator=(Bytes const&) = delete;

    std::uint64_t size() const { return size_; }

    // Big-endian, of at most eight bytes; nothing where they are not there.
    std::optional<std::uint64_t> number(std::uint64_t at, int count) const {
        std::array<unsigned char, 8> bytes{};
        if (pread(descriptor_, bytes.data(), static_cast<std::size_t>(count), static_cast<off_t>(at)) != count)
            return std::nullopt;
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) value = value << 8 | bytes[static_cast<std::size_t>(i)];
        return value;
    }

private:
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

// A box of MP4 or an element of Matroska: a kind, a size, what it holds.
struct Part {
    std::uint64_t kind = 0;
    std::uint64_t body = 0, end = 0;  // bytes from the file's beginning; the end may lie beyond the file's
    bool open = false;                // its size was not known yet when it was begun
};

constexpr std::uint64_t four_letters(char const (&word)[5]) {
    std::uint64_t code = 0;
    for (int i = 0; i < 4; ++i) code = code << 8 | static_cast<unsigned char>(word[i]);
    return code;
}

std::optional<Part> box_at(Bytes const& bytes, std::uint64_t at) {
    auto const size = bytes.number(at, 4), kind = bytes.number(at + 4, 4);
    if (!size || !kind) return std::nullopt;
    if (*size >= 8) return Part{*kind, at + 8, at + *size};
    auto const large_size = *size == 1 ? bytes.number(at + 8, 8) : std::nullopt;
    if (!large_size || *large_size < 16 || *large_size > bytes.size()) return std::nullopt;
    return Part{*kind, at + 16, at + *large_size};
}

// RFC 8794, 4: leading zeros tell the length; a size of ones alone is unknown.
std::optional<Part> element_at(Bytes const& bytes, std::uint64_t at) {
    auto const length_at = [&](std::uint64_t place) {
        auto const first = bytes.number(place, 1);
        return first ? std::countl_zero(static_cast<std::uint8_t>(*first)) + 1 : 9;
    };
    int const kind_length = length_at(at);
    if (kind_length > 4) return std::nullopt;
    std::uint64_t const size_at = at + static_cast<std::uint64_t>(kind_length);
    int const size_length = length_at(size_at);
    if (size_length > 8) return std::nullopt;
    auto const kind = bytes.number(at, kind_length), marked = bytes.number(size_at, size_length);
    if (!kind || !marked) return std::nullopt;
    std::uint64_t const ones = (std::uint64_t{1} << 7 * size_length) - 1, size = *marked & ones;
    std::uint64_t const body = size_at + static_cast<std::uint64_t>(size_length);
    return Part{*kind, body, body + size, size == ones};
}

// What `part_at` finds between two places, as far as it is whole; the place where that ends.
template <typename Reader, typename Visit>
std::uint64_t each_part(Bytes const& bytes, Reader part_at, std::uint64_t from, std::uint64_t to, Visit visit) {
    while (from < to) {
        std::optional<Part> const part = part_at(bytes, from);
        if (!part || part->open || part->end > to) break;
        visit(*part);
        from = part->end;
    }
    return from;
}

// A track's fragment (traf) says which track it is of (tfhd) and how many samples are in each of its runs (trun).
long long frames_in_fragment(Bytes const& bytes, Part const& moof) {
    long long frames = 0;
    each_part(bytes, box_at, moof.body, moof.end, [&](Part const& traf) {
        if (traf.kind != four_letters("traf")) return;
        bool is_first_track = false;
        each_part(bytes, box_at, traf.body, traf.end, [&](Part const& box) {
            std::uint64_t const after_flags = bytes.number(box.body + 4, 4).value_or(0);
            if (box.kind == four_letters("tfhd")) is_first_track = after_flags == 1;
            if (box.kind == four_letters("trun") && is_first_track) frames += static_cast<long long>(after_flags);
        });
    });
    return frames;
}

Film mp4_film(Bytes const& bytes) {
    Film film;
    long long promised = 0;  // frames, whose bytes follow
    bool has_index = false;
    std::uint64_t const end = each_part(bytes, box_at, 0, bytes.size(), [&](Part const& box) {
        if (box.kind == four_letters("moof")) promised = frames_in_fragment(bytes, box);
        has_index = box.kind == four_letters("mfra");
        if (box.kind != four_letters("mdat")) return;
        film.frames += promised;
        film.whole_bytes = box.end;
        promised = 0;
    });
    film.complete = has_index && end == bytes.size();
    return film;
}

namespace matroska {
constexpr std::uint64_t segment = 0x18538067, cluster = 0x1F43B675, cues = 0x1C53BB6B;
constexpr std::uint64_t simple_block = 0xA3, block_group = 0xA0, block = 0xA1;
constexpr std::uint64_t first_track = 0x81;  // the number 1, as a block begins with it
}  // namespace matroska

long long frames_in_cluster(Bytes const& bytes, Part const& cluster) {
    long long frames = 0;
    each_part(bytes, element_at, cluster.body, cluster.end, [&](Part const& element) {
        if (element.kind == matroska::block_group) frames += frames_in_cluster(bytes, element);
        bool const is_block = element.kind == matroska::simple_block || element.kind == matroska::block;
        if (is_block && bytes.number(element.body, 1) == matroska::first_track) ++frames;
    });
    return frames;
}

Film matroska_film(Bytes const& bytes) {
    Film film;
    auto const header = element_at(bytes, 0);
    auto const segment = header ? element_at(bytes, header->end) : std::nullopt;
    if (!segment || segment->kind != matroska::segment) return film;
    bool has_index = false;
    std::uint64_t const end = each_part(bytes, element_at, segment->body, bytes.size(), [&](Part const& element) {
        has_index = has_index || element.kind == matroska::cues;
        if (element.kind != matroska::cluster) return;
        film.frames += frames_in_cluster(bytes, element);
        film.whole_bytes = element.end;
    });
    film.complete = has_index && !segment->open && segment->end == bytes.size() && end == bytes.size();
    return film;
}

}  // namespace

Film film_in(std::filesystem::path const& file) {
    Bytes const bytes(file);
    return file.extension() == ".mkv" ? matroska_film(bytes) : mp4_film(bytes);
}

}  // namespace screen
