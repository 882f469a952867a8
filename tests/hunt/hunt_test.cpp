#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <doctest/doctest.h>

#include "hunt/ground.h"
#include "hunt/judge.h"
#include "hunt/kinds.h"
#include "hunt/otherwise.h"
#include "hunt/shrink.h"
#include "support/sanitized.h"

using hunt::Bow;
using hunt::Line;
using hunt::Sketch;
using hunt::Vec2;

namespace {

constexpr std::uint64_t seeds = sanitized ? 6 : 40, seeds_of_steps = sanitized ? 2 : 10;  // of each kind

void hold(physics::Method const& method, std::string const& kind, std::uint64_t seed) {
    auto const verdict = hunt::judged(hunt::sketch_of(kind, seed), method, hunt::Clock::ignored);
    for (hunt::Finding const& finding : verdict.findings)
        FAIL_CHECK(kind << " " << seed << ": " << std::string(hunt::name_of(finding.wrong)) << " " << finding.measured
                        << " at " << finding.time << " s " << finding.words);
}

void hold(physics::Method const& method, std::uint64_t count) {
    for (std::string const& kind : hunt::kind_names())
        for (std::uint64_t seed = 0; seed < count; ++seed) hold(method, kind, seed);
}

// A ball above the middle of a line.
Sketch ball_on_line() {
    Sketch sketch;
    sketch.elements.push_back({{Line{{1, 1}, {15, 1}}}, {}});
    sketch.ball.start.position = {8, 3};
    sketch.duration = 2;
    return sketch;
}

}  // namespace

TEST_CASE("one ball under exact: nothing falls through, whatever is drawn and however it is pulled") {
    hold(physics::Exact{}, seeds);
}

TEST_CASE("what the hunt has found stays mended") {
    struct Found {
        char const* kind;
        std::uint64_t seed;
    };
    constexpr Found all[] = {
        {"twice", 50028},           // a spinning ball held by rounding: an end of the leg in the past
        {"rounded", 50143},         // the vertex of a joint met before the joint
        {"rounded+player", 50099},  // the same
        {"rounded+player", 50142},  // pulled against more resistance than grip carries: endless changes of law
        {"gaps+player", 50020},     // two arcs crossed half a turn's first order away
        {"narrow+player", 50210},   // into an arc of the ball's own radius, found 2e-8 m late
        {"narrow", 50080},          // out of it, found to close
        {"narrow", 50128},          // into it: pushed by points that hung on how it was drawn
        {"narrow", 50236},          // the mouth of a slot grazed
        {"narrow", 50239},          // let go in a slot that friction holds
        {"narrow", 50161},          // 28 bounces a millisecond, for ever
        {"narrow", 80058},          // at rest in the air at the end of an arc, where it jammed
        {"gaps", 93480},            // in a valley of 3e-13 rad, hops below rounding for ever
        {"gaps", 95648},            // dropped between the feet of two lines that turn by 4e-8 rad: through
        {"narrow+player", 70987},   // between two walls as far apart as the ball is wide, 6,000 times to and fro
        {"zero-g+player", 100483},  // drawn up past a wall and an end by which it was held, in one order of the two
        {"gaps", 100007},           // dropped on a joint: the piece that came first in the file
        {"gaps", 300586},           // and the one that rounding made the faster
        {"arcs", 100289},           // straight down on the end of a wall, grazed within rounding
        {"grid", 100192},           // back on to an arc along its tangent, 1e-8 m sooner or later
        {"grid", 100646},           // met within touch of an end, before its gap closed
        {"gaps", 100886},           // a joint of 3e-6 rad, whose tracks cross anywhere within 1e-9 m
        {"narrow", 100243},         // into an arc of its own radius, met past its middle
        {"narrow", 90091},          // out of it along a tangent
        {"narrow", 82877},          // and over its other end
        {"narrow", 600417},  // lifted off the inner arc of a slot where the third derivative alone closes the outer gap
        {"narrow", 601096},  // the same
        {"narrow+player", 801013},  // through a cup narrower by 1e-9 m, between its ends and nothing
        {"narrow+player", 900009},  // thrown off and back by its spin alone
        {"twice+player", 801940},   // spinning in a corner whose slope is as steep as its friction: no number
        {"zero-g", 1000256},        // in a socket with full grip, and without weight: infinity times 0
        {"arcs+player", 1000303},   // bouncing 400 times in a sixtieth of a second, but not by its spin
        {"gaps", 801983},           // creeping past the end of what it crept along
        {"narrow+player", 700527},  // on the spring
        {"narrow", 600637},         // creeping up and away from what then held it against gravity
        {"narrow", 97347},          // on both corners of a slot at once: 6e-8 of its energy more
    };
    for (Found const& found : all) hold(physics::Exact{}, found.kind, found.seed);
}

