#include "view/actors.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/drawn_colour.h"
#include "view/effects.h"
#include "view/palette.h"

namespace view {

namespace {

struct GroundNearby {
    geometry::Nearest nearest;
    bool found = false;
};

GroundNearby ground_near(physics::Terrain const& terrain, Vec2 const& centre, double reach) {
    GroundNearby ground;
    terrain.tree.each_overlapping(geometry::grown({centre, centre}, reach), [&](int piece) {
        geometry::Nearest const nearest =
            geometry::nearest_point(terrain.pieces[static_cast<std::size_t>(piece)].curve, centre);
        if (nearest.distance <= reach && (!ground.found || nearest.distance < ground.nearest.distance))
            ground = {nearest, true};
    });
    return ground;
}

bool in_sight(Camera const& camera, Vec2 const& centre, double radius) {
    return geometry::overlap(sight_of(camera), geometry::grown({centre, centre}, radius));
}

// A soft flat spot on the ground under the ball, smaller and fainter the higher it is.
void add_shadow(std::vector<Shape>& shapes, physics::Terrain const& terrain, Vec2 const& centre, double radius,
                Camera const& camera) {
    double constexpr reach = 3.5;  // radii
    GroundNearby const ground = ground_near(terrain, centre, reach * radius);
    if (!ground.found || ground.nearest.distance < 1e-9) return;
    Vec2 const normal = (centre - ground.nearest.point) / ground.nearest.distance;
    double const height = std::max(0.0, ground.nearest.distance / radius - 1) / (reach - 1);
    float const strength = static_cast<float>((1 - height) * (1 - height));
    Vec2 const along = geometry::turned_right(normal);
    // Soft spots in a row look like one flat one.
    int constexpr spots = 13;
    double const half = radius * (0.8 - 0.25 * height);
    double const soft = 0.2 * radius * camera.scale;
    for (int i = 0; i < spots; ++i) {
        double const share = 2.0 * i / (spots - 1) - 1;
        Vec2 const at = pixel_of(camera, ground.nearest.point + share * half * along - 0.06 * radius * normal);
        float const alpha = 0.28f * strength * static_cast<float>(1 - share * share);
        shapes.emplace_back(Disc{at, 0.5 * soft, faded(palette::shadow, alpha), {}, 0, soft});
    }
    Vec2 const spot = pixel_of(camera, ground.nearest.point - 0.05 * radius * normal);
    double const deep = 0.36 * radius * camera.scale;
    shapes.emplace_back(Disc{spot, 0.6 * deep, faded(palette::shadow, 0.8f * strength), {}, 0, deep});
}

std::vector<Vec2> crescent(double outer_bend, double inner_bend) {
    // Two arcs through the same tips (-1, 0) and (1, 0); a bend is the depth of the arc at its middle.
    std::vector<Vec2> points;
    int constexpr pieces = 20;
    auto const bow = [](double x, double bend) { return -bend * std::sqrt(std::max(0.0, 1 - x * x)); };
    for (int i = 0; i <= pieces; ++i) {
        double const x = -std::cos(geometry::pi * i / pieces);
        points.push_back({x, bow(x, outer_bend)});
    }
    for (int i = pieces - 1; i > 0; --i) {
        double const x = -std::cos(geometry::pi * i / pieces);
        points.push_back({x, bow(x, inner_bend)});
    }
    return points;
}

struct Placing {
    Vec2 middle = Vec2::Zero();  // pixels
    double size = 1;             // pixels
    double angle = 0;            // rad, on the screen
};

Vec2 placed(Placing const& placing, Vec2 const& point) {
    double const cosine = std::cos(placing.angle), sine = std::sin(placing.angle);
    return placing.middle + placing.size * geometry::turned(Vec2(point.x(), -point.y()), cosine, sine);
}

void add_crescent(std::vector<Shape>& shapes, Placing const& placing, double outer, double inner, Colour const& paint) {
    Area area;
    std::vector<Vec2>& ring = area.rings.emplace_back();
    for (Vec2 const& point : crescent(outer, inner)) ring.push_back(placed(placing, point + Vec2(0, 0.35)));
    area.paint.top = area.paint.bottom = paint;
    shapes.emplace_back(std::move(area));
}

void add_banana(std::vector<Shape>& shapes, Placing const& placing, float presence) {
    shapes.emplace_back(
        Disc{placing.middle, 1.15 * placing.size, faded(colour(0xfff3a0, 0.55f), presence), {}, 0, placing.size});
    double const edge = 0.09;
    for (Vec2 const& tip : {Vec2(-1, 0.38), Vec2(1, 0.38)})
        shapes.emplace_back(
            Disc{placed(placing, tip), 0.13 * placing.size, faded(palette::banana_tip, presence), {}, 0, 0});
    add_crescent(shapes, placing, 1.02 + edge, 0.36 - edge, faded(palette::banana_tip, presence));
    add_crescent(shapes, placing, 1.02, 0.36, faded(palette::banana_shade, presence));
    add_crescent(shapes, placing, 0.86, 0.36, faded(palette::banana, presence));
    add_crescent(shapes, placing, 0.62, 0.5, faded(colour(0xfff7b8), presence));
}

// Picked up: a ring of light that opens and is gone.
void add_spark(std::vector<Shape>& shapes, Vec2 const& at, double size, double age) {
    double constexpr lasting = 0.45;  // s
    if (age >= lasting) return;
    double const share = age / lasting;
    float const left = static_cast<float>(1 - share);
    shapes.emplace_back(
        ArcStroke{at, size * (0.8 + 1.4 * share), 0, 2 * geometry::pi, 0.22 * size * left, faded(palette::gold, left)});
    for (int i = 0; i < 8; ++i) {
        Vec2 const way(std::cos(i * 0.7854 + 0.3), std::sin(i * 0.7854 + 0.3));
        Vec2 const from = at + way * size * (0.9 + 1.5 * share);
        shapes.emplace_back(Stroke{from, from + way * size * 0.35 * left, 0.12 * size, faded(palette::bright, left)});
    }
    Vec2 const above = at - Vec2(0, size * (0.9 + 1.8 * share));
    double const rim = 0.13 * size;
    for (int i = 0; i < 8; ++i) {
        Vec2 const off = rim * Vec2(std::cos(i * 0.7854), std::sin(i * 0.7854));
        shapes.emplace_back(
            Label{above + off, 2 * size, "+1", faded(palette::ink, 0.5f * left * left), Anchor::Centre, Weight::bold});
    }
    shapes.emplace_back(Label{above, 2 * size, "+1", faded(palette::gold, left), Anchor::Centre, Weight::bold});
}

physics::DiscRegion const* banana_in(level::Level const& level, std::size_t sensor) {
    if (level.meanings[sensor] != level::Meaning::banana) return nullptr;
    return std::get_if<physics::DiscRegion>(&level.scene.sensors[sensor].region);
}

double phase_of(Moment const& moment, std::size_t banana) {
    return 2.4 * moment.time + 1.7 * static_cast<double>(banana);
}

}  // namespace

std::vector<Shape> banana_shapes(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    Vec2 const up = pixels_along(camera, Vec2::UnitY()) / camera.scale;
    for (std::size_t i = 0; i < level.scene.sensors.size(); ++i) {
        auto const* disc = banana_in(level, i);
        if (!disc || has_fired(moment, i) || !in_sight(camera, disc->centre, 4 * disc->radius)) continue;
        double const size = disc->radius * camera.scale, phase = phase_of(moment, i);
        Vec2 const at = pixel_of(camera, disc->centre) + 0.12 * size * std::sin(phase) * up;
        add_banana(shapes, {at, 0.95 * size, -0.45 + 0.16 * std::sin(0.8 * phase) + turn_of(camera)}, 1);
    }
    return shapes;
}

std::vector<Shape> pick_shapes(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < level.scene.sensors.size(); ++i) {
        auto const* disc = banana_in(level, i);
        if (!disc || !has_fired(moment, i) || !in_sight(camera, disc->centre, 4 * disc->radius)) continue;
        add_spark(shapes, pixel_of(camera, disc->centre), disc->radius * camera.scale,
                  moment.time - moment.noticed_at[i]);
    }
    return shapes;
}

