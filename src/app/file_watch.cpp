#include "app/file_watch.h"

namespace app {

namespace {

constexpr double between_looks = 0.1;  // s

}  // namespace

std::optional<FileStamp> stamp_of(std::string const& file) {
    std::error_code written_error, size_error;
    FileStamp const stamp{std::filesystem::last_write_time(file, written_error),
                          std::filesystem::file_size(file, size_error)};
    if (written_error || size_error) return std::nullopt;
    return stamp;
}

bool is_saved_anew(FileWatch& watch, std::string const& file, double elapsed) {
    watch.wait -= elapsed;
    if (watch.wait > 0) return false;
    watch.wait = between_looks;
    std::optional<FileStamp> const now = stamp_of(file);
    // While an editor is still writing, each look finds another file.
    bool const is_whole = now && now == watch.seen;
    watch.seen = now;
    if (!is_whole || now == watch.read) return false;
    watch.read = now;
    return true;
}

}  // namespace app