TEST_CASE("one ball under steps: nothing falls through either") { hold(physics::Steps{}, seeds_of_steps); }

TEST_CASE("dice are splitmix64") {
    hunt::Dice dice(0);
    CHECK(dice.next() == 0xe220a8397b1dcdafULL);  // from the authors' program
    CHECK(dice.next() == 0x6e789e6aa1b965f4ULL);
}

TEST_CASE("the judge's own sight of lines and arcs") {
    CHECK(hunt::foot_on(hunt::bar({0, 0}, {4, 0}), {1, 2}).distance == 2);
    CHECK(hunt::foot_on(hunt::bar({0, 0}, {4, 0}), {7, 4}).distance == 5);
    // Three quarters of the unit circle, from the right over the top to the bottom.
    hunt::Limb const limb = hunt::limb_of(Bow{{1, 0}, {0, -1}, 1, true, true});
    CHECK(hunt::foot_on(limb, {0, 3}).distance == doctest::Approx(2).epsilon(1e-15));
    CHECK(hunt::foot_on(limb, {2, -2}).distance == doctest::Approx(std::sqrt(5)).epsilon(1e-15));  // from an end
    CHECK(limb.sweep == doctest::Approx(1.5 * std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("a drawing is read as it was drawn") {
    Sketch sketch = ball_on_line();
    sketch.elements.push_back({{Bow{{3, 5}, {5, 5}, 1.25, false, true}, Line{{5, 5}, {6, 5}}}, {0.25, 0.5, 0.125}});
    level::Level const level = hunt::level_of(sketch);
    hunt::Ground const drawn = hunt::ground_of(sketch.elements), read = hunt::ground_of(level.scene.terrain);
    REQUIRE(read.size() == 3);
    for (Vec2 const& from : {Vec2(4, 3), Vec2(4, 6), Vec2(5.5, 4), Vec2(2, 0)})
        CHECK(hunt::nearest_on(read, from).distance ==
              doctest::Approx(hunt::nearest_on(drawn, from).distance).epsilon(1e-14));
    // The arc turns left and so lies below its chord, by r - sqrt(r^2 - 1) = 0.5.
    CHECK(hunt::nearest_on(read, {4, 4}).distance == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(level.scene.balls[0].start.position == Vec2(8, 3));
}

TEST_CASE("what is split and turned round covers the same points") {
    hunt::Dice dice(3);
    Bow const bow{{1, 0}, {0, -1}, 1, true, true};
    auto const parts = hunt::split(dice, bow);
    REQUIRE(parts.size() == 2);
    CHECK(hunt::to_of(parts[0]) == hunt::from_of(parts[1]));
    double sweep = 0;
    for (hunt::Stroke const& part : parts) {
        hunt::Limb const back = hunt::limb_of(std::get<Bow>(hunt::backwards(part)));
        CHECK(geometry::length(back.centre) <= 1e-14);
        sweep += back.sweep;
    }
    CHECK(sweep == doctest::Approx(-1.5 * std::numbers::pi).epsilon(1e-14));
}

TEST_CASE("a case is cut down to what it hangs on") {
    Sketch sketch = hunt::sketch_of("stones+player", 1);
    sketch.elements.push_back({{Line{{1.2345, 10.5}, {14.321, 10.5}}, Line{{2, 11}, {3, 12}}}, {}});
    auto const has_the_line = [](Sketch const& s) {
        for (hunt::Element const& element : s.elements)
            for (hunt::Stroke const& stroke : element.strokes)
                if (hunt::from_of(stroke).x() > 1.2 && hunt::from_of(stroke).x() < 1.3 && hunt::to_of(stroke).x() > 14)
                    return true;
        return false;
    };
    Sketch const small = hunt::shrunk(sketch, 1, has_the_line);
    REQUIRE(small.elements.size() == 1);
    REQUIRE(small.elements[0].strokes.size() == 1);
    CHECK(small.inputs.empty());
    CHECK(small.duration <= 1.05);
    CHECK(hunt::from_of(small.elements[0].strokes[0]).x() == 1.23);
}

TEST_CASE("what the program refuses is found") {
    Sketch sketch = ball_on_line();
    sketch.ball.start.position = {8, 1.2};  // 0.3 m inside
    auto const verdict = hunt::judged(sketch, physics::Exact{}, hunt::Clock::ignored);
    REQUIRE(verdict.findings.size() == 1);
    CHECK(verdict.findings[0].wrong == hunt::Wrong::refused);
    CHECK(hunt::judged(ball_on_line(), physics::Exact{}, hunt::Clock::ignored).findings.empty());
}
