#include "game/lessons.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "game/best_times.h"
#include "game/whole_file.h"

namespace game {

namespace {

struct Name {
    Lesson lesson;
    char const* text;
};
constexpr Name names[] = {{Lesson::pull, "pull"}, {Lesson::tilt, "tilt"}};

std::optional<std::filesystem::path> lessons_file() {
    auto const folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder / "learnt.json";
}

struct ListedLessons {
    std::set<Lesson> lessons;
    bool spoilt = false;  // the file is there, but is no list
};

ListedLessons listed() {
    ListedLessons list;
    auto const file = lessons_file();
    std::error_code missing;
    if (!file || !std::filesystem::is_regular_file(*file, missing)) return list;
    try {
        auto const root = nlohmann::json::parse(read_whole_file(file->string(), 1u << 16));
        list.spoilt = !root.is_array();
        for (Name const& name : names)
            for (auto const& item : root)
                if (item == name.text) list.lessons.insert(name.lesson);
    } catch (std::exception const&) {
        list.spoilt = true;
    }
    return list;
}

}  // namespace

std::set<Lesson> learnt_lessons() { return listed().lessons; }

void note_learnt(Lesson lesson) {
    ListedLessons list = listed();
    if (!list.lessons.insert(lesson).second) return;
    auto const file = lessons_file();
    if (!file) throw std::runtime_error("what was learnt cannot be kept: neither XDG_DATA_HOME nor HOME is set");
    if (list.spoilt) set_aside(*file);
    auto root = nlohmann::json::array();
    for (Name const& name : names)
        if (list.lessons.contains(name.lesson)) root.push_back(name.text);
    write_whole_file(file->string(), root.dump() + "\n");
}

}  // namespace game
