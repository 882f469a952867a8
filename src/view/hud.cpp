#include "view/hud.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "view/palette.h"

namespace view {

namespace {

constexpr double message_rise = 0.25;  // s: a message opens over this time

int bananas_in(level::Level const& level) {
    return static_cast<int>(std::count(level.meanings.begin(), level.meanings.end(), level::Meaning::banana));
}

void add_pill(std::vector<Shape>& shapes, Vec2 const& corner, Vec2 const& size, Colour const& paint) {
    shapes.emplace_back(Panel{corner, size, size.y() / 2, paint});
}

void add_banana_mark(std::vector<Shape>& shapes, Vec2 const& at, double size) {
    double constexpr from = 0.35, sweep = 2.0;
    Vec2 const centre = at - Vec2(0.1 * size, 0.35 * size);
    shapes.emplace_back(ArcStroke{centre, 0.62 * size, from, sweep, 0.5 * size, palette::banana_tip});
    shapes.emplace_back(ArcStroke{centre, 0.62 * size, from, sweep, 0.34 * size, palette::banana});
}

// Pieces of paper whose way through the air depends on the time since the goal alone.
void add_confetti(std::vector<Shape>& shapes, double age, Vec2 const& size) {
    Colour const colours[] = {palette::red, palette::gold, palette::green, palette::blue, palette::violet};
    double const unit = hud_scale(size);
    int constexpr pieces = 90;
    for (int i = 0; i < pieces; ++i) {
        double const across = std::fmod(i * 0.61803398875, 1.0), luck = std::fmod(i * 0.7548776662, 1.0);
        double const fall = (age - 0.9 * luck) * (170 + 130 * luck) * unit;
        if (fall < 0 || fall > size.y() + 40 * unit) continue;
        double const sway = 22 * unit * std::sin(2.5 * age + 9 * luck);
        double const turn = age * (3 + 4 * luck) + i;
        Vec2 const at(across * size.x() + sway, fall - 20 * unit);
        Vec2 const half = 6 * unit * Vec2(std::cos(turn), 0.6 * std::sin(turn));
        double const width = (2.5 + 4 * std::abs(std::sin(0.7 * turn + i))) * unit;
        shapes.emplace_back(Stroke{at - half, at + half, width, colours[i % 5]});
    }
}

void add_message(std::vector<Shape>& shapes, std::string const& headline, std::string const& line, Colour const& paint,
                 double age, Vec2 const& size) {
    double const unit = hud_scale(size);
    double const open = std::clamp(age / message_rise, 0.0, 1.0);
    double const swell = 1 + 0.25 * std::sin(3.14159265 * open) * (1 - open);
    float const presence = static_cast<float>(open);
    Vec2 const middle(size.x() / 2, 0.3 * size.y());
    double const height = 64 * unit * swell * (0.6 + 0.4 * open);
    double const width =
        std::max({text_width(headline) * height, text_width(line) * 24 * unit, 320 * unit}) + 70 * unit;
    double const tall = (line.empty() ? 110 : 142) * unit;
    Vec2 const corner = middle - Vec2(width / 2, 74 * unit);
    shapes.emplace_back(
        Panel{corner + Vec2(0, 5 * unit), {width, tall}, 22 * unit, faded(palette::ink, 0.25f * presence)});
    shapes.emplace_back(Panel{corner, {width, tall}, 22 * unit, faded(palette::paper, presence)});
    shapes.emplace_back(Label{middle, height, headline, faded(paint, presence), Anchor::Centre});
    if (line.empty()) return;
    Vec2 const below = middle + Vec2(0, 42 * unit);
    shapes.emplace_back(Label{below, 22 * unit, line, faded(palette::ink, presence), Anchor::Centre});
}

std::string joined(std::string const& a, std::string const& b) {
    return a.empty() || b.empty() ? a + b : a + "   -   " + b;
}

}  // namespace

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
    bool const ended = moment.status.goal_time.has_value();
    double clock = ended ? *moment.status.goal_time : moment.time;
    bool hurry = false;
    if (level.time_limit && !ended) {
        clock = std::max(0.0, *level.time_limit - moment.time);
        hurry = clock < 5;
    }
    double const width = 104 * unit;
    double right = size.x() - edge;
    add_pill(shapes, {right - width, edge}, {width, tall}, hurry ? faded(palette::red, 0.85f) : palette::night);
    shapes.emplace_back(Label{{right - width / 2, base}, letters, written(clock, 2), palette::bright, Anchor::Centre});
    int const bananas = bananas_in(level);
    if (bananas == 0) return shapes;
    right -= width + 10 * unit;
    double const wide = 112 * unit;
    add_pill(shapes, {right - wide, edge}, {wide, tall}, palette::night);
    add_banana_mark(shapes, {right - wide + 24 * unit, edge + 19 * unit}, 20 * unit);
    std::string const count = std::to_string(moment.status.bananas) + " / " + std::to_string(bananas);
    shapes.emplace_back(Label{{right - 18 * unit, base}, letters, count, palette::bright, Anchor::Right});
    return shapes;
}

