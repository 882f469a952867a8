#include <doctest/doctest.h>

#include "game/what_if.h"
#include "scenes/levels.h"

using geometry::Vec2;

namespace {

std::vector<physics::Method> const foreseen = {physics::Exact{}, physics::Steps{}, physics::Article{}};

game::Session session_under(physics::Method const& method) {
    game::Session session = game::session_of(scenes::read_level(ASSETS "/levels/01-sunny-hills.svg"), method);
    Vec2 const start = session.level->scene.balls[0].start.position;
    game::act(session, game::Grab{0, start + Vec2(1, 1.5)});
    game::advance(session, 0.25);
    return session;
}

}  // namespace

TEST_CASE("a glimpse of a method is what then comes, bit by bit") {
    for (physics::Method const& method : foreseen) {
        CAPTURE(physics::name_of(method));
        game::Session session = session_under(method);
        physics::History const coming = game::what_if(session, game::Release{}, 1);
        game::act(session, game::Release{});
        game::advance(session, 1.25);
        for (double const t : {0.3, 0.7, 1.0, 1.25})
            CHECK(physics::state_at(coming, 0, t).position == physics::state_at(session.history, 0, t).position);
    }
}

TEST_CASE("a glimpse of a pull beyond the reach counts on the hook that goes along") {
    for (physics::Method const& method : foreseen) {
        CAPTURE(physics::name_of(method));
        game::Session session = session_under(method);
        Vec2 const pointer = session.level->scene.balls[0].start.position + Vec2(90, 30);
        physics::History const coming = game::what_if_held(session, pointer, 1);
        game::act(session, game::Move{pointer});
        game::advance_held(session, 0.25, 1.25, [&](double) { return pointer; });
        CHECK(session.inputs.size() == 62);  // the grab, the move, and one every 1/60 s
        for (double const t : {0.3, 0.7, 1.0, 1.25})
            CHECK(physics::state_at(coming, 0, t).position == physics::state_at(session.history, 0, t).position);
    }
}

TEST_CASE("a glimpse changes nothing of the game") {
    game::Session session = session_under(physics::Exact{});
    game::Session const before = session;
    game::what_if(session, game::Move{Vec2(3, 3)}, 2);
    game::what_if(session, std::nullopt, 2);
    game::what_if_held(session, Vec2(30, 30), 2);
    CHECK(session.world.time == before.world.time);
    CHECK(session.world.forces == before.world.forces);
    CHECK(session.inputs.size() == before.inputs.size());
    CHECK(session.history.legs[0].size() == before.history.legs[0].size());
    CHECK(session.history.events.size() == before.history.events.size());
    game::advance(session, 1);
    game::Session untouched = before;
    game::advance(untouched, 1);
    CHECK(game::state_hash(session, 1) == game::state_hash(untouched, 1));
}
