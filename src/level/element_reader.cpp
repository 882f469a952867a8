#include "level/element_reader.h"

#include <algorithm>
#include <cmath>

#include "level/limits.h"
#include "level/numbers.h"
#include "level/outlines.h"

namespace level {

namespace {

constexpr double curve_tolerance = 1e-3;  // m, where the drawing does not say

bool is_data(std::string_view name) { return name.substr(0, 5) == "data-"; }

}  // namespace

std::string Elements::label(pugi::xml_node node, std::string_view tag) const {
    auto const roles = roles_in(node.attribute("class").value());
    return roles.size() == 1 ? name_of(roles[0]) : quoted(tag);
}

void Elements::inspect_class(pugi::xml_node node, std::string const& name) {
    for (std::string_view const word : words_of(node.attribute("class").value()))
        if (auto const role = near_miss(word))
            reading_.report.warn_always(document_.line_of(node),
                                        name + ": class " + quoted(word) + " is a letter away from " + name_of(*role));
}

void Elements::inspect_group(pugi::xml_node node, std::string_view tag) {
    int const line = document_.line_of(node);
    std::string const name(tag);
    inspect_class(node, name);
    for (Role const role : roles_in(node.attribute("class").value()))
        reading_.report.fault(line, name + ": cannot be " + name_of(role));
    for (pugi::xml_attribute const attribute : node.attributes()) {
        if (!is_data(attribute.name())) continue;
        auto const data = data_named(attribute.name());
        bool const known = data && (tag == "svg" || static_cast<std::size_t>(*data) < inherited_data);
        if (!known) {
            reading_.report.warn(line, name + ": unknown attribute " + quoted(attribute.name()));
            continue;
        }
        if (static_cast<std::size_t>(*data) >= inherited_data) continue;
        try {
            if (*data == Data::velocity)
                velocity_in(attribute.value());
            else
                number_in(*data, attribute.value(), Grip::may_be_full);
        } catch (Broken const& broken) {
            reading_.report.fault(line, name + ": " + broken.what());
        }
    }
}

void Elements::read(pugi::xml_node node, std::string_view tag, Context const& context) {
    auto const roles = roles_in(node.attribute("class").value());
    Element const element{node,
                          tag,
                          context,
                          document_.line_of(node),
                          label(node, tag),
                          roles.empty() ? std::nullopt : std::optional(roles[0])};
    inspect_class(node, element.label);
    if (roles.empty()) return read_decoration(element);
    if (std::find(roles.begin(), roles.end(), Role::ball) != roles.end()) ++balls_met_;
    if (roles.size() > 1)
        return fault(element, std::string("has two roles, ") + name_of(roles[0]) + " and " + name_of(roles[1]));
    if (!may_have(tag, roles[0])) return fault(element, quoted(tag) + " cannot be " + name_of(roles[0]));
    inspect_data(element, roles[0]);
    try {
        read_role(element, roles[0]);
    } catch (TooFar const& far) {
        fault_of_place(element, far);
    } catch (Broken const& broken) {
        fault(element, broken.what());
    }
}

void Elements::inspect_data(Element const& element, Role role) {
    for (pugi::xml_attribute const attribute : element.node.attributes()) {
        std::string_view const name = attribute.name();
        if (!is_data(name)) continue;
        auto const data = data_named(name);
        if (!data)
            warn(element, "unknown attribute " + quoted(name));
        else if (!belongs_to(*data, role))
            warn(element, quoted(name) + " has no effect here");
    }
}

void Elements::fault_of_place(Element const& element, TooFar const& far) {
    fault(element, far_coordinates(element.node, element.tag, scale_of(element.context.to_world)) + ": " + far.what());
}

void Elements::read_role(Element const& element, Role role) {
    switch (role) {
        case Role::terrain:
            return read_terrain(element);
        case Role::ball:
            return read_ball(element);
        case Role::banana:
            return read_banana(element);
        case Role::goal:
            return read_goal(element);
    }
}

// A group's own faults have been reported where they stand.
double Elements::number(Element const& element, Data data, double otherwise) {
    Given const& given = element.context.inherited.of(data);
    if (given.text == nullptr) return otherwise;
    Grip const grip = element.role == Role::ball ? Grip::finite : Grip::may_be_full;
    try {
        return number_in(data, given.text, grip);
    } catch (Broken const& broken) {
        bool const its_own = given.origin == element.node;
        bool const full_grip = data == Data::friction && trimmed(given.text) == "inf";
        if (its_own || full_grip) fault(element, broken.what());
        return otherwise;
    }
}

Vec2 Elements::velocity(Element const& element) {
    Given const& given = element.context.inherited.of(Data::velocity);
    if (given.text == nullptr) return Vec2::Zero();
    try {
        return velocity_in(given.text);
    } catch (Broken const& broken) {
        if (given.origin == element.node) fault(element, broken.what());
        return Vec2::Zero();
    }
}

double Elements::tolerance(Element const& element) { return number(element, Data::curve_tolerance, curve_tolerance); }

void Elements::read_terrain(Element const& element) {
    physics::Material const usual;
    physics::Material const material{number(element, Data::friction, usual.friction),
                                     number(element, Data::restitution, usual.restitution),
                                     number(element, Data::rolling_resistance, usual.rolling_resistance)};
    double const within = tolerance(element);
    Shape const shape = shape_of(element.node, element.tag, Corners::square);
    Traced traced_shape = traced(shape, element.context.to_world, within);
    if (element.tag == "rect" && has_round_corners(element.node)) warn(element, "round corners are taken as square");
    if (traced_shape.outlines.empty())
        warn(element, "is empty");
    else if (traced_shape.dropped > 0)
        warn(element, "pieces without length are dropped, " + std::to_string(traced_shape.dropped) + " of them");

    int const surface = static_cast<int>(reading_.surfaces.size());
    std::vector<Outline>& outlines = reading_.level.outlines;
    bool const filled = trimmed(element.context.style.fill) != "none";
    reading_.surfaces.push_back(
        {element.line, static_cast<int>(outlines.size()), static_cast<int>(traced_shape.outlines.size()), filled});
    std::string const id = element.node.attribute("id").value();
    reading_.level.surface_names.push_back(id.empty() ? std::to_string(surface) : id);
    for (Outline& outline : traced_shape.outlines) {
        for (geometry::Curve const& curve : outline.curves) pieces_.push_back({curve, material, surface});
        outlines.push_back(std::move(outline));
    }
}

physics::DiscRegion Elements::disc_of(Element const& element) const {
    Shape const shape = shape_of(element.node, "circle", Corners::square);
    Ellipse const& circle = std::get<Ellipse>(shape);
    Affine const& map = element.context.to_world;
    if (!is_similarity(map)) throw Broken("transform must keep a circle a circle");
    physics::DiscRegion const disc{placed(map, circle.centre), circle.rx * scale_of(map)};
    if (!(disc.radius > 0)) throw Broken("the radius must be greater than 0, got " + shown(disc.radius));
    if (!(disc.radius <= most_metres)) throw Broken("the radius must be at most 1e6 m, got " + shown(disc.radius));
    return disc;
}

void Elements::read_ball(Element const& element) {
    physics::Ball ball;
    ball.mass = number(element, Data::mass, ball.mass);
    ball.inertia = number(element, Data::inertia, ball.inertia);
    ball.friction = number(element, Data::friction, ball.friction);
    ball.restitution = number(element, Data::restitution, ball.restitution);
    ball.start.velocity = velocity(element);
    ball.start.spin = number(element, Data::spin, 0);
    physics::DiscRegion const disc = disc_of(element);
    ball.start.position = disc.centre;
    ball.radius = disc.radius;
    if (!(std::abs(ball.start.spin) * ball.radius <= most_speed))
        throw Broken("data-spin must move the rim with at most 1e6 m/s, got " + shown(ball.start.spin) + " rad/s");
    bool const is_player = std::string_view(element.node.attribute("id").value()) == "player";
    if (is_player) players_.push_back(static_cast<int>(reading_.level.scene.balls.size()));
    reading_.level.scene.balls.push_back(ball);
    reading_.ball_lines.push_back(element.line);
}

void Elements::add_sensor(physics::Sensor sensor, Meaning meaning, int line) {
    reading_.level.scene.sensors.push_back(std::move(sensor));
    reading_.level.meanings.push_back(meaning);
    reading_.sensor_lines.push_back(line);
}

void Elements::read_banana(Element const& element) {
    physics::Sensor sensor;
    sensor.region = disc_of(element);
    sensor.rim = true;
    add_sensor(sensor, Meaning::banana, element.line);
}

std::optional<physics::Region> Elements::goal_region(Element const& element) {
    if (element.tag == "circle") return disc_of(element);
    Affine const& map = element.context.to_world;
    std::vector<Vec2> corners;
    if (element.tag == "line") {
        corners = {{length_in(element.node, "x1"), length_in(element.node, "y1")},
                   {length_in(element.node, "x2"), length_in(element.node, "y2")}};
    } else {
        corners = corners_of_rect(element.node);
    }
    for (Vec2& corner : corners) corner = placed(map, corner);
    if (corners.size() == 2 && corners[0] != corners[1]) return physics::LineRegion{corners[0], corners[1]};
    bool const flat = corners.size() < 4 || geometry::wedge(corners[1] - corners[0], corners[3] - corners[0]) == 0;
    if (flat) return std::nullopt;
    if (geometry::wedge(corners[1] - corners[0], corners[3] - corners[0]) < 0)
        std::reverse(corners.begin(), corners.end());
    return physics::PolygonRegion{corners};
}

void Elements::read_goal(Element const& element) {
    auto const region = goal_region(element);
    if (!region) return warn(element, "is empty");
    physics::Sensor sensor;
    sensor.region = *region;
    add_sensor(sensor, Meaning::goal, element.line);
}

// Paint and units that browsers know and this program does not are no faults; what nobody can read is.
void Elements::read_decoration(Element const& element) {
    if (!is_shape(element.tag)) return warn(element, "is ignored");
    Affine const& map = element.context.to_world;
    try {
        Style style = element.context.style;
        if (element.tag == "line") style.fill = "none";
        Shape const shape = shape_of(element.node, element.tag, Corners::as_drawn);
        auto const traced_shape = traced(shape, map, tolerance(element));
        for (Decoration const& part : decorations_of(traced_shape.outlines, style, scale_of(map)))
            reading_.level.decorations.push_back(part);
    } catch (Unsupported const& unsupported) {
        warn(element, std::string("is ignored: ") + unsupported.what());
    } catch (TooFar const& far) {
        fault_of_place(element, far);
    } catch (Broken const& broken) {
        fault(element, broken.what());
    }
}

}  // namespace level
