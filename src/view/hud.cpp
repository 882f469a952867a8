#include "view/hud.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "game/medals.h"
#include "view/menu.h"
#include "view/palette.h"

namespace view {

namespace {

constexpr double toast_height = 100;  // of its upper edge over the lower edge, pixels of a picture of 1280x720

void add_pill(std::vector<Shape>& shapes, Vec2 const& corner, Vec2 const& size, Colour const& paint) {
    shapes.emplace_back(Panel{corner, size, size.y() / 2, paint});
}

}  // namespace

void add_banana_mark(std::vector<Shape>& shapes, Vec2 const& at, double size) {
    double constexpr from = 0.35, sweep = 2.0;
    Vec2 const centre = at - Vec2(0.1 * size, 0.35 * size);
    shapes.emplace_back(ArcStroke{centre, 0.62 * size, from, sweep, 0.5 * size, palette::banana_tip});
    shapes.emplace_back(ArcStroke{centre, 0.62 * size, from, sweep, 0.34 * size, palette::banana});
}

void add_spring_mark(std::vector<Shape>& shapes, Vec2 const& at, double size) {
    auto const point = [&](int i) -> Vec2 {
        return at + size * Vec2(-0.5 + i / 6.0, i == 0 || i == 6 ? 0.0 : i % 2 == 0 ? 0.35 : -0.35);
    };
    for (int i = 0; i < 6; ++i) shapes.emplace_back(Stroke{point(i), point(i + 1), 0.13 * size, palette::steel});
    shapes.emplace_back(Disc{point(6), 0.16 * size, palette::strain, {}, 0, 0});
}

double hud_scale(Vec2 const& size) { return std::min(size.x() / 1280, size.y() / 720); }

std::string written(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    bool const nothing = std::string(text).find_first_of("123456789") == std::string::npos;
    return nothing && text[0] == '-' ? text + 1 : text;
}

double text_width(std::string const& text) {
    auto const is_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    return 0.53 * static_cast<double>(std::count_if(text.begin(), text.end(), is_letter));
}

std::vector<Shape> heading_shapes(level::Level const& level, Moment const& moment, Vec2 const& size) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size);
    double const edge = 16 * unit, tall = 36 * unit, base = edge + 25 * unit, letters = 20 * unit;
    if (!level.title.empty()) {
        double const width = text_width(level.title) * letters + 36 * unit;
        add_pill(shapes, {edge, edge}, {width, tall}, palette::night);
        Vec2 const at(edge + width / 2, base);
        shapes.emplace_back(Label{at, letters, level.title, palette::bright, Anchor::Centre});
    }
    game::Status const& status = moment.status;
    bool const ended = status.goal_time || status.fall_time;
    double clock = status.goal_time ? *status.goal_time : status.fall_time.value_or(moment.time);
    bool hurry = false;
    if (level.time_limit && !ended) {
        clock = std::max(0.0, *level.time_limit - moment.time);
        hurry = clock < 5;
    }
    double const width = 104 * unit;
    double right = size.x() - edge;
    add_pill(shapes, {right - width, edge}, {width, tall}, hurry ? faded(palette::red, 0.85f) : palette::night);
    shapes.emplace_back(Label{{right - width / 2, base}, letters, written(clock, 2), palette::bright, Anchor::Centre});
    right -= width + 10 * unit;
    double const wide = 112 * unit;
    // A mark and how much there is of what it stands for; returns the mark's middle.
    auto const add_count = [&](std::string const& count, Colour const& paint) -> Vec2 {
        add_pill(shapes, {right - wide, edge}, {wide, tall}, palette::night);
        shapes.emplace_back(Label{{right - 18 * unit, base}, letters, count, paint, Anchor::Right});
        Vec2 const mark(right - wide + 24 * unit, edge + 19 * unit);
        right -= wide + 10 * unit;
        return mark;
    };
    if (int const bananas = game::bananas_in(level); bananas > 0) {
        std::string const count = std::to_string(status.bananas) + " / " + std::to_string(bananas);
        add_banana_mark(shapes, add_count(count, palette::bright), 20 * unit);
    }
    if (level.pars.pulls && level.drag_reach > 0) {
        bool const too_many = status.pulls > *level.pars.pulls;
        std::string const count = std::to_string(status.pulls) + " / " + std::to_string(*level.pars.pulls);
        add_spring_mark(shapes, add_count(count, too_many ? palette::strain : palette::bright), 20 * unit);
    }
    return shapes;
}

