#include "app/play_save.h"

#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "game/data_files.h"

namespace app {

namespace {

std::string date_and_time() {
    std::time_t const now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d-%H%M%S", &local);
    return text;
}

}  // namespace

std::string free_run_name(std::string const& level_file) {
    auto const folder = game::data_folder();
    if (!folder) throw std::runtime_error("neither XDG_DATA_HOME nor HOME says where runs are kept");
    std::string const name = std::filesystem::path(level_file).stem().string() + "-" + date_and_time();
    std::filesystem::path file = *folder / (name + ".json");
    for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(file)); ++i)
        file = *folder / (name + "-" + std::to_string(i) + ".json");
    return file.string();
}

game::Run run_to_save(game::Session const& session) {
    game::Run run = game::run_of(session);
    run.level_file = std::filesystem::absolute(run.level_file).lexically_normal().string();
    return run;
}

}  // namespace app
