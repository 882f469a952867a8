// What ships with the program: where it lies, wherever the program is started.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace app {

// ../share/smb2d/assets beside an installed program, else the source checkout's; nothing where neither is there.
std::optional<std::filesystem::path> asset_folder();

// The levels of the game in the order in which they are played, by name.
std::vector<std::filesystem::path> shipped_levels();

// The run that shows how a level is won, as far as there is one.
std::optional<std::filesystem::path> shipped_run_of(std::filesystem::path const& level);

// The experiments with known answers, by name.
std::vector<std::filesystem::path> shipped_experiments();

}  // namespace app
