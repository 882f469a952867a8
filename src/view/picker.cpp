#include "view/picker.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "view/bodies.h"
#include "view/outline_points.h"
#include "view/camera.h"
#include "view/contrast.h"
#include "view/ending.h"
#include "view/hud.h"
#include "view/palette.h"

namespace view {

namespace {

// Ratio of the picture's ground with the middle of the sky (WCAG 2.1).
constexpr double least_contrast = 2;

constexpr double tile_width = 280, tile_height = 158;  // pixels of a picture of 1280x720
constexpr double step_x = 304, step_y = 200;           // the same, from tile to tile
constexpr double top = 92;

std::size_t rows_of(std::size_t tiles) { return (tiles + picker_columns - 1) / picker_columns; }

// The row that is seen first.
std::size_t first_row(std::size_t tiles, std::size_t chosen) {
    std::size_t const rows = rows_of(tiles), row = chosen / picker_columns;
    std::size_t const most = rows > picker_rows ? rows - picker_rows : 0;
    return std::min(row > 1 ? row - 1 : 0, most);
}

struct Frame {
    Vec2 corner, size;  // pixels
};

std::optional<Frame> frame_of(std::size_t tile, std::size_t tiles, std::size_t chosen, Vec2 const& size) {
    std::size_t const row = tile / picker_columns, first = first_row(tiles, chosen);
    if (row < first || row >= first + picker_rows) return std::nullopt;
    double const unit = hud_scale(size);
    double const left = size.x() / 2 - (picker_columns * step_x - (step_x - tile_width)) / 2 * unit;
    double const upper = size.y() / 2 - 360 * unit + top * unit;
    return Frame{{left + static_cast<double>(tile % picker_columns) * step_x * unit,
                  upper + static_cast<double>(row - first) * step_y * unit},
                 Vec2(tile_width, tile_height) * unit};
}

// The bar at the right, between its arrows.
struct ScrollBar {
    double x, from, to;         // pixels
    double seen_from, seen_to;  // pixels: the part that stands for what is seen
    double half, unit;          // pixels: half of its width, as wide as can be pressed
    Vec2 upper() const { return {x, from - 22 * unit}; }
    Vec2 lower() const { return {x, to + 22 * unit}; }
};
std::optional<ScrollBar> scroll_bar(std::size_t tiles, std::size_t chosen, Vec2 const& size) {
    UnseenRows const unseen = unseen_rows(tiles, chosen);
    if (unseen == UnseenRows{}) return std::nullopt;
    double const unit = hud_scale(size), middle = size.y() / 2 - 360 * unit;
    ScrollBar bar{size.x() / 2 + 617 * unit, middle + (top + 36) * unit, middle + 614 * unit, 0, 0, 16 * unit, unit};
    double const row = (bar.to - bar.from) / static_cast<double>(rows_of(tiles));
    bar.seen_from = bar.from + row * static_cast<double>(unseen.above);
    bar.seen_to = bar.to - row * static_cast<double>(unseen.below);
    return bar;
}

void add_scroll_bar(std::vector<Shape>& shapes, ScrollBar const& bar, UnseenRows const& unseen) {
    double const unit = bar.unit;
    shapes.emplace_back(
        Panel{{bar.x - 4 * unit, bar.from}, {8 * unit, bar.to - bar.from}, 4 * unit, faded(palette::bright, 0.16f)});
    shapes.emplace_back(
        Panel{{bar.x - 4 * unit, bar.seen_from}, {8 * unit, bar.seen_to - bar.seen_from}, 4 * unit, palette::dim});
    auto const arrow = [&](Vec2 const& at, double way, std::size_t rows) {
        Area mark;
        mark.rings = {{at + Vec2(0, way * 9) * unit, at + Vec2(-11, -way * 7) * unit, at + Vec2(11, -way * 7) * unit}};
        mark.paint.top = mark.paint.bottom = rows > 0 ? palette::gold : faded(palette::bright, 0.22f);
        shapes.emplace_back(std::move(mark));
    };
    arrow(bar.upper(), -1, unseen.above);
    arrow(bar.lower(), 1, unseen.below);
}

Colour colour_or(std::string const& text, Colour const& other) {
    return text.size() == 7 ? colour(static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16))) : other;
}

