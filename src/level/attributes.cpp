#include "level/attributes.h"

#include <cmath>
#include <limits>

#include "level/faults.h"
#include "level/limits.h"
#include "level/numbers.h"

namespace level {

namespace {

constexpr double no_limit = std::numeric_limits<double>::max();
constexpr double most_pulls = 1e6;

struct Rule {
    char const* name;
    double low = -no_limit, high = no_limit;  // both allowed
    bool above_low = false;                   // low itself is not
    char const* wanted = "";
};

constexpr std::array<Rule, 17> rules = {{
    {"data-mass", 0, no_limit, true, "greater than 0"},
    {"data-inertia", 0, 1, true, "greater than 0 and at most 1"},
    {"data-velocity"},
    {"data-spin"},
    {"data-friction", 0, no_limit, false, "at least 0"},
    {"data-restitution", 0, 1, false, "from 0 to 1"},
    {"data-rolling-resistance", 0, no_limit, false, "at least 0"},
    {"data-curve-tolerance", least_curve_tolerance, no_limit, false, "at least 1e-6 m"},
    {"data-gravity", 0, most_metres, false, "from 0 to 1e6"},
    {"data-time-limit", 0, no_limit, true, "greater than 0"},
    {"data-drag-frequency", 0, most_metres, false, "from 0 to 1e6"},
    {"data-drag-damping", 0, most_metres, false, "from 0 to 1e6"},
    {"data-drag-reach", 0, most_metres, false, "from 0 to 1e6"},
    {"data-tilt-limit", 0, no_limit, false, "at least 0"},
    {"data-par-time", 0, no_limit, true, "greater than 0"},
    {"data-pulls", 0, most_pulls, false, "a whole number from 0 to 1e6"},
    {"data-metres-per-unit", 0, most_metres, true, "greater than 0 and at most 1e6"},
}};

Rule const& rule_of(Data data) { return rules[static_cast<std::size_t>(data)]; }

[[noreturn]] void refuse(Rule const& rule, std::string const& wanted, std::string_view text) {
    throw Broken(std::string(rule.name) + " must be " + wanted + ", got " + quoted(trimmed(text)));
}

}  // namespace

char const* name_of(Data data) { return rule_of(data).name; }

std::optional<Data> data_named(std::string_view name) {
    for (std::size_t i = 0; i < rules.size(); ++i)
        if (name == rules[i].name) return static_cast<Data>(i);
    return std::nullopt;
}

bool names_look(std::string_view attribute) {
    for (LookAttribute const& look : {sky_attribute, hills_attribute, sun_attribute, clouds_attribute})
        if (attribute == look.name) return true;
    return false;
}

bool belongs_to(Data data, Role role) {
    switch (data) {
        case Data::mass:
        case Data::inertia:
        case Data::velocity:
        case Data::spin:
            return role == Role::ball;
        case Data::friction:
        case Data::restitution:
            return role == Role::ball || role == Role::terrain;
        case Data::rolling_resistance:
        case Data::curve_tolerance:
            return role == Role::terrain;
        default:
            return false;
    }
}

Inherited inherited_by(pugi::xml_node node, Inherited const& from_above) {
    Inherited result = from_above;
    for (pugi::xml_attribute const attribute : node.attributes()) {
        auto const data = data_named(attribute.name());
        if (data && static_cast<std::size_t>(*data) < inherited_data)
            result.given[static_cast<std::size_t>(*data)] = {attribute.value(), node};
    }
    return result;
}

double number_in(Data data, std::string_view text, Grip grip) {
    Rule const& rule = rule_of(data);
    Parsed const parsed = parsed_number(text);
    bool const full_grip = data == Data::friction && grip == Grip::may_be_full && trimmed(text) == "inf";
    if (full_grip) return parsed.value;
    if (parsed.syntax == Syntax::not_a_number) refuse(rule, "a number", text);
    if (parsed.syntax == Syntax::not_finite) refuse(rule, "finite", text);
    double const x = parsed.value;
    bool const outside = x < rule.low || x > rule.high || (rule.above_low && x == rule.low) ||
                         (data == Data::pulls && x != std::floor(x));
    if (outside) refuse(rule, rule.wanted, text);
    return x;
}

geometry::Vec2 velocity_in(std::string_view text) {
    Rule const& rule = rule_of(Data::velocity);
    auto const numbers = parsed_list(text);
    if (!numbers || numbers->size() != 2) refuse(rule, "two finite numbers, vx vy", text);
    geometry::Vec2 const velocity((*numbers)[0], (*numbers)[1]);
    if (std::abs(velocity.x()) > most_speed || std::abs(velocity.y()) > most_speed ||
        geometry::length(velocity) > most_speed)
        refuse(rule, "at most 1e6 m/s", text);
    return velocity;
}

}  // namespace level
