#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/ground.h"
#include "view/palette.h"

namespace view {

namespace {

constexpr double earth_fade = 5;  // m below its top, over which earth darkens, at least

struct Look {
    Colour top, bottom;
    double grain = 0;
};

Look paint_of(Cover cover) {
    switch (cover) {
        case Cover::earth:
            return {palette::earth_top, palette::earth_bottom, 0.8};
        case Cover::shade:
            return {palette::earth_shade, palette::earth_shade, 0};
        case Cover::rim:
            return {palette::earth_rim, palette::earth_rim, 0.4};
        case Cover::turf:
            return {palette::turf, palette::turf_low, 0.7};
        case Cover::ice:
            return {palette::ice, palette::ice_low, 0.1};
        case Cover::mud:
            return {palette::mud, palette::mud_low, 0.5};
        case Cover::tread:
            return {palette::tread, palette::tread, 0.25};
        case Cover::rubber:
            return {palette::rubber, palette::rubber, 0.1};
        case Cover::lit:
            break;
    }
    return {palette::turf_lit, palette::turf_lit, 0.15};
}

Area area_of(Patch const& patch, Camera const& camera) {
    Area area;
    for (std::vector<Vec2> const& ring : patch.rings) {
        std::vector<Vec2>& pixels = area.rings.emplace_back();
        for (Vec2 const& point : ring) pixels.push_back(pixel_of(camera, point));
    }
    Look const look = paint_of(patch.cover);
    double const height = patch.box.high.y() - patch.box.low.y();
    double const depth = patch.cover == Cover::earth ? std::clamp(height, earth_fade, 3 * earth_fade) : height + 0.1;
    area.paint.top = look.top;
    area.paint.bottom = look.bottom;
    area.paint.down = pixels_along(camera, -Vec2::UnitY()) / camera.scale;
    area.paint.top_y = geometry::dot(pixel_of(camera, patch.box.high), area.paint.down);
    area.paint.bottom_y = area.paint.top_y + depth * camera.scale;
    area.paint.grain = look.grain;
    area.paint.grain_origin = pixel_of(camera, Vec2::Zero());
    area.paint.grain_scale = camera.scale;
    return area;
}

void add_flower(std::vector<Shape>& shapes, Vec2 const& at, double size, int kind) {
    Colour const petals[] = {colour(0xffffff), colour(0xffd0e6), colour(0xfff07a)};
    for (int i = 0; i < 5; ++i) {
        double const angle = i * 2 * geometry::pi / 5 + kind;
        Vec2 const petal = at + 0.62 * size * Vec2(std::cos(angle), std::sin(angle));
        shapes.emplace_back(Disc{petal, 0.5 * size, petals[kind % 3], {}, 0, 0});
    }
    shapes.emplace_back(Disc{at, 0.45 * size, palette::orange, {}, 0, 0});
}

void add_tuft(std::vector<Shape>& shapes, Tuft const& tuft, Camera const& camera) {
    Vec2 const root = pixel_of(camera, tuft.root);
    Vec2 const up = pixels_along(camera, tuft.up * tuft.height);
    Vec2 const aside = geometry::turned_left(up);
    double const width = 0.022 * camera.scale;
    bool const flower = tuft.kind < 2;
    if (flower) {
        shapes.emplace_back(Stroke{root, root + 1.4 * up, 0.8 * width, palette::blade});
        add_flower(shapes, root + 1.5 * up, 0.04 * camera.scale, tuft.kind + static_cast<int>(tuft.height * 1000));
        return;
    }
    double const lean = tuft.kind % 2 == 0 ? 0.15 : -0.15;
    shapes.emplace_back(Stroke{root, root + 0.7 * up + (lean + 0.45) * aside, width, palette::blade});
    shapes.emplace_back(Stroke{root, root + 0.75 * up + (lean - 0.45) * aside, width, palette::blade});
    shapes.emplace_back(Stroke{root, root + up + lean * aside, width, palette::blade_lit});
}

Colour colour_of(Sign sign) {
    switch (sign) {
        case Sign::glint:
            return faded(palette::bright, 0.9f);
        case Sign::sheen:
            return palette::bright;
        case Sign::drop:
            return palette::mud;
        case Sign::stud:
            return palette::stud;
        case Sign::coil:
            break;
    }
    return palette::coil;
}

}  // namespace

std::vector<Shape> ground_shapes(Ground const& ground, Camera const& camera) {
    std::vector<Shape> shapes;
    for (Tuft const& tuft : ground.tufts) add_tuft(shapes, tuft, camera);
    for (Patch const& patch : ground.patches) shapes.emplace_back(area_of(patch, camera));
    for (Mark const& mark : ground.marks)
        shapes.emplace_back(Stroke{pixel_of(camera, mark.from), pixel_of(camera, mark.to), mark.width * camera.scale,
                                   colour_of(mark.sign)});
    return shapes;
}

}  // namespace view
