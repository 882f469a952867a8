#include "sound/hear.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "listening.h"
#include "sound/timbre.h"

using sound::Score;
using sound::Timbre;
using namespace sound_test;

namespace {

double falling_time(double height) { return std::sqrt(2 * height / g); }

std::vector<sound::Note> notes_of(Score const& score, Timbre timbre) {
    std::vector<sound::Note> notes;
    std::copy_if(score.notes.begin(), score.notes.end(), std::back_inserter(notes),
                 [&](sound::Note const& note) { return note.timbre == timbre; });
    return notes;
}

sound::Note only_note_of(Score const& score) {
    REQUIRE(score.notes.size() == 1);
    return score.notes.front();
}

// The mean of its frequencies below 8 kHz by power, Hz.
double brightness_of(std::vector<double> const& samples) {
    double sum = 0, weighted = 0;
    for (double frequency = 50; frequency < 8000; frequency += 50) {
        double const power = std::pow(strength_at(samples, frequency), 2);
        sum += power;
        weighted += power * frequency;
    }
    return weighted / sum;
}

level::Level rolling_level(double speed, physics::Material const& material = {}) {
    level::Level level = floor_level(0, material);
    level.scene.balls = {disc(0.4, {0, 1.4}, {speed, 0}, -speed / 0.4)};
    return level;
}

}  // namespace

TEST_CASE("a ball that falls is heard from the sample at which it lands, and not before") {
    for (double const height : {0.3, 1.0, 2.5}) {
        auto const landed = std::llround(falling_time(height) * sound::rate);
        auto const heard = sound::samples(score_of(floor_level(height), 1.2), 0, 48000);
        CHECK(onset_of(heard) == landed);
    }
}

TEST_CASE("each bounce is heard at its sample, softer than the one before") {
    double const height = 1.5, e = 0.6;
    Score const score = score_of(floor_level(height, {0.9, e, 0}), 2.5);
    auto const notes = notes_of(score, Timbre::rubber);
    REQUIRE(notes.size() >= 4);
    double time = falling_time(height), flight = 2 * time;
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(notes[i].start == std::llround(time * sound::rate));
        time += flight *= e;
        if (i > 0) CHECK(notes[i].loudness < notes[i - 1].loudness);
    }
    // The blow changes the velocity by (1 + e) times the speed of the fall.
    CHECK(notes[0].loudness == doctest::Approx(sound::loudness_of_blow((1 + e) * g * falling_time(height))));
}

TEST_CASE("a blow is the louder the harder, and none below the faintest") {
    CHECK(sound::loudness_of_blow(0) == 0);
    CHECK(sound::loudness_of_blow(sound::faintest_blow) == 0);
    CHECK(sound::loudness_of_blow(sound::faintest_blow + 1e-9) < 1e-8);
    for (double speed = 0.2; speed < 20; speed += 0.1)
        CHECK(sound::loudness_of_blow(speed) < sound::loudness_of_blow(speed + 0.1));
    CHECK(sound::loudness_of_blow(1e6) <= 0.5);
}

TEST_CASE("what a ball falls on is heard") {
    CHECK(only_note_of(score_of(floor_level(1), 0.6)).timbre == Timbre::wood);
    CHECK(only_note_of(score_of(floor_level(1, {0.03, 0, 0}), 0.6)).timbre == Timbre::glass);
    CHECK(only_note_of(score_of(floor_level(1, {0.9, 0.9, 0}), 0.6)).timbre == Timbre::rubber);
    auto const spectrum_on = [](physics::Material const& material) {
        return brightness_of(left_of(sound::samples(score_of(floor_level(1, material), 0.6), 20000, 9600)));
    };
    double const wood = spectrum_on({}), glass = spectrum_on({0.03, 0, 0}), rubber = spectrum_on({0.9, 0.9, 0});
    CHECK(rubber < wood);
    CHECK(wood < glass / 1.5);
}

TEST_CASE("a larger ball sounds lower") {
    level::Level large = floor_level(1);
    large.scene.balls = {disc(0.8, {8, 2.8})};
    CHECK(only_note_of(score_of(large, 0.6)).pitch < 0.8 * only_note_of(score_of(floor_level(1), 0.6)).pitch);
}

TEST_CASE("two balls that meet click once") {
    level::Level const level = level_with({disc(0.4, {8, 1.4}, {2, 0}), disc(0.4, {11, 1.4})}, 0);
    sound::Note const note = only_note_of(score_of(level, 2));
    CHECK(note.timbre == Timbre::marble);
    CHECK(note.start == std::llround((3 - 0.8) / 2 * sound::rate));
}

TEST_CASE("a ball at rest is silent") {
    for (float const sample : sound::samples(score_of(floor_level(0), 1), 0, 40000)) REQUIRE(sample == 0);
}

TEST_CASE("a ball in flight is silent") {
    for (float const sample : sound::samples(score_of(floor_level(5), 0.9), 0, 40000)) REQUIRE(sample == 0);
}

TEST_CASE("rolling is the louder and the higher the faster") {
    auto const heard = [](double speed) {
        return left_of(sound::samples(score_of(rolling_level(speed), 1), 9600, 38400));
    };
    auto const slow = heard(1), fast = heard(6);
    CHECK(power_of(slow) > 0);
    CHECK(power_of(fast) > 2 * power_of(slow));
    CHECK(brightness_of(fast) > 1.5 * brightness_of(slow));
}

TEST_CASE("rolling is as loud at its end as its speed is there") {
    Score const score = score_of(rolling_level(4, {0.9, 0, 0.1}), 10);
    CHECK(score.motions.rows[0].front().roll > 0.1);
    CHECK(score.motions.rows[0].back().roll == 0);  // c g makes 0.65 m/s^2: it has come to rest
}

