#include "app/trace.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

char const* name_of(physics::Phase phase) {
    switch (phase) {
        case physics::Phase::flight:
            return "flight";
        case physics::Phase::roll:
            return "roll";
        case physics::Phase::slide:
            return "slide";
        case physics::Phase::rest:
            return "rest";
    }
    return "";
}

char const* name_of(level::Meaning meaning) {
    switch (meaning) {
        case level::Meaning::goal:
            return "goal";
        case level::Meaning::banana:
            return "banana";
        case level::Meaning::fall:
            return "fall";
    }
    return "";
}

char const* name_of(level::Level const& level, physics::Event const& event) {
    switch (event.kind) {
        case physics::EventKind::land:
            return "land";
        case physics::EventKind::bounce:
            return "bounce";
        case physics::EventKind::slip:
            return "slip";
        case physics::EventKind::grip:
            return "grip";
        case physics::EventKind::lift:
            return "lift";
        case physics::EventKind::joint:
            return "joint";
        case physics::EventKind::corner:
            return "corner";
        case physics::EventKind::rest:
            return "rest";
        case physics::EventKind::hit:
            return "hit";
        case physics::EventKind::grab:
            return "grab";
        case physics::EventKind::release:
            return "release";
        case physics::EventKind::tilt:
            return "tilt";
        case physics::EventKind::sensor:
            return name_of(level.meanings[event.other]);
        case physics::EventKind::handover:
            return "handover";
        case physics::EventKind::takeover:
            return "takeover";
    }
    return "";
}

std::string_view surface_name(level::Level const& level, physics::Contact const& contact) {
    if (contact.feature < 0) return "";
    return level.surface_names[physics::surface_of(level.scene.terrain, contact.feature)];
}

bool must_be_quoted(std::string_view text) { return text.find_first_of(",\"\r\n") != text.npos; }

std::string csv_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (char const c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string json_text(std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// How many sensors of the same meaning come before it in the file.
int number_of(level::Level const& level, int sensor) {
    int number = 0;
    for (int i = 0; i < sensor; ++i) number += level.meanings[i] == level.meanings[sensor] ? 1 : 0;
    return number;
}

std::string joined(std::vector<int> const& balls) {
    std::string text;
    for (int const ball : balls) text += (text.empty() ? "" : "+") + std::to_string(ball);
    return text;
}

}  // namespace

void Trace::header(Rows rows) {
    if (format_ == Format::json) return;
    output_.add(rows == Rows::times ? "t,ball,x,y,angle,vx,vy,spin,phase,surface"
                                    : "t,ball,event,x,y,vx,vy,spin,surface,other");
    output_.end_line();
}

void Trace::begin() {
    is_first_ = true;
    if (format_ == Format::json) output_.add('{');
}

void Trace::end() {
    if (format_ == Format::json) output_.add('}');
    output_.end_line();
}

void Trace::name(char const* field) {
    if (!is_first_) output_.add(',');
    is_first_ = false;
    if (format_ == Format::csv) return;
    output_.add('"');
    output_.add(field);
    output_.add("\":");
}

void Trace::field(char const* name_of_field, double value) {
    name(name_of_field);
    output_.add(value);
}

void Trace::field(char const* name_of_field, int value) {
    name(name_of_field);
    output_.add(static_cast<long long>(value));
}

void Trace::field(char const* name_of_field, std::string_view text) {
    name(name_of_field);
    if (format_ == Format::json)
        output_.add(json_text(text));
    else if (must_be_quoted(text))
        output_.add(csv_quoted(text));
    else
        output_.add(text);
}

void Trace::empty_field(char const* name_of_field) {
    name(name_of_field);
    if (format_ == Format::json) output_.add("null");
}

void Trace::add_balls(game::Session const& session, double time) {
    for (int ball = 0; ball < static_cast<int>(session.history.legs.size()); ++ball) {
        physics::Leg const& leg = physics::leg_at(session.history, ball, time);
        physics::State const state = physics::at(leg, time);
        begin();
        field("t", time);
        field("ball", ball);
        field("x", state.position.x());
        field("y", state.position.y());
        field("angle", state.angle);
        field("vx", state.velocity.x());
        field("vy", state.velocity.y());
        field("spin", state.spin);
        field("phase", name_of(leg.phase));
        field("surface", surface_name(*session.level, leg.contact));
        end();
    }
}

void Trace::add_event(game::Session const& session, physics::Event const& event) {
    begin();
    field("t", event.time);
    field("ball", event.ball);
    field("event", name_of(*session.level, event));
    field("x", event.state.position.x());
    field("y", event.state.position.y());
    field("vx", event.state.velocity.x());
    field("vy", event.state.velocity.y());
    field("spin", event.state.spin);
    field("surface", surface_name(*session.level, event.contact));
    if (event.kind == physics::EventKind::sensor)
        field("other", number_of(*session.level, event.other));
    else if (event.kind == physics::EventKind::handover || event.kind == physics::EventKind::takeover)
        field("other", joined(session.history.islands[event.other]));
    else if (event.other >= 0)
        field("other", event.other);
    else
        empty_field("other");
    end();
}

void Trace::flush() { output_.flush(); }

}  // namespace app
