#include "game/run_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "game/method_choice.h"
#include "game/whole_file.h"

namespace game {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int known_version = 1;
constexpr std::size_t size_limit = 64u << 20;  // bytes, as for levels
constexpr double place_limit = 1e6;            // m, as for levels
constexpr double time_limit = 1e9;             // s

// What is being read, for messages: the file, and the place in it.
struct Place {
    std::string text;

    Place at(std::string const& key) const { return {text + ": " + key}; }
    [[noreturn]] void fail(std::string const& what) const { throw std::runtime_error(text + ": " + what); }
};

std::string quoted(std::string const& key) { return json(key).dump(-1, ' ', true, json::error_handler_t::replace); }

// Tells a key that comes twice in one object, which a plain parse would let pass.
class Duplicates {
public:
    explicit Duplicates(Place const& file) : file_(file) {}

    bool operator()(int depth, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start) {
            keys_.emplace_back();
            if (depth == 2) ++inputs_;
        } else if (event == json::parse_event_t::object_end) {
            keys_.pop_back();
        } else if (event == json::parse_event_t::key && !keys_.back().insert(parsed.get<std::string>()).second) {
            Place const place = depth > 2 ? file_.at("inputs[" + std::to_string(inputs_ - 1) + "]") : file_;
            place.fail("the key " + quoted(parsed.get<std::string>()) + " comes twice");
        }
        return true;
    }

private:
    Place file_;
    std::vector<std::set<std::string>> keys_;
    int inputs_ = 0;
};

// "line 3: what", out of the parser's own sentence.
std::string plain(std::string const& message) {
    std::size_t const place = message.find("at line ");
    std::string text = place == std::string::npos ? message.substr(std::min(message.size(), message.find("] ") + 2))
                                                  : message.substr(place + 3);
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return "not JSON: " + text;
}

json json_in(std::string const& bytes, Place const& file) {
    try {
        return json::parse(bytes, Duplicates(file));
    } catch (json::exception const& error) {
        file.fail(plain(error.what()));
    }
}

void expect_keys(json const& object, Place const& place, std::initializer_list<char const*> known) {
    if (!object.is_object()) place.fail("must be an object");
    for (auto const& [key, value] : object.items())
        if (std::find(known.begin(), known.end(), key) == known.end()) place.fail("unknown key " + quoted(key));
}

json const& member(json const& object, Place const& place, char const* key) {
    auto const found = object.find(key);
    if (found == object.end()) place.fail("the key " + quoted(key) + " is missing");
    return *found;
}

double number(json const& value, Place const& place, double low, double high) {
    if (!value.is_number()) place.fail("must be a number");
    double const result = value.get<double>();
    if (!std::isfinite(result)) place.fail("must be finite");
    if (result < low || result > high) {
        json const limits = {low, high};
        place.fail("must be between " + limits[0].dump() + " and " + limits[1].dump() + ", got " + value.dump());
    }
    return result;
}

std::string text(json const& value, Place const& place) {
    if (!value.is_string()) place.fail("must be a string");
    return value.get<std::string>();
}

Vec2 pointer_in(json const& object, Place const& place) {
    return {number(member(object, place, "x"), place.at("x"), -place_limit, place_limit),
            number(member(object, place, "y"), place.at("y"), -place_limit, place_limit)};
}

Grab grab_in(json const& value, Place const& place) {
    expect_keys(value, place, {"ball", "x", "y"});
    json const& ball = member(value, place, "ball");
    if (!ball.is_number_integer() || ball.get<double>() < 0 || ball.get<double>() > 1e6)
        place.at("ball").fail("must be the number of a ball, from 0");
    return {ball.get<int>(), pointer_in(value, place)};
}

Move move_in(json const& value, Place const& place) {
    expect_keys(value, place, {"x", "y"});
    return {pointer_in(value, place)};
}

Action action_in(json const& input, Place const& place) {
    expect_keys(input, place, {"t", "grab", "move", "release", "tilt"});
    if (input.size() > 2) place.fail("two actions in one input");
    if (auto const grab = input.find("grab"); grab != input.end()) return grab_in(*grab, place.at("grab"));
    if (auto const move = input.find("move"); move != input.end()) return move_in(*move, place.at("move"));
    if (auto const tilt = input.find("tilt"); tilt != input.end())
        return Tilt{number(*tilt, place.at("tilt"), -1e6, 1e6)};
    auto const release = input.find("release");
    if (release == input.end()) place.fail("no action: grab, move, release or tilt");
    if (*release != true) place.at("release").fail("must be true");
    return Release{};
}

std::vector<Input> inputs_in(json const& array, Place const& file) {
    if (!array.is_array()) file.at("inputs").fail("must be an array");
    std::vector<Input> inputs;
    bool grabbed = false;
    for (json const& value : array) {
        Place const place = file.at("inputs[" + std::to_string(inputs.size()) + "]");
        Action const action = action_in(value, place);
        double const time = number(member(value, place, "t"), place.at("t"), 0, time_limit);
        if (!inputs.empty() && time < inputs.back().time)
            place.fail("comes before the input ahead of it: out of order");
        if (std::holds_alternative<Move>(action) && !grabbed) place.fail("a move without a grab");
        if (std::holds_alternative<Grab>(action)) grabbed = true;
        if (std::holds_alternative<Release>(action)) grabbed = false;
        inputs.push_back({time, action});
    }
    return inputs;
}