std::vector<Shape> tilt_shapes(level::Level const& level, double tilt, Vec2 const& size) {
    std::vector<Shape> shapes;
    if (tilt == 0 || level.tilt_limit <= 0) return shapes;
    double const unit = hud_scale(size);
    Vec2 const middle(size.x() / 2, size.y() - 34 * unit);
    Vec2 const tube(220 * unit, 26 * unit);
    double const share = std::clamp(tilt / level.tilt_limit, -1.0, 1.0);
    add_pill(shapes, middle - tube / 2 - Vec2(4, 4) * unit, tube + Vec2(8, 8) * unit, palette::night);
    add_pill(shapes, middle - tube / 2, tube, colour(0xb9e35a, 0.9f));
    for (double const mark : {-16.0, 16.0}) {
        Vec2 const at = middle + Vec2(mark, 0) * unit;
        shapes.emplace_back(Stroke{at - Vec2(0, 11) * unit, at + Vec2(0, 11) * unit, 2 * unit, palette::ink});
    }
    // Gravity turned counter-clockwise pulls to the right, and the bubble rises to the left.
    Vec2 const bubble = middle - Vec2(share * 92 * unit, 0);
    shapes.emplace_back(Disc{bubble, 10 * unit, colour(0xf4ffd8, 0.95f), colour(0x5d8a1e), 1.5 * unit, 0});
    return shapes;
}

std::vector<Shape> help_shapes(std::string const& title, std::vector<KeyHelp> const& rows, Vec2 const& size) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size);
    double const line = 34 * unit, letters = 17 * unit, keys_room = 190 * unit, column = 570 * unit;
    std::size_t const per_column = (rows.size() + 1) / 2;
    Vec2 const panel(1200 * unit, line * static_cast<double>(per_column) + 98 * unit);
    Vec2 const corner = (size - panel) / 2;
    shapes.emplace_back(Panel{Vec2::Zero(), size, 0, colour(0x0c1620, 0.35f)});
    shapes.emplace_back(Panel{corner, panel, 24 * unit, colour(0xfffdf6, 0.96f)});
    Vec2 const heading = corner + Vec2(panel.x() / 2, 50 * unit);
    shapes.emplace_back(Label{heading, 30 * unit, title, palette::ink, Anchor::Centre, Weight::bold});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        KeyHelp const& row = rows[i];
        double const left = corner.x() + 30 * unit + static_cast<double>(i / per_column) * column;
        double const middle = corner.y() + 90 * unit + static_cast<double>(i % per_column) * line;
        add_key_caps(shapes, row.keys, left + keys_room, middle, keys_room, letters);
        double const room = column - keys_room - 24 * unit;
        double const height = std::min(letters, room / std::max(text_width(row.meaning), 1e-9));
        Vec2 const at(left + keys_room + 14 * unit, middle + 0.34 * letters);
        shapes.emplace_back(Label{at, height, row.meaning, palette::ink, Anchor::Left});
    }
    return shapes;
}

double lift_over_help(Vec2 const& size) { return size.y() - (toast_height + 14) * hud_scale(size); }

std::vector<Shape> toast_shapes(std::string const& text, double presence, Vec2 const& size, double lift) {
    std::vector<Shape> shapes;
    if (text.empty() || presence <= 0) return shapes;
    double const unit = hud_scale(size);
    float const alpha = static_cast<float>(std::min(presence, 1.0));
    double letters = 18 * unit;
    double const room = size.x() - 80 * unit;
    if (text_width(text) * letters > room) letters = room / text_width(text);
    double const width = text_width(text) * letters + 44 * unit;
    Vec2 const corner((size.x() - width) / 2, size.y() - toast_height * unit - lift);
    add_pill(shapes, corner, {width, 38 * unit}, faded(palette::night, alpha));
    Vec2 const at(size.x() / 2, corner.y() + 25 * unit);
    shapes.emplace_back(Label{at, letters, text, faded(palette::bright, alpha), Anchor::Centre});
    return shapes;
}

std::vector<Shape> badge_shapes(std::string const& text, Vec2 const& size) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size);
    double const letters = 20 * unit, width = text_width(text) * letters + 40 * unit;
    add_pill(shapes, {(size.x() - width) / 2, 16 * unit}, {width, 36 * unit}, palette::night);
    shapes.emplace_back(Label{{size.x() / 2, 41 * unit}, letters, text, palette::gold, Anchor::Centre});
    return shapes;
}

}  // namespace view
