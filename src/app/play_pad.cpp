#include "app/play_pad.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double dead = 0.15;      // of the whole way
constexpr double lean_steps = 32;  // to either side
constexpr double whole_way = 32767;

double beyond_dead(double way) {
    double const size = std::min(std::abs(way), 1.0);
    return size <= dead ? 0 : std::copysign((size - dead) / (1 - dead), way);
}

Sticks sticks_of(SDL_GameController* pad) {
    auto const way = [&](SDL_GameControllerAxis axis) { return SDL_GameControllerGetAxis(pad, axis) / whole_way; };
    auto const down = [&](SDL_GameControllerButton button) {
        return SDL_GameControllerGetButton(pad, button) != 0 ? 1 : 0;
    };
    return {way(SDL_CONTROLLER_AXIS_LEFTX), way(SDL_CONTROLLER_AXIS_TRIGGERLEFT), way(SDL_CONTROLLER_AXIS_TRIGGERRIGHT),
            down(SDL_CONTROLLER_BUTTON_DPAD_RIGHT) - down(SDL_CONTROLLER_BUTTON_DPAD_LEFT)};
}

std::optional<Press> arrow_for(SDL_GameControllerButton button) {
    switch (button) {
        case SDL_CONTROLLER_BUTTON_DPAD_LEFT:
            return Press{std::nullopt, Move::left};
        case SDL_CONTROLLER_BUTTON_DPAD_RIGHT:
            return Press{std::nullopt, Move::right};
        case SDL_CONTROLLER_BUTTON_DPAD_UP:
            return Press{std::nullopt, Move::up};
        case SDL_CONTROLLER_BUTTON_DPAD_DOWN:
            return Press{std::nullopt, Move::down};
        default:
            return std::nullopt;
    }
}

}  // namespace

std::optional<Press> press_for(SDL_GameControllerButton button, Place place) {
    using game::KeyAction;
    bool const is_list = place == Place::picker || place == Place::menu || place == Place::settings;
    Press const choose{std::nullopt, Move::choose}, back{std::nullopt, Move::back};
    switch (button) {
        case SDL_CONTROLLER_BUTTON_A:
            if (place == Place::waiting) return Press{KeyAction::pause};
            if (place == Place::card) return Press{KeyAction::go_on};
            if (place == Place::game) return std::nullopt;
            return choose;
        case SDL_CONTROLLER_BUTTON_START:
            if (place == Place::waiting || place == Place::game) return Press{KeyAction::menu};
            if (place == Place::menu || place == Place::settings) return back;
            if (place == Place::card) return Press{KeyAction::go_on};
            return choose;
        case SDL_CONTROLLER_BUTTON_B:
            if (is_list) return back;
            return std::nullopt;
        case SDL_CONTROLLER_BUTTON_X:
            if (place == Place::game || place == Place::card) return Press{KeyAction::restart};
            return std::nullopt;
        case SDL_CONTROLLER_BUTTON_Y:
            if (place == Place::card) return Press{KeyAction::film};
            if (place == Place::title || place == Place::picker || place == Place::menu)
                return Press{KeyAction::settings};
            return std::nullopt;
        case SDL_CONTROLLER_BUTTON_BACK:
            if (place == Place::menu || place == Place::settings) return back;
            return Press{KeyAction::levels};
        default:
            return is_list ? arrow_for(button) : std::nullopt;
    }
}

double lean_of(Sticks const& sticks) {
    double furthest = 0;
    for (double const way :
         {beyond_dead(sticks.x), beyond_dead(sticks.right - sticks.left), static_cast<double>(sticks.cross)})
        if (std::abs(way) > std::abs(furthest)) furthest = way;
    return std::round(furthest * lean_steps) / lean_steps;
}

Pads::Pads() : started_(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0) {}

Pads::~Pads() {
    open_.clear();
    if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

Pads::News Pads::listen(SDL_Event const& event) {
    if (event.type == SDL_CONTROLLERDEVICEADDED) {
        SDL_GameController* const pad = SDL_GameControllerOpen(event.cdevice.which);
        if (!pad) return News::nothing;
        SDL_JoystickID const id = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad));
        // Opened twice, it would have to be closed twice.
        if (open_.contains(id)) {
            SDL_GameControllerClose(pad);
            return News::nothing;
        }
        open_[id].reset(pad);
        return News::came;
    }
    if (event.type == SDL_CONTROLLERDEVICEREMOVED && open_.erase(event.cdevice.which) > 0) return News::went;
    return News::nothing;
}

double Pads::lean() const {
    double furthest = 0;
    for (auto const& [id, pad] : open_) {
        double const lean = lean_of(sticks_of(pad.get()));
        if (std::abs(lean) > std::abs(furthest)) furthest = lean;
    }
    return furthest;
}

}  // namespace app
