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
    using app::key_for;
    for (Place const place : {Place::title, Place::card, Place::picker, Place::menu})
        CHECK(key_for(SDL_CONTROLLER_BUTTON_A, place) == SDLK_RETURN);
    CHECK(key_for(SDL_CONTROLLER_BUTTON_A, Place::waiting) == SDLK_SPACE);
    CHECK(!key_for(SDL_CONTROLLER_BUTTON_A, Place::game));
    for (Place const place : {Place::waiting, Place::game, Place::menu})
        CHECK(key_for(SDL_CONTROLLER_BUTTON_START, place) == SDLK_ESCAPE);
    CHECK(key_for(SDL_CONTROLLER_BUTTON_START, Place::card) == SDLK_RETURN);
    CHECK(key_for(SDL_CONTROLLER_BUTTON_B, Place::menu) == SDLK_ESCAPE);
    CHECK(!key_for(SDL_CONTROLLER_BUTTON_B, Place::game));
    CHECK(key_for(SDL_CONTROLLER_BUTTON_DPAD_DOWN, Place::picker) == SDLK_DOWN);
    CHECK(!key_for(SDL_CONTROLLER_BUTTON_DPAD_LEFT, Place::game));  // it leans
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
