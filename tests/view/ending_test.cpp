#include "view/ending.h"

#include <doctest/doctest.h>

#include "stages.h"

using view::Vec2;

namespace {

view::Moment won(double age) {
    view::Moment moment;
    moment.time = 2 + age;
    moment.status.goal_time = 2;
    return moment;
}

view::EndingNote note_with(std::string const& film) {
    view::EndingNote note;
    note.hint = "Enter: go on";
    note.film = film;
    return note;
}

}  // namespace

TEST_CASE("the card after the goal has the button that is asked for, and only there is it pressed") {
    level::Level const level = view_test::floor_level(16, 9);
    for (Vec2 const& size : {Vec2(1280, 720), Vec2(640, 360)}) {
        int with = 0, without = 0, before = 0;
        for (double y = 0; y < size.y(); y += 4)
            for (double x = 0; x < size.x(); x += 4) {
                Vec2 const pixel(x, y);
                with += view::is_on_film_button(level, won(1), pixel, size, note_with("Film it")) ? 1 : 0;
                without += view::is_on_film_button(level, won(1), pixel, size, note_with("")) ? 1 : 0;
                before += view::is_on_film_button(level, {}, pixel, size, note_with("Film it")) ? 1 : 0;
            }
        CHECK(with > 50);
        CHECK(without == 0);
        CHECK(before == 0);
    }
}

TEST_CASE("where motion is reduced nothing falls from the sky, and the card stands still") {
    level::Level const level = view_test::floor_level(16, 9);
    view::EndingNote note = note_with("");
    int const full = view_test::count_of<view::Stroke>(view::ending_shapes(level, won(1), {1280, 720}, note));
    note.motion = view::Motion::reduced;
    auto const early = view::ending_shapes(level, won(0.01), {1280, 720}, note);
    auto const late = view::ending_shapes(level, won(2), {1280, 720}, note);
    CHECK(full > view_test::count_of<view::Stroke>(early));
    REQUIRE(early.size() == late.size());
    auto const before = view_test::all_of<view::Label>(early), after = view_test::all_of<view::Label>(late);
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(before[i].height == after[i].height);
        CHECK(before[i].colour.alpha == after[i].colour.alpha);
    }
}