std::vector<Shape> shadow_shapes(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < moment.balls.size(); ++i) {
        double const radius = level.scene.balls[i].radius;
        if (in_sight(camera, moment.balls[i].position, 4 * radius))
            add_shadow(shapes, level.scene.terrain, moment.balls[i].position, radius, camera);
    }
    return shapes;
}

// A ball that the drawing paints keeps its colour: the other half of its shell is lighter.
std::optional<Livery> own_livery(level::Level const& level, std::size_t ball) {
    if (ball >= level.ball_tints.size()) return std::nullopt;
    level::Tint const& tint = level.ball_tints[ball];
    std::optional<std::string> const& given = tint.fill ? tint.fill : tint.stroke;
    if (!given) return std::nullopt;
    Colour const upper = drawn_colour(*given);
    return Livery{upper, mixed(upper, colour(0xfff6e0), 0.55f)};
}

std::vector<Shape> ball_shapes(level::Level const& level, Moment const& moment, Camera const& camera,
                               std::optional<Vec2> const& pointer) {
    std::vector<Shape> shapes;
    int livery = 0;
    for (std::size_t i = 0; i < moment.balls.size(); ++i) {
        bool const player = static_cast<int>(i) == level.player;
        if (!player) ++livery;
        double const radius = level.scene.balls[i].radius;
        if (!in_sight(camera, moment.balls[i].position, radius)) continue;
        Shell shell;
        shell.centre = pixel_of(camera, moment.balls[i].position);
        shell.radius = radius * camera.scale;
        shell.angle = moment.balls[i].angle - turn_of(camera);
        shell.livery = player ? 0 : livery;
        shell.own = own_livery(level, i);
        shell.monkey = monkey_of(moment, static_cast<int>(i), shell, camera, player ? pointer : std::nullopt);
        shapes.emplace_back(shell);
    }
    return shapes;
}

}  // namespace view