Run::Final final_in(json const& value, Place const& place) {
    expect_keys(value, place, {"time", "state_hash"});
    Run::Final final{number(member(value, place, "time"), place.at("time"), 0, time_limit), std::nullopt};
    if (auto const hash = value.find("state_hash"); hash != value.end())
        final.state_hash = text(*hash, place.at("state_hash"));
    return final;
}

void expect_version(json const& root, Place const& file) {
    if (!root.is_object()) file.fail("a run must be an object");
    json const& version = member(root, file, "smb2d");
    if (!version.is_number_integer()) file.at("smb2d").fail("must be the whole number of a version");
    if (version.get<double>() < 1) file.at("smb2d").fail("there is no version " + version.dump());
    if (version.get<double>() > known_version)
        file.at("smb2d").fail("version " + version.dump() + " is greater than this program knows, which is " +
                              std::to_string(known_version));
}

std::string level_file_in(json const& value, Place const& place, std::string const& run_file) {
    std::string const name = text(value, place);
    if (name.empty() || name.find('\0') != std::string::npos) place.fail("must name a file");
    return (std::filesystem::path(run_file).parent_path() / name).string();
}

std::optional<std::string> method_in(json const& value, Place const& place) {
    std::string const name = text(value, place);
    if (name == "auto") return std::nullopt;
    if (!is_method_name(name)) place.fail(quoted(name) + " is not one of auto, article, euler, steps, exact");
    return name;
}

ordered_json json_of(Input const& input) {
    ordered_json value = {{"t", input.time}};
    if (auto const* grab = std::get_if<Grab>(&input.action))
        value["grab"] = {{"ball", grab->ball}, {"x", grab->pointer.x()}, {"y", grab->pointer.y()}};
    else if (auto const* move = std::get_if<Move>(&input.action))
        value["move"] = {{"x", move->pointer.x()}, {"y", move->pointer.y()}};
    else if (auto const* tilt = std::get_if<Tilt>(&input.action))
        value["tilt"] = tilt->angle;
    else
        value["release"] = true;
    return value;
}

std::string level_from(std::string const& folder, std::string const& level_file) {
    namespace files = std::filesystem;
    std::error_code error;
    files::path const level = files::weakly_canonical(level_file, error);
    if (error) return level_file;
    files::path const from = files::weakly_canonical(folder.empty() ? "." : folder, error);
    files::path const relative = error ? level : level.lexically_relative(from);
    return (relative.empty() ? level : relative).string();
}

}  // namespace

Run read_run(std::string const& file) {
    Place const place{file};
    json const root = json_in(read_whole_file(file, size_limit), place);
    expect_version(root, place);
    expect_keys(root, place, {"smb2d", "level", "level_hash", "method", "rate", "duration", "inputs", "final"});
    auto const find = [&](char const* key) { return root.contains(key) ? &root[key] : nullptr; };
    Run run;
    run.file = file;
    run.level_file = level_file_in(member(root, place, "level"), place.at("level"), file);
    if (auto const* value = find("level_hash")) run.level_hash = text(*value, place.at("level_hash"));
    if (auto const* value = find("method")) run.method_name = method_in(*value, place.at("method"));
    if (auto const* value = find("rate")) run.rate = number(*value, place.at("rate"), lowest_rate, highest_rate);
    if (auto const* value = find("duration")) run.duration = number(*value, place.at("duration"), 0, time_limit);
    if (auto const* value = find("inputs")) run.inputs = inputs_in(*value, place);
    if (auto const* value = find("final")) run.final = final_in(*value, place.at("final"));
    return run;
}

std::string text_of(Run const& run, std::string const& folder) {
    ordered_json root = {{"smb2d", known_version}, {"level", level_from(folder, run.level_file)}};
    if (run.level_hash) root["level_hash"] = *run.level_hash;
    if (run.method_name) root["method"] = *run.method_name;
    if (run.rate) root["rate"] = *run.rate;
    if (run.duration) root["duration"] = *run.duration;
    std::string text = root.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    text.pop_back();
    text += ",\n \"inputs\": [";
    for (std::size_t i = 0; i < run.inputs.size(); ++i)
        text += (i == 0 ? "\n   " : ",\n   ") + json_of(run.inputs[i]).dump();
    text += "]";
    if (run.final) {
        ordered_json final = {{"time", run.final->time}};
        if (run.final->state_hash) final["state_hash"] = *run.final->state_hash;
        text += ",\n \"final\": " + final.dump();
    }
    return text + "}\n";
}

void write_run(Run const& run, std::string const& file) {
    write_whole_file(file, text_of(run, std::filesystem::path(file).parent_path().string()));
}

bool is_run_file(std::string const& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".json") return true;
    if (ending == ".svg") return false;
    std::ifstream stream(file, std::ios::binary);
    char first = 0;
    return stream >> first && first == '{';
}

}  // namespace game