void add_thumbnail(std::vector<Shape>& shapes, Thumbnail const& thumbnail, Frame const& frame) {
    Area sky;
    Vec2 const low = frame.corner, high = frame.corner + frame.size;
    sky.rings = {{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
    sky.paint.top = thumbnail.sky_top;
    sky.paint.bottom = thumbnail.sky_bottom;
    sky.paint.top_y = low.y();
    sky.paint.bottom_y = high.y();
    shapes.emplace_back(std::move(sky));
    Vec2 const room = frame.size.cwiseQuotient(thumbnail.extent);
    double const scale = std::min(room.x(), room.y());  // pixels per metre
    Vec2 const middle = (low + high) / 2;
    auto const placed = [&](Vec2 const& point) -> Vec2 {
        Vec2 const off = (point - thumbnail.extent / 2) * scale;
        return middle + Vec2(off.x(), -off.y());
    };
    Colour const ground = ground_colour(thumbnail);
    for (std::vector<Ring> const& body : thumbnail.ground) {
        Area area;
        for (Ring const& ring : body) {
            std::vector<Vec2>& points = area.rings.emplace_back();
            for (Vec2 const& point : ring) points.push_back(placed(point));
        }
        area.paint.top = area.paint.bottom = ground;
        shapes.emplace_back(std::move(area));
    }
    double const dot = std::max(thumbnail.radius * scale, 2.5);
    for (Vec2 const& banana : thumbnail.bananas)
        shapes.emplace_back(Disc{placed(banana), 0.5 * dot, palette::banana, {}, 0, 0});
    if (thumbnail.goal) {
        Vec2 const at = placed(*thumbnail.goal);
        shapes.emplace_back(Stroke{at + Vec2(0, dot), at - Vec2(0, 1.6 * dot), 0.4 * dot, palette::bright});
        Area flag;
        flag.rings = {{at - Vec2(0, 1.8 * dot), at + Vec2(1.8 * dot, -1.1 * dot), at - Vec2(0, 0.4 * dot)}};
        flag.paint.top = flag.paint.bottom = palette::red;
        shapes.emplace_back(std::move(flag));
    }
    shapes.emplace_back(Disc{placed(thumbnail.ball), dot, palette::strain, palette::bright, 0.25 * dot, 0});
}

void add_tile(std::vector<Shape>& shapes, Tile const& tile, std::size_t number, bool is_chosen, Frame const& frame,
              double unit, game::Language language) {
    Vec2 const edge = Vec2(5, 5) * unit;
    if (is_chosen) shapes.emplace_back(Panel{frame.corner - edge, frame.size + 2 * edge, 8 * unit, palette::gold});
    if (tile.thumbnail) {
        add_thumbnail(shapes, *tile.thumbnail, frame);
    } else {
        shapes.emplace_back(Panel{frame.corner, frame.size, 4 * unit, colour(0x3a4653)});
        Vec2 const middle = frame.corner + frame.size / 2 + Vec2(0, 6 * unit);
        shapes.emplace_back(Label{middle, 20 * unit, game::words(game::Text::picker_broken, language), palette::strain,
                                  Anchor::Centre});
    }
    if (tile.medal != game::Medal::none)
        for (Shape& shape :
             medal_shapes(frame.corner + Vec2(frame.size.x() - 24 * unit, 24 * unit), 15 * unit, tile.medal))
            shapes.emplace_back(std::move(shape));
    std::string const name = std::to_string(number + 1) + "  " + tile.title;
    double const letters = std::min(18 * unit, 0.74 * frame.size.x() / text_width(name));
    double const base = frame.corner.y() + frame.size.y() + 24 * unit;
    Colour const paint = is_chosen ? palette::gold : palette::bright;
    shapes.emplace_back(Label{{frame.corner.x(), base}, letters, name, paint, Anchor::Left});
    if (tile.best)
        shapes.emplace_back(Label{{frame.corner.x() + frame.size.x(), base},
                                  18 * unit,
                                  written(*tile.best, 2) + " s",
                                  palette::dim,
                                  Anchor::Right});
}

}  // namespace

Ring ring_within(Ring const& ring, geometry::Box const& box) {
    Ring inside = ring;
    auto const cut = [&](std::function<double(Vec2 const&)> const& depth) {
        Ring before;
        before.swap(inside);
        for (std::size_t i = 0; i < before.size(); ++i) {
            Vec2 const& from = before[i];
            Vec2 const& to = before[(i + 1) % before.size()];
            double const a = depth(from), b = depth(to);
            if (a >= 0) inside.push_back(from);
            if ((a >= 0) != (b >= 0)) inside.push_back(from + (to - from) * (a / (a - b)));
        }
    };
    cut([&](Vec2 const& p) { return p.x() - box.low.x(); });
    cut([&](Vec2 const& p) { return box.high.x() - p.x(); });
    cut([&](Vec2 const& p) { return p.y() - box.low.y(); });
    cut([&](Vec2 const& p) { return box.high.y() - p.y(); });
    return inside;
}

Colour ground_colour(Thumbnail const& thumbnail) {
    Colour const sky = mixed(thumbnail.sky_top, thumbnail.sky_bottom, 0.5f);
    Colour const dark = mixed(palette::ink, thumbnail.sky_top, 0.22f);
    Colour const light = mixed(palette::bright, thumbnail.sky_bottom, 0.55f);
    return contrast_ratio(dark, sky) >= least_contrast ? dark : light;
}

Thumbnail thumbnail_of(level::Level const& level) {
    Thumbnail thumbnail;
    thumbnail.extent = level.size.cwiseMax(Vec2::Constant(1e-6));
    std::vector<std::string> const& sky = level.look.sky;
    thumbnail.sky_top = colour_or(sky.empty() ? "" : sky[0], palette::sky_top);
    thumbnail.sky_bottom = colour_or(sky.empty() ? "" : sky[1], palette::sky_bottom);
    geometry::Box const frame{Vec2::Zero(), level.size};
    auto const add = [&](std::vector<Ring> const& body) {
        std::vector<Ring> rings;
        for (Ring const& ring : body)
            if (Ring part = ring_within(ring, frame); part.size() > 2) rings.push_back(std::move(part));
        if (!rings.empty()) thumbnail.ground.push_back(std::move(rings));
    };
    for (Body const& body : bodies_of(level)) add(body.rings);
    double const fine = level.size.maxCoeff() / 200;
    for (level::Outline const& outline : level.outlines)
        if (outline.painted && outline.closed) add({points_along(outline, fine, fine / 4)});
    for (std::size_t i = 0; i < level.meanings.size(); ++i) {
        Vec2 const place = middle_of(level.scene.sensors[i].region);
        if (level.meanings[i] == level::Meaning::banana) thumbnail.bananas.push_back(place);
        if (level.meanings[i] == level::Meaning::goal && !thumbnail.goal) thumbnail.goal = place;
    }
    physics::Ball const& player = level.scene.balls[static_cast<std::size_t>(level.player)];
    thumbnail.ball = player.start.position;
    thumbnail.radius = player.radius;
    return thumbnail;
}

Picture picker_picture(std::vector<Tile> const& tiles, std::size_t chosen, Vec2 const& size, game::Language language) {
    Picture picture;
    picture.width = static_cast<int>(std::lround(size.x()));
    picture.height = static_cast<int>(std::lround(size.y()));
    std::vector<Shape>& shapes = picture.shapes;
    double const unit = hud_scale(size);
    shapes.emplace_back(Sky{colour(0x24405c), colour(0x101c2a)});
    Vec2 const heading(size.x() / 2, size.y() / 2 - 306 * unit);
    shapes.emplace_back(Label{heading, 40 * unit, game::words(game::Text::picker_title, language), palette::bright,
                              Anchor::Centre, Weight::bold});
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (auto const frame = frame_of(i, tiles.size(), chosen, size))
            add_tile(shapes, tiles[i], i, i == chosen, *frame, unit, language);
    if (auto const bar = scroll_bar(tiles.size(), chosen, size))
        add_scroll_bar(shapes, *bar, unseen_rows(tiles.size(), chosen));
    shapes.emplace_back(Label{{size.x() / 2, size.y() / 2 + 350 * unit},
                              16 * unit,
                              game::words(game::Text::picker_hint, language),
                              palette::dim,
                              Anchor::Centre});
    return picture;
}

UnseenRows unseen_rows(std::size_t tiles, std::size_t chosen) {
    std::size_t const rows = rows_of(tiles), above = first_row(tiles, chosen);
    return {above, rows > above + picker_rows ? rows - above - picker_rows : 0};
}

int scroll_at(std::size_t tiles, std::size_t chosen, Vec2 const& pixel, Vec2 const& size) {
    auto const bar = scroll_bar(tiles, chosen, size);
    if (!bar || std::abs(pixel.x() - bar->x) > bar->half) return 0;
    UnseenRows const unseen = unseen_rows(tiles, chosen);
    bool const is_upper = pixel.y() >= bar->upper().y() - bar->half && pixel.y() < bar->seen_from;
    bool const is_lower = pixel.y() <= bar->lower().y() + bar->half && pixel.y() >= bar->seen_to;
    if (is_upper && unseen.above > 0) return -1;
    return is_lower && unseen.below > 0 ? 1 : 0;
}

std::optional<std::size_t> tile_at(std::size_t tiles, std::size_t chosen, Vec2 const& pixel, Vec2 const& size) {
    for (std::size_t i = 0; i < tiles; ++i) {
        auto const frame = frame_of(i, tiles, chosen, size);
        if (!frame) continue;
        Vec2 const off = pixel - frame->corner;
        if (off.x() >= 0 && off.y() >= 0 && off.x() < frame->size.x() && off.y() < frame->size.y()) return i;
    }
    return std::nullopt;
}

}  // namespace view
