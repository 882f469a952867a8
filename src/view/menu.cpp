#include "view/menu.h"

#include <algorithm>

#include "view/hud.h"
#include "view/palette.h"

namespace view {

namespace {

// Pixels of a picture of 1280x720.
constexpr double menu_margin = 34, title_height = 84, column_gap = 20, bar_right = 28, row_inset = 24;
constexpr Colour card_paint = colour(0xfffdf6, 0.97f), row_paint = colour(0xe8eef2);

struct MenuPlan {
    MenuForm form;
    std::size_t per_column;
    double unit;
    Vec2 corner, panel;  // pixels

    double row_width() const {
        double const gaps = column_gap * static_cast<double>(form.columns - 1);
        return (form.width - 2 * menu_margin - gaps) / static_cast<double>(form.columns);
    }
    Vec2 row_corner(std::size_t row) const {
        double const column = static_cast<double>(row / per_column), down = static_cast<double>(row % per_column);
        return corner + unit * Vec2(menu_margin + column * (row_width() + column_gap),
                                    title_height + down * (form.row_height + form.row_gap));
    }
    Vec2 row_size() const { return unit * Vec2(row_width(), form.row_height); }
};

std::size_t rows_per_column(MenuForm const& form, std::size_t rows) {
    return std::max<std::size_t>((rows + form.columns - 1) / form.columns, 1);
}

MenuPlan plan_for(MenuForm const& form, std::size_t rows, Vec2 const& size) {
    MenuPlan plan{form, rows_per_column(form, rows), hud_scale(size), {}, {}};
    double const down = static_cast<double>(plan.per_column) * (form.row_height + form.row_gap) - form.row_gap;
    plan.panel = plan.unit * Vec2(form.width, title_height + down + form.below);
    plan.corner = (size - plan.panel) / 2;
    return plan;
}

// Letters as high as they may be, or lower so that they fit.
double fitting(std::string const& text, double letters, double room) {
    return std::min(letters, std::max(room, 0.0) / std::max(text_width(text), 1e-9));
}

void add_bar(std::vector<Shape>& shapes, Vec2 const& corner, Vec2 const& size, double level, Colour const& paint) {
    shapes.emplace_back(Panel{corner, size, size.y() / 2, faded(paint, 0.28f)});
    double const filled = std::max(size.y(), size.x() * std::clamp(level, 0.0, 1.0));
    if (level > 0) shapes.emplace_back(Panel{corner, {filled, size.y()}, size.y() / 2, paint});
}

// On is to the right and filled, off to the left and empty.
void add_switch(std::vector<Shape>& shapes, Vec2 const& right_middle, double high, bool on) {
    Vec2 const extent(1.8 * high, high);
    Vec2 const corner = right_middle - Vec2(extent.x(), extent.y() / 2);
    shapes.emplace_back(Panel{corner, extent, high / 2, on ? palette::ink : colour(0x9aa7b1)});
    double const knob = on ? extent.x() - high / 2 : high / 2;
    shapes.emplace_back(
        Disc{corner + Vec2(knob, high / 2), 0.38 * high, palette::bright, palette::ink, on ? 0 : 0.08 * high, 0});
}

// What stands at the right of a row; where it begins, pixels from the left.
double add_value(std::vector<Shape>& shapes, MenuRow const& row, MenuForm const& form, Vec2 const& corner,
                 Vec2 const& extent, double unit) {
    double const middle = corner.y() + extent.y() / 2, base = middle + 0.35 * form.letters * unit;
    double right = corner.x() + extent.x() - bar_right * unit;
    if (row.level) {
        double const left = right - form.bar * unit;
        add_bar(shapes, {left, middle - 6 * unit}, unit * Vec2(form.bar, 12), *row.level, palette::ink);
        return left;
    }
    if (row.on) {
        double const high = 0.48 * extent.y();
        add_switch(shapes, {right, middle}, high, *row.on);
        right -= 1.8 * high + 12 * unit;
    }
    if (!row.caps.empty()) {
        double const end = corner.x() + extent.x() - 8 * unit;
        return add_key_caps(shapes, row.caps, end, middle, 0.45 * extent.x(), form.letters * unit);
    }
    if (row.value.empty()) return right;
    double const letters = fitting(row.value, form.letters * unit, 0.45 * extent.x());
    shapes.emplace_back(Label{{right, base}, letters, row.value, palette::ink, Anchor::Right});
    return right - text_width(row.value) * letters;
}

void add_row(std::vector<Shape>& shapes, MenuRow const& row, MenuPlan const& plan, Vec2 const& corner, bool is_chosen) {
    double const unit = plan.unit, rounding = std::min(14.0, 0.3 * plan.form.row_height) * unit;
    Vec2 const extent = plan.row_size();
    if (is_chosen) shapes.emplace_back(Panel{corner + Vec2(0, 3 * unit), extent, rounding, palette::gold_deep});
    shapes.emplace_back(Panel{corner, extent, rounding, is_chosen ? palette::gold : row_paint});
    if (is_chosen) {
        // The chosen one is told by more than its colour.
        Vec2 const tip = corner + Vec2(16 * unit, extent.y() / 2);
        Area mark;
        mark.rings = {{tip, tip + Vec2(-8, -6) * unit, tip + Vec2(-8, 6) * unit}};
        mark.paint.top = mark.paint.bottom = palette::ink;
        shapes.emplace_back(std::move(mark));
    }
    double const right = add_value(shapes, row, plan.form, corner, extent, unit);
    Vec2 const base = corner + Vec2(row_inset * unit, extent.y() / 2 + 0.35 * plan.form.letters * unit);
    double const letters = fitting(row.text, plan.form.letters * unit, right - base.x() - 10 * unit);
    shapes.emplace_back(Label{base, letters, row.text, palette::ink, Anchor::Left});
}

struct ButtonFrame {
    Vec2 corner, extent;  // pixels
};
ButtonFrame corner_button(std::string const& text, Vec2 const& size) {
    double const unit = hud_scale(size), width = text_width(text) * 18 * unit + 36 * unit;
    return {{size.x() - 16 * unit - width, 16 * unit}, {width, 36 * unit}};
}

}  // namespace

double add_key_caps(std::vector<Shape>& shapes, std::vector<std::string> const& keys, double right, double middle,
                    double room, double letters) {
    auto const width_of = [&](std::string const& key) { return std::max(1.4, text_width(key) + 1.1) * letters; };
    double const gap = 0.3 * letters;
    double whole = -gap;
    for (std::string const& key : keys) whole += width_of(key) + gap;
    double const shrink = std::min(1.0, room / std::max(whole, 1e-9)), high = 1.4 * letters;
    double const begin = right - whole * shrink;
    double left = begin;
    for (std::string const& key : keys) {
        double const wide = width_of(key) * shrink;
        Vec2 const corner(left, middle - high / 2);
        shapes.emplace_back(Panel{corner + Vec2(0, 0.09 * letters), {wide, high}, 0.35 * letters, colour(0x9eabb5)});
        shapes.emplace_back(Panel{corner, {wide, high - 0.05 * letters}, 0.35 * letters, colour(0xf6f9fb)});
        shapes.emplace_back(Label{{left + wide / 2, middle + 0.34 * letters},
                                  fitting(key, letters, wide - 0.3 * letters),
                                  key,
                                  palette::ink,
                                  Anchor::Centre});
        left += wide + gap * shrink;
    }
    return begin;
}

std::vector<Shape> menu_shapes(Menu const& menu, std::size_t chosen, Vec2 const& size) {
    std::vector<Shape> shapes;
    MenuPlan const plan = plan_for(menu.form, menu.rows.size(), size);
    double const unit = plan.unit, room = plan.panel.x() - 2 * menu_margin * unit;
    shapes.emplace_back(Panel{Vec2::Zero(), size, 0, colour(0x0c1620, 0.45f)});
    shapes.emplace_back(Panel{plan.corner + Vec2(0, 6 * unit), plan.panel, 24 * unit, colour(0x0c1620, 0.35f)});
    shapes.emplace_back(Panel{plan.corner, plan.panel, 24 * unit, card_paint});
    double const middle = plan.corner.x() + plan.panel.x() / 2;
    shapes.emplace_back(Label{{middle, plan.corner.y() + 54 * unit},
                              fitting(menu.title, 30 * unit, room),
                              menu.title,
                              palette::ink,
                              Anchor::Centre,
                              Weight::bold});
    for (std::size_t row = 0; row < menu.rows.size(); ++row)
        add_row(shapes, menu.rows[row], plan, plan.row_corner(row), row == chosen);
    if (!menu.hint.empty())
        shapes.emplace_back(Label{{middle, plan.corner.y() + plan.panel.y() - 24 * unit},
                                  fitting(menu.hint, 17 * unit, room),
                                  menu.hint,
                                  colour(0x4d5b68),
                                  Anchor::Centre});
    return shapes;
}

std::optional<MenuPlace> menu_place_at(MenuForm const& form, std::size_t rows, Vec2 const& pixel, Vec2 const& size) {
    MenuPlan const plan = plan_for(form, rows, size);
    for (std::size_t row = 0; row < rows; ++row) {
        Vec2 const corner = plan.row_corner(row), extent = plan.row_size(), inside = pixel - corner;
        if (inside.x() < 0 || inside.y() < 0 || inside.x() >= extent.x() || inside.y() >= extent.y()) continue;
        double const along = inside.x() - extent.x() + (bar_right + form.bar) * plan.unit;
        return MenuPlace{row, form.bar > 0 ? std::clamp(along / (form.bar * plan.unit), 0.0, 1.0) : 0};
    }
    return std::nullopt;
}

std::size_t menu_row_from(MenuForm const& form, std::size_t rows, std::size_t chosen, int columns, int down) {
    if (rows == 0) return 0;
    std::size_t const per_column = rows_per_column(form, rows), column = chosen / per_column;
    std::size_t const first = column * per_column, here = std::min(per_column, rows - first);
    if (down > 0) return first + (chosen - first + 1) % here;
    if (down < 0) return first + (chosen - first + here - 1) % here;
    bool const is_last = first + per_column >= rows;
    if (columns < 0 && column > 0) return chosen - per_column;
    if (columns > 0 && !is_last) return std::min(chosen + per_column, rows - 1);
    return chosen;
}

std::vector<Shape> corner_button_shapes(std::string const& text, Vec2 const& size) {
    double const unit = hud_scale(size);
    auto const [corner, extent] = corner_button(text, size);
    return {Panel{corner + Vec2(0, 3 * unit), extent, extent.y() / 2, palette::gold_deep},
            Panel{corner, extent, extent.y() / 2, palette::gold},
            Label{corner + Vec2(extent.x() / 2, 24 * unit), 18 * unit, text, palette::ink, Anchor::Centre}};
}

bool is_on_corner_button(std::string const& text, Vec2 const& pixel, Vec2 const& size) {
    auto const [corner, extent] = corner_button(text, size);
    Vec2 const inside = pixel - corner;
    return inside.x() >= 0 && inside.y() >= 0 && inside.x() < extent.x() && inside.y() < extent.y();
}

}  // namespace view