std::vector<Shape> ending_shapes(level::Level const& level, Moment const& moment, Vec2 const& size,
                                 std::string const& hint) {
    std::vector<Shape> shapes;
    game::Status const& status = moment.status;
    if (status.goal_time) {
        double const age = moment.time - *status.goal_time;
        add_confetti(shapes, age, size);
        std::string line = written(*status.goal_time, 2) + " s";
        int const bananas = bananas_in(level);
        if (bananas > 0) line += ", " + std::to_string(status.bananas) + " of " + std::to_string(bananas) + " bananas";
        add_message(shapes, "Goal!", joined(line, hint), palette::gold_deep, age, size);
    } else if (status.fall_time) {
        add_message(shapes, "Fall out", hint, palette::red, moment.time - *status.fall_time, size);
    } else if (status.out_of_time && level.time_limit) {
        add_message(shapes, "Time over", hint, palette::red, moment.time - *level.time_limit, size);
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
    // Gravity turned counter-clockwise pulls to the right, and the bubble goes the other way.
    Vec2 const bubble = middle - Vec2(share * 92 * unit, 0);
    shapes.emplace_back(Disc{bubble, 10 * unit, colour(0xf4ffd8, 0.95f), colour(0x5d8a1e), 1.5 * unit, 0});
    return shapes;
}

std::vector<Shape> help_shapes(std::vector<KeyHelp> const& rows, Vec2 const& size) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size);
    double const line = 30 * unit, letters = 18 * unit;
    Vec2 const panel(680 * unit, line * static_cast<double>(rows.size()) + 96 * unit);
    Vec2 const corner = (size - panel) / 2;
    shapes.emplace_back(Panel{Vec2::Zero(), size, 0, colour(0x0c1620, 0.35f)});
    shapes.emplace_back(Panel{corner, panel, 22 * unit, colour(0xfffdf6, 0.96f)});
    Vec2 at = corner + Vec2(panel.x() / 2, 50 * unit);
    shapes.emplace_back(Label{at, 30 * unit, "How to play", palette::ink, Anchor::Centre});
    at = corner + Vec2(0, 88 * unit);
    for (KeyHelp const& row : rows) {
        double const wide = std::max(44.0 * unit, text_width(row.keys) * letters + 22 * unit);
        Vec2 const cap(corner.x() + 210 * unit - wide, at.y() - 19 * unit);
        shapes.emplace_back(Panel{cap + Vec2(0, 2 * unit), {wide, 26 * unit}, 7 * unit, colour(0xb9c3cb)});
        shapes.emplace_back(Panel{cap, {wide, 25 * unit}, 7 * unit, colour(0xe8eef2)});
        shapes.emplace_back(Label{{cap.x() + wide / 2, at.y()}, letters, row.keys, palette::ink, Anchor::Centre});
        shapes.emplace_back(Label{{corner.x() + 232 * unit, at.y()}, letters, row.meaning, palette::ink, Anchor::Left});
        at.y() += line;
    }
    return shapes;
}

std::vector<Shape> toast_shapes(std::string const& text, double presence, Vec2 const& size) {
    std::vector<Shape> shapes;
    if (text.empty() || presence <= 0) return shapes;
    double const unit = hud_scale(size);
    float const alpha = static_cast<float>(std::min(presence, 1.0));
    double letters = 18 * unit;
    double const room = size.x() - 80 * unit;
    if (text_width(text) * letters > room) letters = room / text_width(text);
    double const width = text_width(text) * letters + 44 * unit;
    Vec2 const corner((size.x() - width) / 2, size.y() - 100 * unit);
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
