#include "game/run_file.h"

#include <doctest/doctest.h>

#include "game/whole_file.h"
#include "support/folder.h"

using support::Folder;
using support::message_of;

namespace {

// A run whose text after the version and the level is `rest`.
std::string with(std::string const& rest) { return R"({"smb2d": 1, "level": "hill.svg")" + rest + "}"; }

std::string with_inputs(std::string const& inputs) { return with(R"(, "inputs": [)" + inputs + "]"); }

std::string error_of(std::string const& text) {
    Folder const folder;
    std::string const file = folder.file("run.json", text);
    std::string const message = message_of([&] { game::read_run(file); });
    CHECK(message.find('\n') == std::string::npos);
    if (message.rfind(file + ": ", 0) != 0) return message;
    return message.substr(file.size() + 2);
}

}  // namespace

TEST_CASE("a run file is read with all that it says") {
    Folder const folder;
    std::string const file = folder.file("run.json", R"({"smb2d": 1, "level": "../hill.svg", "level_hash": "9a",
        "method": "steps", "rate": 120, "duration": 12.5, "inputs": [
        {"t": 0.50, "grab": {"ball": 1, "x": 3.0, "y": 4.0}}, {"t": 0.75, "move": {"x": 3.5, "y": 4.5}},
        {"t": 1.20, "release": true}, {"t": 1.20, "tilt": -0.1}], "final": {"time": 12.5, "state_hash": "51"}})");
    game::Run const run = game::read_run(file);
    CHECK(run.level_file == folder.path("../hill.svg"));
    CHECK(run.level_hash == "9a");
    CHECK(run.method_name == "steps");
    CHECK(run.rate == 120.0);
    CHECK(run.duration == 12.5);
    REQUIRE(run.inputs.size() == 4);
    CHECK(run.inputs[1].time == 0.75);
    CHECK(std::get<game::Grab>(run.inputs[0].action).ball == 1);
    CHECK(std::get<game::Grab>(run.inputs[0].action).pointer.y() == 4);
    CHECK(std::get<game::Move>(run.inputs[1].action).pointer.x() == 3.5);
    CHECK(std::holds_alternative<game::Release>(run.inputs[2].action));
    CHECK(std::get<game::Tilt>(run.inputs[3].action).angle == -0.1);
    CHECK(run.final->state_hash == "51");
}

TEST_CASE("the level alone makes a run, and auto is no method's name") {
    Folder const folder;
    game::Run const run = game::read_run(folder.file("run.json", with(R"(, "method": "auto")")));
    CHECK_FALSE(run.method_name);
    CHECK_FALSE(run.duration);
    CHECK(run.inputs.empty());
}

TEST_CASE("a run by hand may claim the time of its end alone") {
    Folder const folder;
    game::Run run = game::read_run(folder.file("run.json", with(R"(, "final": {"time": 1.5})")));
    REQUIRE(run.final);
    CHECK(run.final->time == 1.5);
    CHECK_FALSE(run.final->state_hash);
    game::write_run(run, folder.path("again.json"));
    CHECK_FALSE(game::read_run(folder.path("again.json")).final->state_hash);
    CHECK(error_of(with(R"(, "final": {})")) == R"(final: the key "time" is missing)");
}

TEST_CASE("what is wrong with a run is named, in one line") {
    CHECK(error_of(R"({"level": "hill.svg"})") == R"(the key "smb2d" is missing)");
    CHECK(error_of(R"({"smb2d": 2, "level": "hill.svg", "new": 1})").find("smb2d: version 2 is greater") == 0);
    CHECK(error_of(R"({"smb2d": 0, "level": "hill.svg"})") == "smb2d: there is no version 0");
    CHECK(error_of(R"({"smb2d": "1", "level": "hill.svg"})").find("smb2d: ") == 0);
    CHECK(error_of(R"({"smb2d": 1})") == R"(the key "level" is missing)");
    CHECK(error_of(R"({"smb2d": 1, "level": 3})") == "level: must be a string");
    CHECK(error_of(with(R"(, "colour": 1)")) == R"(unknown key "colour")");
    CHECK(error_of(with(R"(, "level": "b.svg")")) == R"(the key "level" comes twice)");
    CHECK(error_of(with(R"(, "rate": -1)")).find("rate: must be between") == 0);
    CHECK(error_of(with(R"(, "rate": "fast")")) == "rate: must be a number");
    CHECK(error_of(with(R"(, "method": "guess")")).find(R"(method: "guess" is not one of)") == 0);
    CHECK(error_of(with(R"(, "duration": -1)")).find("duration: must be between") == 0);
    CHECK(error_of(with(R"(, "inputs": {})")) == "inputs: must be an array");
    CHECK(error_of("[]") == "a run must be an object");
}

