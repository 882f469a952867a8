#include "hunt/kinds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "hunt/ground.h"
#include "hunt/pen.h"
#include "level/hash.h"

namespace hunt {

namespace {

constexpr Kind all[] = {{"lines", draw_lines},    {"arcs", draw_arcs},     {"stones", draw_stones},
                        {"grid", draw_grid},      {"curves", draw_curves}, {"gaps", draw_gaps},
                        {"narrow", draw_narrow},  {"twice", draw_twice},   {"zero-g", draw_zero_g},
                        {"rounded", draw_rounded}};
constexpr char with_player[] = "+player";
constexpr double full_grip = std::numeric_limits<double>::infinity();

// The ball as it is before it has a place.
physics::Ball drawn_ball(Dice& dice) {
    physics::Ball ball;
    ball.radius = dice.chance(0.5) ? dice.pick({0.05, 0.1, 0.2, 0.25, 0.3, 0.5, 1}) : dice.scaled(0.05, 1);
    ball.inertia = dice.chance(0.6) ? 0.5 : dice.between(0.1, 1);
    ball.start.velocity = dice.chance(0.3)   ? Vec2(0, 0)
                          : dice.chance(0.7) ? Vec2(dice.between(0, 6) * dice.direction())
                                             : Vec2(dice.scaled(6, 50) * dice.direction());
    ball.start.spin = dice.chance(0.4) ? 0 : dice.chance(0.7) ? dice.between(-10, 10) : dice.between(-100, 100);
    return ball;
}

bool is_curved(Sketch const& sketch) {
    for (Element const& element : sketch.elements)
        for (Stroke const& stroke : element.strokes)
            if (std::holds_alternative<Cubic>(stroke) || std::holds_alternative<Quadratic>(stroke)) return true;
    return false;
}

// A place that touches the ground, or nearly does, on a side and at a point drawn by lot.
Vec2 place_beside(Dice& dice, Ground const& ground, double radius) {
    Limb const& limb = ground[static_cast<std::size_t>(dice.whole(0, static_cast<int>(ground.size()) - 1))];
    double const gap = dice.chance(0.5) ? 0 : dice.scaled(1e-9, 1e-3);
    if (limb.round) {
        auto const [sine, cosine] = geometry::sine_cosine(limb.start + dice.unit() * limb.sweep);
        return limb.centre + (limb.radius + dice.sign() * (radius + gap)) * Vec2(cosine, sine);
    }
    Vec2 const along = limb.to - limb.from;
    if (geometry::length(along) == 0) return limb.from;
    Vec2 const normal = dice.sign() * geometry::turned_left(along) / geometry::length(along);
    return limb.from + dice.unit() * along + (radius + gap) * normal;
}

bool is_clear(Ground const& ground, Vec2 const& place, double least) {
    return nearest_on(ground, place).distance >= least - 1e-15;
}

// How far a ball must keep from the ground as drawn, m.
double least_distance(Sketch const& sketch) { return sketch.ball.radius + (is_curved(sketch) ? 3e-3 : 0); }

Vec2 place_for(Dice& dice, Sketch const& sketch, std::vector<Vec2> const& hints) {
    Ground const ground = ground_of(sketch.elements);
    double const radius = sketch.ball.radius;
    bool const beside = dice.chance(0.3);
    for (int trial = 0; trial < 300; ++trial) {
        bool const hinted = !hints.empty() && trial < 20;
        Vec2 const place =
            hinted   ? hints[static_cast<std::size_t>(dice.whole(0, static_cast<int>(hints.size()) - 1))]
            : beside ? place_beside(dice, ground, radius)
                     : Vec2(dice.between(radius, sketch.width - radius), dice.between(radius, sketch.height - radius));
        if (is_clear(ground, place, least_distance(sketch))) return place;
    }
    Vec2 above(sketch.width / 2, sketch.height + 1.5);  // nothing was free
    while (!is_clear(ground, above, least_distance(sketch))) above.y() += radius;
    return above;
}

}  // namespace

std::span<Kind const> kinds() { return all; }

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (char const* end : {"", with_player})
        for (Kind const& kind : all) names.push_back(std::string(kind.name) + end);
    return names;
}

