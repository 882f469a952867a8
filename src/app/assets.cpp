#include "app/assets.h"

#include <algorithm>

namespace app {

namespace files = std::filesystem;

namespace {

std::vector<files::path> drawings_in(char const* folder) {
    std::vector<files::path> drawings;
    auto const assets = asset_folder();
    if (!assets) return drawings;
    std::error_code missing;
    for (files::directory_entry const& entry : files::directory_iterator(*assets / folder, missing))
        if (entry.path().extension() == ".svg") drawings.push_back(entry.path());
    std::sort(drawings.begin(), drawings.end());
    return drawings;
}

}  // namespace

std::optional<files::path> asset_folder() {
    std::error_code error;
    files::path const program = files::read_symlink("/proc/self/exe", error);
    if (!error) {
        files::path const installed = (program.parent_path() / "../share/smb2d/assets").lexically_normal();
        if (files::is_directory(installed, error)) return installed;
    }
    files::path const checkout = SMB2D_SOURCE_ASSETS;
    if (files::is_directory(checkout, error)) return checkout;
    return std::nullopt;
}

std::vector<files::path> shipped_levels() { return drawings_in("levels"); }

std::optional<files::path> shipped_run_of(files::path const& level) {
    auto const assets = asset_folder();
    if (!assets) return std::nullopt;
    files::path const run = *assets / "runs" / (level.stem().string() + ".json");
    std::error_code missing;
    return files::is_regular_file(run, missing) ? std::optional(run) : std::nullopt;
}

std::vector<files::path> shipped_experiments() { return drawings_in("lab"); }

}  // namespace app
