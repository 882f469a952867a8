#include "game/lessons.h"

#include <exception>

#include <nlohmann/json.hpp>

#include "game/data_files.h"

namespace game {

namespace {

struct Name {
    Lesson lesson;
    char const* text;
};
constexpr Name names[] = {{Lesson::pull, "pull"}, {Lesson::tilt, "tilt"}};

constexpr char lessons_name[] = "learnt.json";

struct ListedLessons {
    std::set<Lesson> lessons;
    bool spoilt = false;  // the file is there, but is no list
};

ListedLessons listed() {
    ListedLessons list;
    try {
        auto const root = read_data_file(lessons_name);
        if (!root) return list;
        list.spoilt = !root->is_array();
        for (Name const& name : names)
            for (auto const& item : *root)
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
    auto root = nlohmann::json::array();
    for (Name const& name : names)
        if (list.lessons.contains(name.lesson)) root.push_back(name.text);
    write_data_file(lessons_name, root, -1, list.spoilt, "what was learnt cannot be kept");
}

}  // namespace game
