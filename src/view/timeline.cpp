#include "view/timeline.h"

#include <algorithm>

#include "view/hud.h"
#include "view/palette.h"

namespace view {

namespace {

constexpr double margin = 16, thickness = 16, grip = 36;  // pixels of a picture of 1280x720

// Each kind has a shape of its own, rimmed.
void add_mark(std::vector<Shape>& shapes, Timeline::Mark const& mark, Vec2 const& at, double unit) {
    if (mark.sign == Timeline::Sign::dot) {
        shapes.emplace_back(Disc{at, 4.5 * unit, mark.colour, palette::ink, 1 * unit, 0});
        return;
    }
    auto const stroke = [&](Vec2 const& from, Vec2 const& to) {
        for (double const rim : {2.0, 0.0})
            shapes.emplace_back(
                Stroke{at + unit * from, at + unit * to, (3 + rim) * unit, rim > 0 ? palette::ink : mark.colour});
    };
    if (mark.sign == Timeline::Sign::cross) {
        stroke({-4, -4}, {4, 4});
        stroke({-4, 4}, {4, -4});
        return;
    }
    stroke({-3, -6}, {-3, 6});
    Area flag;
    flag.rings = {{at + Vec2(-3, -7) * unit, at + Vec2(7, -3) * unit, at + Vec2(-3, 1) * unit}};
    flag.paint.top = flag.paint.bottom = mark.colour;
    shapes.emplace_back(std::move(flag));
}

}  // namespace

bool is_on_timeline(Vec2 const& pixel, Vec2 const& size) { return pixel.y() >= size.y() - grip * hud_scale(size); }

double time_at(Timeline const& timeline, Vec2 const& pixel, Vec2 const& size) {
    double const left = margin * hud_scale(size), length = std::max(size.x() - 2 * left, 1.0);
    return timeline.from + std::clamp((pixel.x() - left) / length, 0.0, 1.0) * (timeline.to - timeline.from);
}

std::vector<Shape> timeline_shapes(Timeline const& timeline, Vec2 const& size) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size);
    double const left = margin * unit, right = size.x() - margin * unit, y = size.y() - thickness / 2 * unit;
    double const length = std::max(timeline.to - timeline.from, 1e-9);
    auto const at = [&](double time) {
        double const share = std::clamp((time - timeline.from) / length, 0.0, 1.0);
        return Vec2(left + share * (right - left), y);
    };
    auto const bar = [&](double from, double to, double width, Colour const& paint) {
        shapes.emplace_back(Stroke{at(from), at(to), width * unit, paint});
    };
    shapes.emplace_back(Panel{{0, size.y() - thickness * unit}, {size.x(), thickness * unit}, 0, palette::night});
    bar(timeline.from, timeline.to, 4, faded(palette::bright, 0.3f));
    bar(timeline.from, timeline.shown, 4, faded(palette::bright, 0.85f));
    for (Timeline::Span const& pull : timeline.pulls) bar(pull.from, pull.to, 4, palette::strain);
    for (Timeline::Mark const& mark : timeline.marks) add_mark(shapes, mark, at(mark.time), unit);
    shapes.emplace_back(Disc{at(timeline.shown), 7 * unit, palette::bright, palette::ink, 2 * unit, 0});
    return shapes;
}

}  // namespace view
