#include "view/contrast.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/hud.h"
#include "view/palette.h"
#include "view/surface_look.h"

namespace view {

namespace {

constexpr double round = 2 * geometry::pi;
constexpr Colour black = colour(0x000000), white = colour(0xffffff);
constexpr double least_ratio = 4.5;      // of letters to their plate (WCAG 2.1)
constexpr float plate_alpha = 0.6f;      // a panel that hides at least so much is a plate for letters
constexpr float veil_alpha = 0.75f;      // of what darkens the whole picture
constexpr double sign_spacing = 0.45;    // m along a curve, from sign to sign
constexpr std::size_t most_signs = 400;  // of one curve

// Of a channel of sRGB, its share of the light (IEC 61966-2-1).
double linear(float channel) {
    double const value = channel;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double luminance(Colour const& c) {
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

Colour letters_on(Colour const& plate) {
    return contrast_ratio(plate, white) >= contrast_ratio(plate, black) ? white : black;
}

// The same hue, as far towards black or white as it takes to be read.
Colour deepened(Colour const& colour, Colour const& plate) {
    Colour const end = letters_on(plate);
    constexpr int steps = 16;
    for (int i = 0; i < steps; ++i) {
        float const share = static_cast<float>(i) / steps;
        auto const mixed = [&](float from, float to) { return from + share * (to - from); };
        Colour const tried{mixed(colour.red, end.red), mixed(colour.green, end.green), mixed(colour.blue, end.blue), 1};
        if (contrast_ratio(plate, tried) >= least_ratio) return tried;
    }
    return end;
}

bool holds(Panel const& panel, Vec2 const& place) {
    Vec2 const inside = place - panel.corner;
    return inside.x() >= 0 && inside.y() >= 0 && inside.x() <= panel.size.x() && inside.y() <= panel.size.y();
}

// A veil over the whole picture is no plate.
bool is_veil(Panel const& panel) { return panel.rounding == 0 && panel.corner == Vec2::Zero(); }

void add_stroke(std::vector<Shape>& shapes, Vec2 const& from, Vec2 const& to, double width) {
    shapes.emplace_back(Stroke{from, to, 2.2 * width, black});
    shapes.emplace_back(Stroke{from, to, width, white});
}

void add_ring(std::vector<Shape>& shapes, Vec2 const& centre, double radius, double width) {
    shapes.emplace_back(ArcStroke{centre, radius, 0, round, 2.2 * width, black});
    shapes.emplace_back(ArcStroke{centre, radius, 0, round, width, white});
}

// At a share of a curve: its place and its unit tangent.
struct Station {
    Vec2 place, along;
};
Station station_at(geometry::Curve const& curve, double share) {
    if (auto const* segment = std::get_if<geometry::Segment>(&curve)) {
        Vec2 const way = segment->end - segment->start;
        return {segment->start + share * way, way / std::max(geometry::length(way), 1e-12)};
    }
    auto const& arc = std::get<geometry::Arc>(curve);
    double const angle = arc.from + share * arc.sweep;
    Vec2 const out(std::cos(angle), std::sin(angle));
    return {arc.centre + arc.radius * out, geometry::turned_left(out) * (arc.sweep < 0 ? -1 : 1)};
}

// One sign of a surface; `side` is a pixel-length unit across the curve, `along` one along it.
void add_sign(std::vector<Shape>& shapes, SurfaceLook const& look, Vec2 const& at, Vec2 const& along, Vec2 const& side,
              double unit) {
    if (look.bouncy) {
        add_stroke(shapes, at - 9 * along, at - 8 * side, 1.8 * unit);
        add_stroke(shapes, at - 8 * side, at + 9 * along, 1.8 * unit);
    }
    switch (look.base) {
        case Base::ice:
            for (double const shift : {-4.5, 4.5})
                add_stroke(shapes, at + (shift - 3) * along - 7 * side, at + (shift + 3) * along + 7 * side,
                           1.5 * unit);
            break;
        case Base::mud:
            shapes.emplace_back(Disc{at, 6.5 * unit, black, white, 2 * unit, 0});
            break;
        case Base::tread:
            add_stroke(shapes, at - 8 * side, at + 8 * side, 2.6 * unit);
            break;
        case Base::grass:
            break;
    }
}

void add_signs_along(std::vector<Shape>& shapes, physics::Piece const& piece, Camera const& camera, double unit) {
    SurfaceLook const look = look_of(piece.material);
    if (look == SurfaceLook{}) return;
    double const spacing = std::max(sign_spacing, 26 * unit / camera.scale);
    double const whole = geometry::length_of(piece.curve);
    auto const count = static_cast<std::size_t>(std::clamp(std::round(whole / spacing), 1.0, double{most_signs}));
    for (std::size_t i = 0; i < count; ++i) {
        Station const station = station_at(piece.curve, (static_cast<double>(i) + 0.5) / static_cast<double>(count));
        Vec2 const along = unit * pixels_along(camera, station.along) / camera.scale;
        add_sign(shapes, look, pixel_of(camera, station.place), along, Vec2(-along.y(), along.x()), unit);
    }
}

// Colours of one width, so that what is black of one curve does not lie over what is white of the next.
void add_curve(std::vector<Shape>& shapes, geometry::Curve const& curve, Camera const& camera, double width,
               Colour const& paint) {
    if (auto const* segment = std::get_if<geometry::Segment>(&curve)) {
        shapes.emplace_back(Stroke{pixel_of(camera, segment->start), pixel_of(camera, segment->end), width, paint});
        return;
    }
    auto const& arc = std::get<geometry::Arc>(curve);
    // Counter-clockwise in the world is the other way on the screen, and the picture may be turned.
    shapes.emplace_back(ArcStroke{pixel_of(camera, arc.centre), arc.radius * camera.scale, turn_of(camera) - arc.from,
                                  -arc.sweep, width, paint});
}

}  // namespace

double contrast_ratio(Colour const& a, Colour const& b) {
    double const la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

std::vector<Shape> in_high_contrast(std::vector<Shape> shapes, Hue hue) {
    std::vector<Shape> result;
    std::vector<Panel> plates;
    for (Shape& shape : shapes) {
        auto* const panel = std::get_if<Panel>(&shape);
        if (panel && is_veil(*panel)) {
            panel->colour = faded(black, veil_alpha);
        } else if (panel && panel->colour.alpha >= plate_alpha) {
            panel->colour.alpha = 1;
            plates.push_back(*panel);
            Vec2 const rim = Vec2::Constant(std::min(2.0, 0.06 * panel->size.y()));
            result.emplace_back(Panel{panel->corner - rim, panel->size + 2 * rim, panel->rounding + rim.x(),
                                      letters_on(panel->colour)});
        } else if (auto* label = std::get_if<Label>(&shape)) {
            auto const plate =
                std::find_if(plates.rbegin(), plates.rend(), [&](Panel const& one) { return holds(one, label->at); });
            if (plate == plates.rend()) {
                result.emplace_back(std::move(shape));
                continue;
            }
            Colour const& paper = plate->colour;
            label->colour =
                faded(hue == Hue::kept ? deepened(label->colour, paper) : letters_on(paper), label->colour.alpha);
        }
        result.emplace_back(std::move(shape));
    }
    return result;
}

std::vector<Shape> terrain_outlines(physics::Terrain const& terrain, Camera const& camera) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(camera.size);
    geometry::Box const sight = geometry::grown(sight_of(camera), 20 * unit / camera.scale);
    std::vector<physics::Piece const*> seen;
    for (physics::Piece const& piece : terrain.pieces)
        if (geometry::overlap(sight, geometry::box_of(piece.curve))) seen.push_back(&piece);
    for (physics::Piece const* piece : seen) add_curve(shapes, piece->curve, camera, 7 * unit, black);
    for (physics::Piece const* piece : seen) add_curve(shapes, piece->curve, camera, 3 * unit, white);
    for (physics::Piece const* piece : seen) add_signs_along(shapes, *piece, camera, unit);
    return shapes;
}

std::vector<Shape> actor_outlines(level::Level const& level, Moment const& moment, Camera const& camera) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(camera.size);
    for (std::size_t i = 0; i < level.meanings.size(); ++i) {
        physics::Region const& region = level.scene.sensors[i].region;
        auto const* disc = std::get_if<physics::DiscRegion>(&region);
        if (level.meanings[i] == level::Meaning::banana && disc && !has_fired(moment, i))
            add_ring(shapes, pixel_of(camera, disc->centre), 1.5 * disc->radius * camera.scale, 2 * unit);
        auto const* polygon = std::get_if<physics::PolygonRegion>(&region);
        if (level.meanings[i] != level::Meaning::goal || !polygon) continue;
        for (std::size_t corner = 0; corner < polygon->corners.size(); ++corner)
            add_stroke(shapes, pixel_of(camera, polygon->corners[corner]),
                       pixel_of(camera, polygon->corners[(corner + 1) % polygon->corners.size()]), 3 * unit);
    }
    for (std::size_t ball = 0; ball < moment.balls.size(); ++ball) {
        double const radius = level.scene.balls[ball].radius * camera.scale;
        Vec2 const at = pixel_of(camera, moment.balls[ball].position);
        bool const is_player = static_cast<int>(ball) == level.player;
        add_ring(shapes, at, radius, (is_player ? 3.5 : 1.5) * unit);
    }
    return shapes;
}

std::vector<Shape> dashed(std::vector<Shape> shapes) {
    for (Shape& shape : shapes)
        if (auto const* disc = std::get_if<Disc>(&shape)) {
            Vec2 const half(1.6 * disc->radius, 0);
            shape = Stroke{disc->centre - half, disc->centre + half, 1.1 * disc->radius, disc->fill};
        }
    return shapes;
}

}  // namespace view
