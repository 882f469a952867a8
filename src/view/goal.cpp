#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/actors.h"
#include "view/drawn_colour.h"
#include "view/palette.h"

namespace view {

namespace {

constexpr double whole_turn = 2 * geometry::pi;

struct Glow {
    double time = 0;     // s
    float strength = 1;  // brighter once it has been reached
    Colour light = palette::gold;
    Colour post = palette::gold, post_deep = palette::gold_deep;
    double metre = 80;                                 // pixels, of what has no size of its own
    Vec2 across = Vec2::UnitX(), up = -Vec2::UnitY();  // unit, on the screen: the world's axes
};

// The drawing's fill is the goal's light, its stroke the posts; of one alone, both.
Glow tinted(Glow glow, level::Tint const& tint) {
    std::optional<std::string> const& fill = tint.fill ? tint.fill : tint.stroke;
    std::optional<std::string> const& stroke = tint.stroke ? tint.stroke : tint.fill;
    if (!fill || !stroke) return glow;
    glow.light = drawn_colour(*fill);
    glow.post = drawn_colour(*stroke);
    glow.post_deep = mixed(glow.post, palette::ink, 0.4f);
    return glow;
}

// A band of small squares, black and white, from one point to another, hanging to the given side.
void add_checks(std::vector<Shape>& shapes, Vec2 const& from, Vec2 const& to, Vec2 const& side, double time) {
    double const length = geometry::length(to - from);
    double const square = geometry::length(side) / 3;
    int const columns = std::clamp(static_cast<int>(std::lround(length / std::max(square, 1.0))), 2, 60);
    auto const corner = [&](int column, int row) -> Vec2 {
        double const share = static_cast<double>(column) / columns;
        double const ripple = 0.09 * std::sin(3 * time - 9 * share) * row;
        return from + share * (to - from) + (row / 3.0 + ripple) * side;
    };
    Area cloth, checks;
    for (int column = 0; column <= columns; ++column) {
        if (column == 0) cloth.rings.emplace_back();
        cloth.rings[0].push_back(corner(column, 0));
    }
    for (int column = columns; column >= 0; --column) cloth.rings[0].push_back(corner(column, 3));
    for (int column = 0; column < columns; ++column)
        for (int row = column % 2; row < 3; row += 2)
            checks.rings.push_back(
                {corner(column, row), corner(column + 1, row), corner(column + 1, row + 1), corner(column, row + 1)});
    cloth.paint.top = cloth.paint.bottom = colour(0xffffff);
    checks.paint.top = checks.paint.bottom = colour(0x25303a);
    shapes.emplace_back(std::move(cloth));
    shapes.emplace_back(std::move(checks));
}

void add_post(std::vector<Shape>& shapes, Vec2 const& foot, Vec2 const& head, double width, Glow const& glow) {
    Vec2 const aside = 0.22 * width * glow.across;
    shapes.emplace_back(Stroke{foot, head, width, glow.post_deep});
    shapes.emplace_back(Stroke{foot - aside, head - aside, 0.4 * width, glow.post});
    shapes.emplace_back(Disc{head, 0.85 * width, glow.post, glow.post_deep, 0.2 * width, 0});
}

void add_gate(std::vector<Shape>& shapes, geometry::Box const& box, Camera const& camera, Glow const& glow) {
    Vec2 const left_foot = pixel_of(camera, box.low), right_head = pixel_of(camera, box.high);
    Vec2 const right_foot = pixel_of(camera, {box.high.x(), box.low.y()});
    Vec2 const left_head = pixel_of(camera, {box.low.x(), box.high.y()});
    Vec2 const width = right_foot - left_foot, height = left_head - left_foot;
    Area light;
    light.rings = {{left_foot, right_foot, right_head, left_head}};
    light.paint.top = faded(glow.light, 0.08f * glow.strength);
    light.paint.bottom = faded(glow.light, 0.5f * glow.strength);
    light.paint.down = -glow.up;
    light.paint.top_y = geometry::dot(left_head, light.paint.down);
    light.paint.bottom_y = geometry::dot(left_foot, light.paint.down);
    shapes.emplace_back(std::move(light));
    // Lights that rise through the gate.
    for (int i = 0; i < 7; ++i) {
        double const rise = 0.35 * glow.time + 0.381966 * i;
        double const share = rise - std::floor(rise);
        Vec2 const at = left_foot + width * (0.12 + 0.76 * std::fmod(0.618034 * i, 1.0)) + share * height;
        float const alpha = static_cast<float>(std::sin(geometry::pi * share)) * 0.8f;
        double const radius = 0.05 * glow.metre;
        shapes.emplace_back(Disc{at, radius, colour(0xfff6c0, alpha), {}, 0, 0.8 * radius});
    }
    double const post = 0.11 * glow.metre;
    double const cloth = std::min(0.36 * glow.metre, 0.4 * geometry::length(height));
    add_checks(shapes, left_head, right_head, -cloth * glow.up, glow.time);
    add_post(shapes, left_foot, left_head, post, glow);
    add_post(shapes, right_foot, right_head, post, glow);
}

void add_ring(std::vector<Shape>& shapes, physics::DiscRegion const& disc, Camera const& camera, Glow const& glow) {
    Vec2 const centre = pixel_of(camera, disc.centre);
    double const radius = disc.radius * camera.scale;
    double const width = std::min(0.12 * glow.metre, 0.3 * radius);
    shapes.emplace_back(Disc{centre, radius, faded(glow.light, 0.4f * glow.strength), {}, 0, 0.6 * radius});
    shapes.emplace_back(ArcStroke{centre, radius, 0, whole_turn, width, glow.post_deep});
    for (int i = 0; i < 8; ++i) {
        double const from = i * whole_turn / 8 + 0.6 * glow.time;
        shapes.emplace_back(ArcStroke{centre, radius, from, whole_turn / 16, 0.7 * width, colour(0xffffff)});
    }
    double const star = 0.34 * radius * (1 + 0.08 * std::sin(3 * glow.time));
    Area area;
    std::vector<Vec2>& ring = area.rings.emplace_back();
    for (int i = 0; i < 10; ++i) {
        double const angle = i * whole_turn / 10 - whole_turn / 4 + 0.15 * std::sin(1.3 * glow.time);
        ring.push_back(centre + (i % 2 == 0 ? 1.0 : 0.45) * star * Vec2(std::cos(angle), std::sin(angle)));
    }
    area.paint.top = area.paint.bottom = glow.post;
    shapes.emplace_back(std::move(area));
}

void add_finish(std::vector<Shape>& shapes, physics::LineRegion const& line, Camera const& camera, Glow const& glow) {
    Vec2 from = pixel_of(camera, line.from), to = pixel_of(camera, line.to);
    if (line.from.y() > line.to.y()) std::swap(from, to);  // `to` is the upper end
    double const post = 0.1 * glow.metre;
    shapes.emplace_back(Stroke{from, to, 3.5 * post, faded(glow.light, 0.2f * glow.strength)});
    Vec2 const way = line.to - line.from;  // m
    bool const upright = std::abs(way.y()) > std::abs(way.x());
    if (!upright) {
        add_checks(shapes, from, to, -0.27 * glow.metre * glow.up, 0);
        add_post(shapes, from, from + 0.15 * glow.metre * glow.up, post, glow);
        add_post(shapes, to, to + 0.15 * glow.metre * glow.up, post, glow);
        return;
    }
    double const flag = std::clamp(0.3 * geometry::length(to - from), 0.3 * glow.metre, 0.6 * glow.metre);
    add_checks(shapes, to, to + 1.5 * flag * glow.across, -flag * glow.up, glow.time);
    add_post(shapes, from, to, post, glow);
}

bool are_one(level::Level const& level, std::size_t a, std::size_t b) {
    std::vector<int> const& elements = level.sensor_elements;
    return a == b || (std::max(a, b) < elements.size() && elements[a] == elements[b]);
}

geometry::Box box_of_goal(level::Level const& level, std::size_t first) {
    geometry::Box box;
    for (std::size_t i = first; i < level.scene.sensors.size(); ++i) {
        auto const* part = std::get_if<physics::PolygonRegion>(&level.scene.sensors[i].region);
        if (part == nullptr || !are_one(level, i, first)) break;
        for (Vec2 const& corner : part->corners) box = geometry::united(box, {corner, corner});
    }
    return box;
}

}  // namespace

std::vector<Shape> goal_shapes(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < level.scene.sensors.size(); ++i) {
        if (level.meanings[i] != level::Meaning::goal) continue;
        Glow glow;
        glow.time = moment.time;
        glow.metre = size_unit(level) * camera.scale;
        glow.across = pixels_along(camera, Vec2::UnitX()) / camera.scale;
        glow.up = pixels_along(camera, Vec2::UnitY()) / camera.scale;
        if (has_fired(moment, i)) glow.strength = 1.6f;
        if (i < level.sensor_tints.size()) glow = tinted(glow, level.sensor_tints[i]);
        physics::Region const& region = level.scene.sensors[i].region;
        if (auto const* disc = std::get_if<physics::DiscRegion>(&region)) add_ring(shapes, *disc, camera, glow);
        if (auto const* line = std::get_if<physics::LineRegion>(&region)) add_finish(shapes, *line, camera, glow);
        // The parts of one goal follow each other and are one gate.
        bool const goes_on = i > 0 && are_one(level, i, i - 1);
        if (std::holds_alternative<physics::PolygonRegion>(region) && !goes_on)
            add_gate(shapes, box_of_goal(level, i), camera, glow);
    }
    return shapes;
}

}  // namespace view
