// The data- attributes: what each may hold, how it is inherited, and what counts where it is missing.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "geometry/vector.h"
#include "level/roles.h"

namespace level {

enum class Data {
    mass,
    inertia,
    velocity,
    spin,
    friction,
    restitution,
    rolling_resistance,
    curve_tolerance,  // inherited
    gravity,
    time_limit,
    drag_frequency,
    drag_damping,
    drag_reach,
    tilt_limit,
    par_time,
    pulls,
    metres_per_unit  // the root's own
};
inline constexpr std::size_t inherited_data = 8;

char const* name_of(Data data);

// The root's attributes that hold colours, and how many.
struct LookAttribute {
    char const* name;
    std::size_t colours;
};
inline constexpr LookAttribute sky_attribute = {"data-sky", 2}, hills_attribute = {"data-hills", 3},
                               sun_attribute = {"data-sun", 1}, clouds_attribute = {"data-clouds", 1};
bool names_look(std::string_view attribute);

std::optional<Data> data_named(std::string_view name);
bool belongs_to(Data data, Role role);

// What an attribute says and who says it; text is null where nobody does.
struct Given {
    char const* text = nullptr;
    pugi::xml_node origin;
};

// The nearest of each inherited attribute on the way from the root.
struct Inherited {
    std::array<Given, inherited_data> given;
    Given const& of(Data data) const { return given[static_cast<std::size_t>(data)]; }
};
Inherited inherited_by(pugi::xml_node node, Inherited const& from_above);

// Full grip makes sense for a surface only.
enum class Grip { finite, may_be_full };

// Throws Broken("data-mass must be greater than 0, got -1").
double number_in(Data data, std::string_view text, Grip grip);

// "vx vy" in m/s. Throws Broken.
geometry::Vec2 velocity_in(std::string_view text);

}  // namespace level
