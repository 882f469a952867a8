// Notices that a file has been saved, in place or by renaming another over it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace app {

struct FileStamp {
    std::filesystem::file_time_type written;
    std::uintmax_t size = 0;  // bytes
    bool operator==(FileStamp const&) const = default;
};

// Nothing where there is no such file.
std::optional<FileStamp> stamp_of(std::string const& file);

struct FileWatch {
    std::optional<FileStamp> read;  // of the file as it was last read
    std::optional<FileStamp> seen;  // at the last look
    double wait = 0;                // s on the wall until the next look
};

// Once for every time that the file has been saved since it was read. `elapsed` seconds have passed on the wall.
bool is_saved_anew(FileWatch& watch, std::string const& file, double elapsed);

}  // namespace app
