#include "game/medals.h"

#include <doctest/doctest.h>

#include "game/best_times.h"
#include "game/lessons.h"
#include "support/folder.h"

using game::Medal;

namespace {

level::Level level_that_asks(std::optional<double> time, std::optional<int> pulls, int bananas) {
    level::Level level;
    level.hash = "00000000000000cd";
    level.pars = {time, pulls};
    level.meanings.assign(static_cast<std::size_t>(bananas), level::Meaning::banana);
    level.meanings.push_back(level::Meaning::goal);
    return level;
}

game::Status reached(double time, int pulls, int bananas) {
    game::Status status;
    status.goal_time = time;
    status.pulls = pulls;
    status.bananas = bananas;
    return status;
}

}  // namespace

TEST_CASE("gold is all that is asked for, silver all but one, bronze the goal") {
    level::Level const level = level_that_asks(10, 2, 3);
    CHECK(game::medal_for(level, reached(10, 2, 3)) == Medal::gold);
    CHECK(game::medal_for(level, reached(10.01, 2, 3)) == Medal::silver);
    CHECK(game::medal_for(level, reached(9, 3, 3)) == Medal::silver);
    CHECK(game::medal_for(level, reached(9, 0, 2)) == Medal::silver);
    CHECK(game::medal_for(level, reached(9, 3, 2)) == Medal::bronze);
    CHECK(game::medal_for(level, reached(11, 3, 0)) == Medal::bronze);
    CHECK(game::medal_for(level, game::Status{}) == Medal::none);
}

TEST_CASE("what is not asked for is not missed, and nothing asked for is no medal") {
    CHECK(game::medal_for(level_that_asks({}, {}, 2), reached(99, 99, 2)) == Medal::gold);
    CHECK(game::medal_for(level_that_asks({}, {}, 2), reached(99, 99, 1)) == Medal::silver);
    CHECK(game::medal_for(level_that_asks({}, 0, 0), reached(99, 0, 0)) == Medal::gold);
    CHECK(game::medal_for(level_that_asks({}, {}, 0), reached(1, 0, 0)) == Medal::none);
}

TEST_CASE("the better medal is kept, and what was learnt; a list that is none is set aside") {
    support::DataFolder const folder;
    level::Level const level = level_that_asks(10, 2, 3);
    CHECK(game::best_medals().empty());
    game::note_medal(level, Medal::silver);
    game::note_medal(level, Medal::bronze);
    CHECK(game::best_medals().at(level.hash) == Medal::silver);
    game::note_medal(level, Medal::gold);
    CHECK(game::best_medals().at(level.hash) == Medal::gold);

    CHECK(game::learnt_lessons().empty());
    game::note_learnt(game::Lesson::tilt);
    CHECK(game::learnt_lessons() == std::set{game::Lesson::tilt});
    std::string const file = folder.file("learnt.json", "{\"pull\"");
    CHECK(game::learnt_lessons().empty());
    game::note_learnt(game::Lesson::pull);
    CHECK(game::learnt_lessons() == std::set{game::Lesson::pull});
    CHECK(std::filesystem::exists(file + ".spoilt"));
}