TEST_CASE("what is wrong with an input is named with its number") {
    std::string const grab = R"({"t": 1, "grab": {"ball": 0, "x": 1, "y": 2}})";
    CHECK(error_of(with_inputs(R"({"t": 1, "move": {"x": 1, "y": 2}})")) == "inputs[0]: a move without a grab");
    CHECK(error_of(with_inputs(grab + R"(, {"t": 2, "release": true}, {"t": 3, "move": {"x": 1, "y": 2}})")) ==
          "inputs[2]: a move without a grab");
    CHECK(error_of(with_inputs(R"({"t": 1, "tilt": 0, "release": true})")) == "inputs[0]: two actions in one input");
    CHECK(error_of(with_inputs(grab + R"(, {"t": 0.5, "tilt": 0})")).find("inputs[1]: ") == 0);
    CHECK(error_of(with_inputs(R"({"t": 1})")).find("inputs[0]: no action") == 0);
    CHECK(error_of(with_inputs(R"({"tilt": 1})")) == R"(inputs[0]: the key "t" is missing)");
    CHECK(error_of(with_inputs(R"({"t": -1, "tilt": 1})")).find("inputs[0]: t: must be between") == 0);
    CHECK(error_of(with_inputs(R"({"t": 1, "tilt": "x"})")) == "inputs[0]: tilt: must be a number");
    CHECK(error_of(with_inputs(R"({"t": 1, "release": false})")) == "inputs[0]: release: must be true");
    CHECK(error_of(with_inputs(R"({"t": 1, "jump": 1})")) == R"(inputs[0]: unknown key "jump")");
    CHECK(error_of(with_inputs(R"({"t": 1, "t": 2, "tilt": 0})")) == R"(inputs[0]: the key "t" comes twice)");
    CHECK(error_of(with_inputs(R"({"t": 1, "grab": {"ball": 0.5, "x": 1, "y": 2}})")).find("inputs[0]: grab: ball") ==
          0);
    CHECK(error_of(with_inputs(R"({"t": 1, "grab": {"ball": 0, "x": 1}})")) ==
          R"(inputs[0]: grab: the key "y" is missing)");
    CHECK(error_of(with_inputs(R"({"t": 1, "grab": {"ball": 0, "x": 1e7, "y": 1}})")).find("inputs[0]: grab: x: ") ==
          0);
    CHECK(error_of(with_inputs("3")).find("inputs[0]: ") == 0);
}

TEST_CASE("what is not JSON is said to be so") {
    for (std::string const& text : {std::string(), std::string("{"), std::string("\0\1\n\2", 4),
                                    std::string("{\"a\n\": 1}"), std::string("\xff\xfe"), std::string(100000, '['),
                                    with_inputs(R"({"t": 1e999, "tilt": 0})"), with_inputs(R"({"t": NaN, "tilt": 0})")})
        CHECK_MESSAGE(error_of(text).find("not JSON: ") == 0, error_of(text));
}

TEST_CASE("a run that is written is read back bit for bit") {
    Folder const folder;
    game::Run run;
    run.level_file = folder.path("levels/hill.svg");
    run.level_hash = "0123456789abcdef";
    run.method_name = "article";
    run.rate = 240;
    run.duration = 1.0 / 3;
    run.inputs = {{0.1, game::Grab{2, {1.0 / 3, -2.0 / 7}}},
                  {0.2, game::Move{{1e-17, 12345.678901234567}}},
                  {0.30000000000000004, game::Release{}},
                  {0.3000000000000001, game::Tilt{0.1}}};
    run.final = game::Run::Final{1.0 / 3, "fedcba9876543210"};
    std::string const file = folder.path("saved/deep/run.json");
    game::write_run(run, file);
    game::Run const read = game::read_run(file);
    CHECK(game::read_whole_file(file, 10000).find(R"("level":"../../levels/hill.svg")") != std::string::npos);
    CHECK(read.level_hash == run.level_hash);
    CHECK(read.method_name == run.method_name);
    CHECK(read.duration == run.duration);
    REQUIRE(read.inputs.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) CHECK(read.inputs[i].time == run.inputs[i].time);
    CHECK(std::get<game::Grab>(read.inputs[0].action).ball == 2);
    CHECK(std::get<game::Grab>(read.inputs[0].action).pointer == geometry::Vec2(1.0 / 3, -2.0 / 7));
    CHECK(std::get<game::Move>(read.inputs[1].action).pointer == geometry::Vec2(1e-17, 12345.678901234567));
    CHECK(std::get<game::Tilt>(read.inputs[3].action).angle == 0.1);
    CHECK(read.final->time == run.final->time);
    CHECK(read.final->state_hash == run.final->state_hash);
}

TEST_CASE("a run is told from a level by its name, else by its first letter") {
    Folder const folder;
    CHECK(game::is_run_file("nowhere.json"));
    CHECK_FALSE(game::is_run_file("nowhere.svg"));
    CHECK(game::is_run_file(folder.file("a", " {\"smb2d\": 1}")));
    CHECK_FALSE(game::is_run_file(folder.file("b", "<svg/>")));
    CHECK_FALSE(game::is_run_file(folder.path("c")));
}
