#include "view/backdrop.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "view/drawn_colour.h"
#include "view/palette.h"
#include "view/outline_points.h"

namespace view {

namespace {

Colour css_colour(std::string const& text, double opacity) {
    unsigned long const rgb = text.size() == 7 ? std::strtoul(text.c_str() + 1, nullptr, 16) : 0x808080;
    return colour(static_cast<std::uint32_t>(rgb), static_cast<float>(opacity));
}

// The colours of what is far away: the drawing's where it names any.
struct Scenery {
    Colour sky_top = palette::sky_top, sky_bottom = palette::sky_bottom;
    Colour crest[3] = {palette::far_hill, palette::middle_hill, palette::near_hill};
    Colour foot[3] = {palette::far_foot, palette::middle_foot, palette::near_foot};
    std::optional<Colour> sun = palette::sun;
    Colour glow = palette::sun_glow;
    std::optional<Colour> cloud = palette::cloud;
    Colour cloud_shade = palette::cloud_shade;
};

Scenery scenery_of(level::Look const& look) {
    Scenery scenery;
    if (!look.sky.empty()) {
        scenery.sky_top = css_colour(look.sky[0], 1);
        scenery.sky_bottom = css_colour(look.sky[1], 1);
        scenery.cloud_shade = faded(mixed(palette::cloud, scenery.sky_top, 0.3f), 0.9f);
    }
    for (std::size_t i = 0; i < look.hills.size(); ++i) {
        scenery.crest[i] = css_colour(look.hills[i], 1);
        scenery.foot[i] = mixed(scenery.crest[i], scenery.sky_bottom, 0.45f);
    }
    if (look.sun == level::no_colour) {
        scenery.sun.reset();
    } else if (!look.sun.empty()) {
        scenery.sun = css_colour(look.sun, 0.95);
        scenery.glow = faded(*scenery.sun, 0.3f);
    }
    if (look.clouds == level::no_colour) {
        scenery.cloud.reset();
    } else if (!look.clouds.empty()) {
        scenery.cloud = css_colour(look.clouds, 0.92);
        scenery.cloud_shade = faded(mixed(*scenery.cloud, scenery.sky_top, 0.3f), 0.9f);
    }
    return scenery;
}

// Far things move less than the camera and grow less than the zoom.
struct Distance {
    double metre = 80;          // pixels
    Vec2 shift = Vec2::Zero();  // m by which the camera has left the level's middle
    Vec2 size = Vec2::Zero();   // pixels
    double foot = 720;          // pixels, where the hills stand
    double unit = 80;           // pixels, a metre of a level that just fits
};

Distance distance_of(level::Level const& level, Camera const& camera) {
    double const unit = std::min(camera.size.x() / whole_width, camera.size.y() / whole_height);
    double const foot = camera.size.y() / 2 + unit * whole_height / 2;
    return {unit * std::pow(camera.scale / unit, 0.3), camera.centre - camera.swing - level.size / 2, camera.size, foot,
            unit};
}

struct Ridge {
    double nearness = 0.1;  // 0 does not move, 1 moves with the ground
    double height = 3;      // m above the lower edge of the picture
    double swing = 0.6;     // m
    double length = 5;      // m
    double seed = 0;
    Colour crest, foot;
};

double ridge_height(Ridge const& ridge, double x) {
    double const u = x / ridge.length + ridge.seed;
    return ridge.height + ridge.swing * (std::sin(u * 2.1) + 0.5 * std::sin(u * 4.7 + 1.3) + 0.22 * std::sin(u * 11.3));
}

// Pixels: no point of its crest is below this.
double ridge_foot(Ridge const& ridge, Distance const& distance) {
    double const lowest = ridge.height - 1.72 * ridge.swing - ridge.nearness * distance.shift.y();
    return distance.foot - lowest * distance.metre + 2;
}

// Down to `floor`, below which nearer things hide the ridge.
Area ridge_area(Ridge const& ridge, Distance const& distance, double floor) {
    Area area;
    std::vector<Vec2>& ring = area.rings.emplace_back();
    int constexpr pieces = 96;
    double const drop = ridge.nearness * distance.shift.y();
    double const margin = 4;  // pixels, so that the rim of the area stays out of sight
    for (int i = 0; i <= pieces; ++i) {
        double const x = -margin + (distance.size.x() + 2 * margin) * i / pieces;
        double const metres = (x - distance.size.x() / 2) / distance.metre + ridge.nearness * distance.shift.x();
        ring.push_back({x, distance.foot - (ridge_height(ridge, metres) - drop) * distance.metre});
    }
    ring.push_back({distance.size.x() + margin, floor});
    ring.push_back({-margin, floor});
    area.paint.top = ridge.crest;
    area.paint.bottom = ridge.foot;
    area.paint.top_y = distance.foot - (ridge.height + 2 * ridge.swing - drop) * distance.metre;
    area.paint.bottom_y = distance.foot - (ridge.height - 2.2 - drop) * distance.metre;
    return area;
}

void add_cloud(std::vector<Shape>& shapes, Vec2 const& at, double size, Scenery const& scenery) {
    struct Puff {
        double x, y, r;
    };
    Puff const puffs[] = {
        {-1.25, 0.05, 0.42}, {-0.65, -0.28, 0.6}, {0.1, -0.45, 0.75}, {0.8, -0.2, 0.55}, {1.35, 0.08, 0.4}};
    double const soft = 0.12 * size;
    for (Puff const& puff : puffs)
        shapes.emplace_back(
            Disc{at + size * Vec2(puff.x, puff.y + 0.14), puff.r * size, scenery.cloud_shade, {}, 0, soft});
    for (Puff const& puff : puffs)
        shapes.emplace_back(Disc{at + size * Vec2(puff.x, puff.y), puff.r * size, *scenery.cloud, {}, 0, soft});
}

void add_sky(std::vector<Shape>& shapes, Distance const& distance, Scenery const& scenery) {
    shapes.emplace_back(Sky{scenery.sky_top, scenery.sky_bottom});
    Vec2 const sun(distance.size.x() * 0.8, distance.size.y() * 0.17);
    double const unit = distance.unit;
    if (scenery.sun) {
        shapes.emplace_back(Disc{sun, 2.4 * unit, scenery.glow, {}, 0, 2.2 * unit});
        shapes.emplace_back(Disc{sun, 0.62 * unit, *scenery.sun, {}, 0, 0.06 * unit});
    }
    if (!scenery.cloud) return;
    struct Place {
        double x, y, size;
    };
    Place const places[] = {{2.5, 1.5, 0.62}, {7.2, 0.95, 0.42}, {10.4, 2.2, 0.5}, {15, 1.3, 0.55}, {18.6, 2.0, 0.66}};
    double const period = std::max(21.0, distance.size.x() / unit + 5);  // m
    for (Place const& place : places) {
        double const drift = place.x - 0.06 * distance.shift.x() + 2.5;
        double const x = drift - period * std::floor(drift / period) - 2.5;
        double const y = place.y + 0.05 * distance.shift.y();
        add_cloud(shapes, Vec2(x, y) * unit, place.size * unit, scenery);
    }
}

void add_hills(std::vector<Shape>& shapes, Distance const& distance, Scenery const& scenery) {
    Ridge const ridges[] = {{0.08, 3.9, 0.55, 4.2, 0.4, scenery.crest[0], scenery.foot[0]},
                            {0.16, 2.7, 0.5, 3.3, 2.9, scenery.crest[1], scenery.foot[1]},
                            {0.28, 1.5, 0.45, 2.8, 5.1, scenery.crest[2], scenery.foot[2]}};
    int constexpr count = 3;
    for (int i = 0; i < count; ++i) {
        double floor = distance.size.y() + 4;
        if (i + 1 < count) floor = std::min(floor, ridge_foot(ridges[i + 1], distance));
        shapes.emplace_back(ridge_area(ridges[i], distance, floor));
    }
}

void add_line(std::vector<Shape>& shapes, level::Outline const& outline, Camera const& camera, double width,
              Colour const& paint) {
    for (geometry::Curve const& curve : outline.curves) {
        if (auto const* segment = std::get_if<geometry::Segment>(&curve)) {
            Vec2 const from = pixel_of(camera, segment->start), to = pixel_of(camera, segment->end);
            shapes.emplace_back(Stroke{from, to, width, paint});
        } else {
            auto const& arc = std::get<geometry::Arc>(curve);
            Vec2 const centre = pixel_of(camera, arc.centre);
            double const from = turn_of(camera) - arc.from;
            shapes.emplace_back(ArcStroke{centre, arc.radius * camera.scale, from, -arc.sweep, width, paint});
        }
    }
}

Paint fading_paint(level::Fade const& fade, Camera const& camera) {
    Paint paint;
    paint.top = faded(drawn_colour(fade.top), static_cast<float>(fade.top_opacity));
    paint.bottom = faded(drawn_colour(fade.bottom), static_cast<float>(fade.bottom_opacity));
    paint.down = pixels_along(camera, -Vec2::UnitY()) / camera.scale;
    paint.top_y = geometry::dot(pixel_of(camera, {0, fade.top_y}), paint.down);
    paint.bottom_y = geometry::dot(pixel_of(camera, {0, fade.bottom_y}), paint.down);
    return paint;
}

void add_decoration(std::vector<Shape>& shapes, level::Decoration const& decoration, Camera const& camera) {
    if (decoration.fill) {
        Area area;
        area.rule = decoration.fill_rule;
        area.paint.top = area.paint.bottom =
            faded(drawn_colour(*decoration.fill), static_cast<float>(decoration.opacity));
        if (decoration.fade) area.paint = fading_paint(*decoration.fade, camera);
        for (level::Outline const& outline : decoration.outlines) {
            std::vector<Vec2>& ring = area.rings.emplace_back();
            for (Vec2 const& point : points_along(outline, 1e9)) ring.push_back(pixel_of(camera, point));
        }
        shapes.emplace_back(std::move(area));
    }
    if (!decoration.stroke || decoration.stroke_width <= 0) return;
    Colour const paint = faded(drawn_colour(*decoration.stroke), static_cast<float>(decoration.opacity));
    for (level::Outline const& outline : decoration.outlines)
        add_line(shapes, outline, camera, decoration.stroke_width * camera.scale, paint);
}

bool in_sight(level::Decoration const& decoration, geometry::Box const& sight) {
    geometry::Box const seen = geometry::grown(sight, decoration.stroke_width);
    for (level::Outline const& outline : decoration.outlines)
        for (geometry::Curve const& curve : outline.curves)
            if (geometry::overlap(geometry::box_of(curve), seen)) return true;
    // A shape may surround all that is seen without a line of it in sight.
    geometry::Box whole;
    for (level::Outline const& outline : decoration.outlines)
        for (geometry::Curve const& curve : outline.curves) whole = geometry::united(whole, geometry::box_of(curve));
    return decoration.fill && geometry::overlap(whole, seen);
}

}  // namespace

std::vector<Shape> backdrop_shapes(level::Level const& level, Ground const& ground, Camera const& camera) {
    std::vector<Shape> shapes;
    Distance const distance = distance_of(level, camera);
    Scenery const scenery = scenery_of(level.look);
    add_sky(shapes, distance, scenery);
    add_hills(shapes, distance, scenery);
    geometry::Box const sight = sight_of(camera);
    std::size_t const count = level.decorations.size(), in_front = std::min(level.in_front.value_or(count), count);
    auto const add_decorations = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            if (in_sight(level.decorations[i], sight)) add_decoration(shapes, level.decorations[i], camera);
    };
    add_decorations(0, in_front);
    for (Shape& shape : ground_shapes(ground, camera)) shapes.emplace_back(std::move(shape));
    add_decorations(in_front, count);
    return shapes;
}

unsigned long long backdrop_key_of(level::Level const& level, Camera const& camera) {
    unsigned long long hash = 14695981039346656037ull;  // FNV-1a
    auto const add = [&](void const* bytes, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            hash = (hash ^ static_cast<unsigned char const*>(bytes)[i]) * 1099511628211ull;
    };
    add(level.hash.data(), level.hash.size());
    add(level.file.data(), level.file.size());
    double const numbers[] = {camera.centre.x(), camera.centre.y(), camera.scale,     camera.size.x(), camera.size.y(),
                              camera.right.x(),  camera.right.y(),  camera.swing.x(), camera.swing.y()};
    add(numbers, sizeof numbers);
    return hash == 0 ? 1 : hash;
}

}  // namespace view