TEST_CASE("a ball that slides hisses until it grips") {
    level::Level level = rolling_level(6, {0.2, 0, 0});
    level.scene.balls[0].start.spin = 0;
    Score const score = score_of(level, 2);
    // Slip ends at v / (mu g (1 + 1/k)).
    double const grips = 6 / (0.2 * g * 3);
    auto const& rows = score.motions.rows[0];
    for (std::size_t i = 0; i < rows.size(); ++i) {
        double const time =
            static_cast<double>(score.motions.first + static_cast<long long>(i)) * sound::motion_step / sound::rate;
        CHECK((rows[i].slip > 0) == (time < grips));
    }
}

TEST_CASE("however a game is cut into stretches, the same is heard") {
    level::Level const level = [] {
        level::Level rough = rolling_level(5, {0.4, 0.5, 0});
        rough.scene.balls[0].start.position.y() += 0.7;
        return rough;
    }();
    std::vector<game::Input> const inputs{{0.3, game::Grab{0, Vec2(4, 4)}}, {0.9, game::Release{}}};
    auto const at_once = sound::samples(score_of(level, 2, 10, inputs), 0, 96000);
    for (double const stretch : {1.0 / 60, 1.0 / 24, 0.1777})
        CHECK(sound::samples(score_of(level, 2, stretch, inputs), 0, 96000) == at_once);
}

TEST_CASE("slow motion hears later what happens later, at the same pitch") {
    game::Session session = session_of(floor_level(1));
    game::advance(session, 1);
    Score score;
    sound::Clock const clock{0, 5000, 4 * sound::rate};
    sound::hear(score, session, -1, 1, clock);
    CHECK(only_note_of(score).start == 5000 + std::llround(4 * falling_time(1) * sound::rate));
    CHECK(only_note_of(score).pitch == only_note_of(score_of(floor_level(1), 1)).pitch);
}

TEST_CASE("bananas, the goal, a fall and the end of the time are heard at their sample") {
    level::Level level = rolling_level(2);
    add_sensor(level, level::Meaning::banana, physics::LineRegion{Vec2(1, 0), Vec2(1, 5)});
    add_sensor(level, level::Meaning::banana, physics::LineRegion{Vec2(2, 0), Vec2(2, 5)});
    add_sensor(level, level::Meaning::goal, physics::LineRegion{Vec2(3, 0), Vec2(3, 5)});
    Score const won = score_of(level, 2);
    auto const plings = notes_of(won, Timbre::pling);
    REQUIRE(plings.size() == 4);
    CHECK(plings[0].start == sound::rate / 2);
    CHECK(plings[2].start == sound::rate);
    CHECK(plings[2].pitch > plings[0].pitch);
    auto const bells = notes_of(won, Timbre::bell);
    REQUIRE(bells.size() > 3);
    CHECK(bells.front().start == 3 * sound::rate / 2);
    for (sound::Note const& bell : bells)
        CHECK(bell.start + sound::length_of(bell) <= bells.front().start + sound::longest_note * sound::rate);

    level.meanings[2] = level::Meaning::fall;
    auto const whistles = notes_of(score_of(level, 2), Timbre::whistle);
    REQUIRE(whistles.size() == 1);
    CHECK(whistles[0].start == 3 * sound::rate / 2);

    level.time_limit = 1.25;
    CHECK(notes_of(score_of(level, 2), Timbre::whistle).empty());
    auto const gongs = notes_of(score_of(level, 2), Timbre::gong);
    REQUIRE(gongs.size() == 1);
    CHECK(gongs[0].start == 5 * sound::rate / 4);
}

TEST_CASE("the spring hums while it is drawn, and twangs when it is let go") {
    std::vector<game::Input> const inputs{{0.5, game::Grab{0, Vec2(9, 1.6)}},
                                          {0.5625, game::Release{}}};  // before it has settled
    Score const score = score_of(floor_level(0), 1, 10, inputs);
    auto const twangs = notes_of(score, Timbre::twang);
    REQUIRE(twangs.size() == 2);
    CHECK(twangs[0].start == sound::rate / 2);
    CHECK(twangs[1].start == 9 * sound::rate / 16);
    CHECK(twangs[1].loudness > twangs[0].loudness);
    for (std::size_t i = 0; i < score.motions.rows[0].size(); ++i) {
        double const time =
            static_cast<double>(score.motions.first + static_cast<long long>(i)) * sound::motion_step / sound::rate;
        CHECK((score.motions.rows[0][i].tension > 0) == (time >= 0.5 && time < 0.5625));
    }
}

TEST_CASE("the colours behind a level choose its tune") {
    auto const world = [](std::vector<std::string> const& sky, std::vector<std::string> const& hills) {
        level::Level level;
        level.look.sky = sky;
        level.look.hills = hills;
        return sound::world_of(level);
    };
    CHECK(world({}, {}) == sound::World::meadow);
    CHECK(world({"#5aa9e6", "#e8f7e4"}, {"#bfe0d0", "#9ccfb2", "#82bf9a"}) == sound::World::meadow);
    CHECK(world({"#f0a561", "#fff1d6"}, {"#edc29b", "#e0a97f", "#cf9068"}) == sound::World::desert);
    CHECK(world({"#7fb8de", "#f2fbff"}, {"#cfe4f1", "#b3d4e8", "#98c3dd"}) == sound::World::ice);
    CHECK(world({"#141b3c", "#4a4a86"}, {"#34386b", "#2a2d59", "#212448"}) == sound::World::night);
    CHECK(world({"none", "none"}, {}) == sound::World::meadow);
}
