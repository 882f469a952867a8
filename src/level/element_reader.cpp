#include "level/element_reader.h"

#include <algorithm>
#include <cmath>

#include "level/goal.h"
#include "level/inside.h"
#include "level/limits.h"
#include "level/look.h"
#include "level/numbers.h"
#include "level/outlines.h"
#include "level/round.h"
#include "level/shapes.h"

namespace level {

namespace {

constexpr double curve_tolerance = 1e-3;          // m, where the drawing does not say
constexpr std::size_t most_goal_corners = 5'000;  // of goals that are not convex

// Less of an area than rounding leaves is none, and so is one that cannot be told.
bool is_flat(Affine const& map) {
    constexpr double rounding = 1e-12;  // of the squares of its numbers
    double const squares = map.a * map.a + map.b * map.b + map.c * map.c + map.d * map.d;
    return std::abs(determinant(map)) <= rounding * squares;
}

std::string what_to_do_with(std::string_view tag) {
    if (tag == "text") return "; make it a path first (Inkscape: Path > Object to Path)";
    if (tag == "image") return "; draw its outline, or trace it (Inkscape: Path > Trace Bitmap)";
    return "; draw a path";
}

}  // namespace

std::string Elements::label(pugi::xml_node node, std::string_view tag) const {
    auto const roles = roles_in(node.attribute("class").value());
    return roles.size() == 1 ? name_of(roles[0]) : quoted(tag);
}

std::optional<Role> Elements::role_of_group(pugi::xml_node node) const {
    auto const roles = roles_in(node.attribute("class").value());
    return roles.empty() ? std::nullopt : std::optional(roles[0]);
}

ReferenceBox Elements::reference_box(pugi::xml_node node, std::string_view tag, std::string_view box,
                                     Context const& context) const {
    if (box.empty() || same_word(box, "view-box")) return context.viewport;
    bool const known = same_word(box, "fill-box") || same_word(box, "content-box");
    if (!known || !is_shape(tag))
        throw Broken("transform-box of " + quoted(tag) + " must be view-box, got " + quoted(box));
    Shape const shape = shape_of(node, tag, context.viewport.size);
    geometry::Box extent = box_of(traced(shape, Affine{}, curve_tolerance).outlines);
    // Pieces without length leave no outline, and count.
    if (auto const* subpaths = std::get_if<std::vector<Subpath>>(&shape))
        for (Subpath const& subpath : *subpaths) {
            extent = united(extent, {subpath.start, subpath.start});
            for (Draw const& draw : subpath.draws) extent = united(extent, {end_of(draw), end_of(draw)});
        }
    if (extent.low.x() > extent.high.x()) return {};
    return {extent.low, extent.high - extent.low};
}

void Elements::read(pugi::xml_node node, std::string_view tag, Context const& context) {
    auto const roles = roles_in(node.attribute("class").value());
    std::optional<Role> role = is_shape(tag) ? context.role : std::nullopt;
    if (!roles.empty()) role = roles[0];
    Element const element{
        node, tag, context, document_.line_of(node), role && roles.size() < 2 ? name_of(*role) : quoted(tag), role};
    inspect_class(node, element.label);
    if (!role) {
        inspect_name(node, element.label);
        return read_decoration(element);
    }
    if (role == Role::ball || std::find(roles.begin(), roles.end(), Role::ball) != roles.end()) ++balls_met_;
    if (roles.size() > 1)
        return fault(element, std::string("has two roles, ") + name_of(roles[0]) + " and " + name_of(roles[1]) +
                                  "; keep one of them");
    if (!is_shape(tag)) return fault(element, quoted(tag) + " cannot be " + name_of(*role) + what_to_do_with(tag));
    if (is_overfull() && role != Role::ball) return;
    inspect_data(element, *role);
    inspect_look(element);
    try {
        bool const flattened = role != Role::ball && is_flat(context.to_world);
        if (flattened) throw Broken("its transform flattens it to nothing");
        read_role(element, *role);
    } catch (TooFar const& far) {
        fault_of_place(element, far);
    } catch (Broken const& broken) {
        fault(element, broken.what());
    }
}

void Elements::fault_of_place(Element const& element, TooFar const& far) {
    fault(element,
          far_attributes(element.node, element.tag, scale_of(element.context.to_world), far) + ": " + far.what());
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

Traced Elements::traced_within_limits(Element const& element, Shape const& shape) {
    Traced result = traced(shape, element.context.to_world, tolerance(element));
    for (Outline const& outline : result.outlines) pieces_met_ += outline.curves.size();
    if (is_overfull()) throw Broken("all shapes together must have at most 1000000 pieces");
    return result;
}

void Elements::read_terrain(Element const& element) {
    physics::Material const usual;
    physics::Material const material{number(element, Data::friction, usual.friction),
                                     number(element, Data::restitution, usual.restitution),
                                     number(element, Data::rolling_resistance, usual.rolling_resistance)};
    Traced traced_shape =
        traced_within_limits(element, shape_of(element.node, element.tag, element.context.viewport.size));
    if (traced_shape.outlines.empty())
        warn(element, "is empty");
    else if (traced_shape.dropped > 0)
        warn(element, "pieces without length are dropped, " + std::to_string(traced_shape.dropped) + " of them");

    if (auto const& sight = element.context.sight)
        if (!traced_shape.outlines.empty() && !holds(*sight, traced_shape.outlines))
            warn(element, "reaches out of its svg, where browsers cut it off; it counts whole");

    int const surface = static_cast<int>(reading_.surfaces.size());
    std::vector<Outline>& outlines = reading_.level.outlines;
    bool const filled = trimmed(element.context.style.fill) != "none";
    reading_.surfaces.push_back(
        {element.line, static_cast<int>(outlines.size()), static_cast<int>(traced_shape.outlines.size()), filled});
    paint_terrain(element, traced_shape.outlines);
    std::string const id(element.context.id);
    reading_.level.surface_names.push_back(id.empty() ? std::to_string(surface) : id);
    grass_met_ = grass_met_ || (!traced_shape.outlines.empty() && !traced_shape.outlines[0].painted);
    for (Outline& outline : traced_shape.outlines) {
        for (geometry::Curve const& curve : outline.curves) pieces_.push_back({curve, material, surface});
        outlines.push_back(std::move(outline));
    }
}

std::vector<Decoration> Elements::painted(Element const& element, std::vector<Outline> const& outlines,
                                          Style const& style) {
    return decorations_of(outlines, style, element.context.to_world, paints_);
}

// Terrain keeps the paint that the drawing gives it. Where that is none, or none that is known, it gets grass and soil
// rather than to be met unseen.
void Elements::paint_terrain(Element const& element, std::vector<Outline>& outlines) {
    Style style = element.context.style;
    bool const given = !style.fill.empty() || !style.stroke.empty();
    bool const unseen = !same_word(style.visibility, "visible") || style.opacity <= 0;
    if (!unseen && (!given || element.context.grass)) return;
    if (element.tag == "line") style.fill = "none";
    try {
        auto const parts = painted(element, outlines, style);
        // Programs put invisible frames into groups: whoever gave the group its role may not know of them.
        bool const is_by_group = roles_in(element.node.attribute("class").value()).empty();
        if (parts.empty() && !unseen && is_by_group)
            warn(element, "has no paint that is seen, and takes part all the same, as grass and soil");
        if (parts.empty() && !unseen) return;
        for (Outline& outline : outlines) outline.painted = true;
        if (grass_met_ && !reading_.level.in_front) reading_.level.in_front = reading_.level.decorations.size();
        double& stroke_width = reading_.surfaces.back().stroke_width;
        for (Decoration const& part : parts) stroke_width = std::max(stroke_width, part.stroke_width);
        reading_.level.decorations.insert(reading_.level.decorations.end(), parts.begin(), parts.end());
    } catch (Unsupported const& unsupported) {
        warn(element, std::string("is shown as grass and soil: ") + unsupported.what());
    }
}

physics::DiscRegion Elements::disc(Element const& element) const {
    Affine const& map = element.context.to_world;
    Shape const shape = shape_of(element.node, element.tag, element.context.viewport.size);
    if (auto const found = disc_of(shape, map)) return *found;
    std::string const why = why_not_round(shape, map, element.tag);
    if (std::holds_alternative<Ellipse>(shape)) throw Broken(why);
    throw Broken(quoted(element.tag) + " cannot be " + name_of(*element.role) + ": " + why);
}

void Elements::read_ball(Element const& element) {
    physics::Ball ball;
    ball.mass = number(element, Data::mass, ball.mass);
    ball.inertia = number(element, Data::inertia, ball.inertia);
    ball.friction = number(element, Data::friction, ball.friction);
    ball.restitution = number(element, Data::restitution, ball.restitution);
    ball.start.velocity = velocity(element);
    ball.start.spin = number(element, Data::spin, 0);
    physics::DiscRegion const place = disc(element);
    ball.start.position = place.centre;
    ball.radius = place.radius;
    if (!(std::abs(ball.start.spin) * ball.radius <= most_speed))
        throw Broken("data-spin must move the rim with at most 1e6 m/s, got " + shown(ball.start.spin) + " rad/s");
    auto& players = element.context.copy == Copy::none ? players_ : copied_players_;
    if (element.context.id == "player") players.push_back(static_cast<int>(reading_.level.scene.balls.size()));
    reading_.level.scene.balls.push_back(ball);
    reading_.ball_lines.push_back(element.line);
    reading_.level.ball_tints.push_back(tint_of(element.context.style, paints_));
}

void Elements::add_sensor(Element const& element, physics::Sensor sensor, Meaning meaning) {
    reading_.level.scene.sensors.push_back(std::move(sensor));
    reading_.level.meanings.push_back(meaning);
    reading_.level.sensor_elements.push_back(sensor_elements_);
    reading_.level.sensor_tints.push_back(tint_of(element.context.style, paints_));
    reading_.sensor_lines.push_back(element.line);
}

void Elements::read_banana(Element const& element) {
    physics::Sensor sensor;
    sensor.region = disc(element);
    sensor.rim = true;
    add_sensor(element, sensor, Meaning::banana);
    ++sensor_elements_;
}

void Elements::read_goal(Element const& element) {
    if (goal_corners_met_ > most_goal_corners) return;
    auto const goal = goal_regions(element.node, element.tag, element.context.to_world, element.context.viewport.size);
    if (goal.regions.empty()) return warn(element, "is empty");
    goal_corners_met_ += goal.parted;
    if (goal_corners_met_ > most_goal_corners)
        throw Broken("all goals that are not convex must have at most 5000 corners together; draw simpler ones");
    for (physics::Region const& region : goal.regions) {
        physics::Sensor sensor;
        sensor.region = region;
        add_sensor(element, sensor, Meaning::goal);
    }
    ++sensor_elements_;
}

// Paint and units that browsers know and this program does not are no faults; what nobody can read is.
void Elements::read_decoration(Element const& element) {
    if (!is_shape(element.tag)) {
        std::string const what = element.context.role ? what_to_do_with(element.tag) : "";
        return warn(element, "is ignored" + what);
    }
    try {
        Style style = element.context.style;
        if (element.tag == "line") style.fill = "none";
        auto const traced_shape =
            traced_within_limits(element, shape_of(element.node, element.tag, element.context.viewport.size));
        for (Decoration const& part : painted(element, traced_shape.outlines, style))
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
