#include "app/play_pad.h"

#include <vector>

#include <doctest/doctest.h>

using app::Pads;
using app::Place;
using app::Sticks;

namespace {

// A pad that is no thing: SDL has it as any other.
class Virtual {
public:
    Virtual() {
        index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                           SDL_CONTROLLER_BUTTON_MAX, 0);
        REQUIRE(index_ >= 0);
        joystick_ = SDL_JoystickOpen(index_);
        REQUIRE(joystick_ != nullptr);
    }
    ~Virtual() {
        if (joystick_) pull_out();
    }
    void push(SDL_GameControllerAxis axis, double way) {
        SDL_JoystickSetVirtualAxis(joystick_, axis, static_cast<Sint16>(way * 32767));
    }
    void press(SDL_GameControllerButton button) { SDL_JoystickSetVirtualButton(joystick_, button, 1); }
    void pull_out() {
        SDL_JoystickClose(joystick_);
        joystick_ = nullptr;
        SDL_JoystickDetachVirtual(index_);
    }

private:
    int index_ = -1;
    SDL_Joystick* joystick_ = nullptr;
};

struct Heard {
    int came = 0, went = 0;
    std::vector<SDL_GameControllerButton> pressed;
};
Heard listened(Pads& pads) {
    Heard heard;
    SDL_Event event;
    SDL_GameControllerUpdate();
    while (SDL_PollEvent(&event) != 0) {
        Pads::News const news = pads.listen(event);
        heard.came += news == Pads::News::came ? 1 : 0;
        heard.went += news == Pads::News::went ? 1 : 0;
        if (event.type == SDL_CONTROLLERBUTTONDOWN)
            heard.pressed.push_back(static_cast<SDL_GameControllerButton>(event.cbutton.button));
    }
    return heard;
}

}  // namespace

TEST_CASE("stick, triggers and cross lean to their side, and the one that is pushed furthest counts") {
    CHECK(app::lean_of({}) == 0);
    CHECK(app::lean_of({1, 0, 0, 0}) == 1);
    CHECK(app::lean_of({-1, 0, 0, 0}) == -1);
    CHECK(app::lean_of({0, 1, 0, 0}) == -1);
    CHECK(app::lean_of({0, 0, 1, 0}) == 1);
    CHECK(app::lean_of({0, 1, 1, 0}) == 0);
    CHECK(app::lean_of({0, 0, 0, -1}) == -1);
    CHECK(app::lean_of({0.5, 1, 0, 0}) == -1);
    CHECK(app::lean_of({0.14, 0.14, 0, 0}) == 0);
    CHECK(app::lean_of({0.575, 0, 0, 0}) == 0.5);  // (0.575 - 0.15) / 0.85
    CHECK(app::lean_of({0.58, 0, 0, 0}) == 0.5);   // a hand that trembles makes no inputs
    CHECK(app::lean_of({-32768 / 32767.0, 0, 0, 0}) == -1);
}

TEST_CASE("a button means what its place makes of it") {
    using app::Move;
    using game::KeyAction;
    auto const action = [](SDL_GameControllerButton button, Place place) {
        auto const press = app::press_for(button, place);
        return press ? press->action : std::nullopt;
    };
    auto const move = [](SDL_GameControllerButton button, Place place) {
        auto const press = app::press_for(button, place);
        return press ? press->move : std::nullopt;
    };
    for (Place const place : {Place::title, Place::picker, Place::menu, Place::settings})
        CHECK(move(SDL_CONTROLLER_BUTTON_A, place) == Move::choose);
    CHECK(action(SDL_CONTROLLER_BUTTON_A, Place::card) == KeyAction::go_on);
    CHECK(action(SDL_CONTROLLER_BUTTON_A, Place::waiting) == KeyAction::pause);
    CHECK(!app::press_for(SDL_CONTROLLER_BUTTON_A, Place::game));
    for (Place const place : {Place::waiting, Place::game})
        CHECK(action(SDL_CONTROLLER_BUTTON_START, place) == KeyAction::menu);
    for (Place const place : {Place::menu, Place::settings}) {
        CHECK(move(SDL_CONTROLLER_BUTTON_START, place) == Move::back);
        CHECK(move(SDL_CONTROLLER_BUTTON_B, place) == Move::back);
    }
    CHECK(action(SDL_CONTROLLER_BUTTON_START, Place::card) == KeyAction::go_on);
    for (Place const place : {Place::title, Place::picker, Place::menu})
        CHECK(action(SDL_CONTROLLER_BUTTON_Y, place) == KeyAction::settings);
    CHECK(!app::press_for(SDL_CONTROLLER_BUTTON_B, Place::game));
    CHECK(move(SDL_CONTROLLER_BUTTON_DPAD_DOWN, Place::picker) == Move::down);
    CHECK(move(SDL_CONTROLLER_BUTTON_DPAD_LEFT, Place::settings) == Move::left);
    CHECK(!app::press_for(SDL_CONTROLLER_BUTTON_DPAD_LEFT, Place::game));  // it leans
}

TEST_CASE("SDL knows every key that an action comes with, by that name, and others in any case") {
    for (game::ActionRow const& row : game::actions())
        for (std::string const& key : row.keys) CHECK(app::canonical_key(key) == key);
    CHECK(app::canonical_key("space") == "Space");
    CHECK(app::canonical_key("q") == "Q");
    CHECK(app::canonical_key("Spcae").empty());
    CHECK(app::canonical_key("").empty());
}

TEST_CASE("a key is pressed as what it stands for now, and moves in lists whatever that is") {
    SDL_KeyboardEvent event{};
    event.keysym.sym = SDLK_RETURN;
    game::Bindings const bindings = game::rebound(game::usual_bindings(), game::KeyAction::save, "Return").bindings;
    app::Press const press = app::press_of(event, bindings);
    CHECK(press.action == game::KeyAction::save);
    CHECK(press.move == app::Move::choose);
    CHECK(press.key == "Return");
}

TEST_CASE("a pad that is plugged in leans, and is missed when it is pulled out") {
    Pads pads;
    listened(pads);
    CHECK(pads.lean() == 0);
    Virtual pad;
    CHECK(listened(pads).came == 1);
    pad.push(SDL_CONTROLLER_AXIS_LEFTX, -1);
    listened(pads);
    CHECK(pads.lean() == -1);
    pad.push(SDL_CONTROLLER_AXIS_LEFTX, 0);
    pad.press(SDL_CONTROLLER_BUTTON_A);
    Heard const heard = listened(pads);
    CHECK(pads.lean() == 0);
    REQUIRE(heard.pressed.size() == 1);
    CHECK(heard.pressed[0] == SDL_CONTROLLER_BUTTON_A);
    pad.push(SDL_CONTROLLER_AXIS_LEFTX, 1);
    pad.pull_out();
    CHECK(listened(pads).went == 1);
    CHECK(pads.lean() == 0);
}