Sketch sketch_of(std::string const& name, std::uint64_t seed) {
    std::string const base = name.substr(0, name.find('+'));
    auto const kind = std::find_if(std::begin(all), std::end(all), [&](Kind const& k) { return k.name == base; });
    if (kind == std::end(all) || (name != base && name != base + with_player))
        throw std::invalid_argument("there is no kind " + name);
    Dice dice(level::fnv1a(std::as_bytes(std::span(name)), seed ^ level::fnv1a_offset));
    Sketch sketch;
    sketch.ball = drawn_ball(dice);
    std::vector<Vec2> const hints = kind->draw(dice, sketch);
    sketch.ball.start.position = place_for(dice, sketch, hints);
    if (name != base) add_player(dice, sketch);
    return sketch;
}

bool starts_clear(Sketch const& sketch) {
    return is_clear(ground_of(sketch.elements), sketch.ball.start.position, least_distance(sketch));
}

physics::Material drawn_material(Dice& dice) {
    physics::Material material;
    material.restitution = dice.pick({0, 0, 0.3, 0.5, 0.8, 0.9, 0.99, 0.999, 1});
    material.friction = dice.pick({0, 0.05, 0.3, 0.9, 0.9, 3, full_grip});
    material.rolling_resistance = dice.chance(0.7) ? 0 : dice.pick({0.01, 0.05, 0.3});
    return material;
}

void add_box(Sketch& sketch, physics::Material const& material, double corner_radius) {
    double const left = 0.1, low = 0.1, right = sketch.width - 0.1, high = sketch.height - 0.1, r = corner_radius;
    Pen pen({left + r, low}, {1, 0});
    if (r == 0) {
        pen.to({right, low}).to({right, high}).to({left, high}).to({left, low});
    } else {
        for (double const side : {right - left, high - low, right - left, high - low})
            pen.ahead(side - 2 * r).bend(r, geometry::pi / 2);
    }
    sketch.elements.push_back({pen.strokes(), material});
}

Vec2 drawn_point(Dice& dice, Sketch const& sketch) {
    Vec2 const point(dice.between(0.5, sketch.width - 0.5), dice.between(0.5, sketch.height - 0.5));
    if (dice.chance(0.5)) return point;
    return {std::round(point.x() * 100) / 100, std::round(point.y() * 100) / 100};
}

Drawing any_ground(Dice& dice) {
    constexpr Drawing grounds[] = {draw_lines, draw_arcs, draw_stones, draw_grid};
    return grounds[dice.whole(0, 3)];
}

void add_player(Dice& dice, Sketch& sketch) {
    sketch.drag_frequency = dice.chance(0.3) ? 3 : dice.scaled(0.3, 30);
    sketch.drag_damping = dice.pick({0, 0.05, 0.3, 0.7, 0.7, 1, 1.5, 2});
    sketch.drag_reach = dice.chance(0.4) ? 4 : dice.scaled(0.5, 50);
    std::vector<double> times(static_cast<std::size_t>(dice.whole(1, 14)));
    for (double& time : times) time = dice.between(0, 10);
    if (dice.chance(0.2)) times[0] = 0;
    std::sort(times.begin(), times.end());
    Ground const ground = ground_of(sketch.elements);
    bool held = false;
    for (double const time : times) {
        Vec2 target(dice.between(-2, sketch.width + 2), dice.between(-2, sketch.height + 2));
        // Into a corner, or onto the ground.
        if (dice.chance(0.4))
            target = ground[static_cast<std::size_t>(dice.whole(0, static_cast<int>(ground.size()) - 1))].from;
        if (dice.chance(0.2)) {
            sketch.inputs.push_back({time, game::Tilt{dice.chance(0.3) ? 0 : dice.between(-0.4, 0.4)}});
        } else if (!held) {
            sketch.inputs.push_back({time, game::Grab{0, target}});
            held = true;
        } else if (dice.chance(0.6)) {
            sketch.inputs.push_back({time, game::Move{target}});
        } else {
            sketch.inputs.push_back({time, game::Release{}});
            held = false;
        }
    }
}

}  // namespace hunt
