#include "game/data_files.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "game/whole_file.h"

namespace game {

namespace {

constexpr std::size_t largest_data_file = 1u << 20;  // bytes

std::optional<std::filesystem::path> data_file(char const* name) {
    auto const folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder / name;
}

}  // namespace

std::optional<std::filesystem::path> data_folder() {
    // A relative path there is to be ignored, says the XDG base directory specification.
    char const* const data = std::getenv("XDG_DATA_HOME");
    if (data && data[0] == '/') return std::filesystem::path(data) / "smb2d";
    char const* const home = std::getenv("HOME");
    if (home && home[0] == '/') return std::filesystem::path(home) / ".local/share/smb2d";
    return std::nullopt;
}

std::optional<nlohmann::json> read_data_file(char const* name) {
    auto const file = data_file(name);
    std::error_code missing;
    if (!file || !std::filesystem::is_regular_file(*file, missing)) return std::nullopt;
    return nlohmann::json::parse(read_whole_file(file->string(), largest_data_file));
}

std::optional<std::filesystem::path> write_data_file(char const* name, nlohmann::json const& root, int indent,
                                                     bool spoilt, char const* failure) {
    auto const file = data_file(name);
    if (!file) throw std::runtime_error(std::string(failure) + ": neither XDG_DATA_HOME nor HOME is set");
    std::optional<std::filesystem::path> aside;
    if (spoilt) aside = set_aside(*file);
    write_whole_file(file->string(), root.dump(indent) + "\n");
    return aside;
}

}  // namespace game
