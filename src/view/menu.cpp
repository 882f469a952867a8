#include "view/menu.h"

#include <algorithm>

#include "view/hud.h"
#include "view/palette.h"

namespace view {

namespace {

// Pixels of a picture of 1280x720.
constexpr double menu_width = 420, row_height = 58, row_gap = 10, menu_margin = 34, title_height = 84;
constexpr double bar_left = 196, bar_width = 190;

struct MenuPlan {
    double unit;
    Vec2 corner, panel;  // pixels

    Vec2 row_corner(std::size_t row) const {
        return corner + unit * Vec2(menu_margin, title_height + static_cast<double>(row) * (row_height + row_gap));
    }
    Vec2 row_size() const { return unit * Vec2(menu_width - 2 * menu_margin, row_height); }
};

MenuPlan plan_for(std::size_t rows, Vec2 const& size) {
    MenuPlan plan;
    plan.unit = hud_scale(size);
    double const tall = title_height + static_cast<double>(rows) * (row_height + row_gap) - row_gap + menu_margin;
    plan.panel = plan.unit * Vec2(menu_width, tall);
    plan.corner = (size - plan.panel) / 2;
    return plan;
}

void add_bar(std::vector<Shape>& shapes, Vec2 const& corner, Vec2 const& size, double level, Colour const& paint) {
    shapes.emplace_back(Panel{corner, size, size.y() / 2, faded(paint, 0.28f)});
    double const filled = std::max(size.y(), size.x() * std::clamp(level, 0.0, 1.0));
    if (level > 0) shapes.emplace_back(Panel{corner, {filled, size.y()}, size.y() / 2, paint});
}

}  // namespace

std::vector<Shape> menu_shapes(std::string const& title, std::vector<MenuRow> const& rows, std::size_t chosen,
                               Vec2 const& size) {
    std::vector<Shape> shapes;
    MenuPlan const plan = plan_for(rows.size(), size);
    double const unit = plan.unit;
    shapes.emplace_back(Panel{Vec2::Zero(), size, 0, colour(0x0c1620, 0.45f)});
    shapes.emplace_back(Panel{plan.corner + Vec2(0, 6 * unit), plan.panel, 24 * unit, colour(0x0c1620, 0.35f)});
    shapes.emplace_back(Panel{plan.corner, plan.panel, 24 * unit, colour(0xfffdf6, 0.97f)});
    double letters = 30 * unit;
    double const room = plan.panel.x() - 2 * menu_margin * unit;
    if (text_width(title) * letters > room) letters = room / text_width(title);
    shapes.emplace_back(
        Label{plan.corner + Vec2(plan.panel.x() / 2, 54 * unit), letters, title, palette::ink, Anchor::Centre});
    for (std::size_t row = 0; row < rows.size(); ++row) {
        Vec2 const corner = plan.row_corner(row), extent = plan.row_size();
        bool const is_chosen = row == chosen;
        if (is_chosen) shapes.emplace_back(Panel{corner + Vec2(0, 3 * unit), extent, 14 * unit, palette::gold_deep});
        shapes.emplace_back(Panel{corner, extent, 14 * unit, is_chosen ? palette::gold : colour(0xe8eef2)});
        Vec2 const base = corner + unit * Vec2(24, row_height / 2 + 8);
        shapes.emplace_back(Label{base, 23 * unit, rows[row].text, palette::ink, Anchor::Left});
        if (rows[row].level)
            add_bar(shapes, {plan.corner.x() + bar_left * unit, corner.y() + (row_height / 2 - 6) * unit},
                    unit * Vec2(bar_width - menu_margin, 12), *rows[row].level, palette::ink);
    }
    return shapes;
}

std::optional<MenuPlace> menu_place_at(std::size_t rows, Vec2 const& pixel, Vec2 const& size) {
    MenuPlan const plan = plan_for(rows, size);
    for (std::size_t row = 0; row < rows; ++row) {
        Vec2 const inside = pixel - plan.row_corner(row), extent = plan.row_size();
        if (inside.x() < 0 || inside.y() < 0 || inside.x() >= extent.x() || inside.y() >= extent.y()) continue;
        double const along = (pixel.x() - plan.corner.x()) / plan.unit - bar_left;
        return MenuPlace{row, std::clamp(along / (bar_width - menu_margin), 0.0, 1.0)};
    }
    return std::nullopt;
}

}  // namespace view
