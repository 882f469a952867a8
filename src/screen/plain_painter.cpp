#include "screen/plain_painter.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "geometry/elementary.h"
#include "screen/coverage.h"
#include "screen/shape_batch.h"

namespace screen {
namespace {

using view::Colour;
using view::Vec2;

Colour between(Colour const& from, Colour const& to, double share) {
    auto const mixed = [&](float a, float b) { return a + static_cast<float>(share) * (b - a); };
    return {mixed(from.red, to.red), mixed(from.green, to.green), mixed(from.blue, to.blue),
            mixed(from.alpha, to.alpha)};
}

Colour paint_at(view::Paint const& paint, double x, double y) {
    double const length = paint.bottom_y - paint.top_y;
    double const along = x * paint.down.x() + y * paint.down.y() - paint.top_y;
    return between(paint.top, paint.bottom, std::clamp(along / (length == 0 ? 1 : length), 0.0, 1.0));
}

double clear_of(double distance) { return std::clamp(0.5 - distance, 0.0, 1.0); }  // coverage, pixels from the edge

// Of a rounded box, as shaders.h has it.
double box_distance(Vec2 const& local, Vec2 const& half, double radius) {
    Vec2 const q = local.cwiseAbs() - half;
    return geometry::length(q.cwiseMax(0.0)) + std::min(q.maxCoeff(), 0.0) - radius;
}

double oval_coverage(Vec2 const& p, Vec2 const& centre, Vec2 const& radii, double pixels) {
    Vec2 const q = (p - centre).cwiseQuotient(radii);
    return clear_of((geometry::length(q) - 1) * radii.minCoeff() * pixels);
}

}  // namespace

Pixels const& PlainPainter::paint(view::Picture const& picture) {
    require_paintable(picture.width, picture.height);
    pixels_.width = picture.width;
    pixels_.height = picture.height;
    pixels_.rgba.resize(4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    bool const begins_with_sky = !picture.backdrop.empty() && std::holds_alternative<view::Sky>(picture.backdrop[0]);
    if (!begins_with_sky) add(view::Sky{{0, 0, 0, 1}, {0, 0, 0, 1}});
    for (auto const* shapes : {&picture.backdrop, &picture.shapes})
        for (view::Shape const& shape : *shapes) std::visit([&](auto const& it) { add(it); }, shape);
    return pixels_;
}

void PlainPainter::fill_row(int y, int left, int right, Colour const& colour) {
    left = std::max(left, 0);
    right = std::min(right, pixels_.width);
    if (y < 0 || y >= pixels_.height || left >= right) return;
    if (colour.alpha < 1) {
        for (int x = left; x < right; ++x) blend(x, y, colour, 1);
        return;
    }
    auto const [red, green, blue, alpha] = floats(colour);
    auto const byte = [](float value) { return static_cast<std::uint8_t>(value * 255 + 0.5F); };
    bool const turned = order_ == ChannelOrder::bgra;
    std::uint8_t const bytes[] = {byte(turned ? blue : red), byte(green), byte(turned ? red : blue), byte(alpha)};
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, bytes, sizeof pixel);
    std::uint8_t* to = pixels_.rgba.data() + 4 * (static_cast<std::size_t>(y) * pixels_.width + left);
    for (int x = left; x < right; ++x, to += sizeof pixel) std::memcpy(to, &pixel, sizeof pixel);
}

void PlainPainter::blend(int x, int y, Colour const& colour, double coverage) {
    int const amount = static_cast<int>(std::clamp<double>(colour.alpha, 0, 1) * coverage * 256 + 0.5);
    if (amount <= 0) return;
    std::uint8_t* const at = pixels_.rgba.data() + 4 * (static_cast<std::size_t>(y) * pixels_.width + x);
    float const channels[] = {colour.red, colour.green, colour.blue};
    for (int i = 0; i < 3; ++i) {
        std::uint8_t& byte = at[order_ == ChannelOrder::bgra ? 2 - i : i];
        int const to = static_cast<int>(std::clamp(channels[i], 0.0F, 1.0F) * 255 + 0.5F);
        byte = static_cast<std::uint8_t>(byte + (to - byte) * amount / 256);
    }
}

template <class Coverage>
void PlainPainter::blend_box(Vec2 const& low, Vec2 const& high, Colour const& colour, Coverage const& coverage) {
    constexpr double far = 1e6;  // pixels
    if (!(low.minCoeff() > -far && high.maxCoeff() < far)) return;
    int const left = std::max(0, static_cast<int>(std::floor(low.x())));
    int const right = std::min(pixels_.width, static_cast<int>(std::ceil(high.x())));
    int const top = std::max(0, static_cast<int>(std::floor(low.y())));
    int const bottom = std::min(pixels_.height, static_cast<int>(std::ceil(high.y())));
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) blend(x, y, colour, coverage(Vec2(x + 0.5, y + 0.5)));
}

void PlainPainter::add(view::Sky const& sky) {
    for (int y = 0; y < pixels_.height; ++y)
        fill_row(y, 0, pixels_.width, between(sky.top, sky.bottom, (y + 0.5) / pixels_.height));
}

void PlainPainter::add(view::Area const& area) {
    Coverage const covered = coverage_of(area.rings, area.rule, pixels_.width, pixels_.height);
    bool const upright = std::abs(area.paint.down.x()) < 1e-3;
    for (Box const& box : covered.inside)
        for (int y = box.top; y < std::min(box.bottom, pixels_.height); ++y) {
            if (upright) {
                fill_row(y, box.left, box.right, paint_at(area.paint, 0, y + 0.5));
                continue;
            }
            for (int x = box.left; x < std::min(box.right, pixels_.width); ++x)
                fill_row(y, x, x + 1, paint_at(area.paint, x + 0.5, y + 0.5));
        }
    for (EdgeTile const& tile : covered.edges)
        for (int i = 0; i < tile_side * tile_side; ++i) {
            int const x = tile.left + i % tile_side, y = tile.top + i / tile_side;
            auto const value = tile.values[static_cast<std::size_t>(i)];
            if (value == 0 || x < 0 || y < 0 || x >= pixels_.width || y >= pixels_.height) continue;
            blend(x, y, paint_at(area.paint, x + 0.5, y + 0.5), value / 255.0);
        }
}

void PlainPainter::add(view::Disc const& disc) {
    if (!(disc.radius > 0)) return;
    double const softness = std::max(disc.softness, 1.0);
    auto const within = [&](Vec2 const& pixel, double radius) {
        double const distance = geometry::length(pixel - disc.centre) - radius;
        if (distance > softness / 2) return 0.0;
        double const inside = std::clamp(0.5 - distance / softness, 0.0, 1.0);
        return softness > 1 ? inside * inside * (3 - 2 * inside) : inside;
    };
    Vec2 const reach = Vec2::Constant(disc.radius + softness);
    double const inner = disc.rim_width > 0 ? disc.radius - disc.rim_width : disc.radius;
    if (disc.fill.alpha > 0) {
        double const solid = std::max(0.0, inner - softness / 2 - 1), squared = solid * solid;
        blend_box(disc.centre - reach, disc.centre + reach, disc.fill,
                  [&](Vec2 const& p) { return (p - disc.centre).squaredNorm() < squared ? 1.0 : within(p, inner); });
    }
    if (disc.rim_width > 0)
        blend_box(disc.centre - reach, disc.centre + reach, disc.rim,
                  [&](Vec2 const& p) { return within(p, disc.radius) - within(p, inner); });
}

void PlainPainter::add(view::Stroke const& stroke) {
    if (!(stroke.width > 0)) return;
    double const half_width = std::max(stroke.width, 1.0) / 2, share = std::min(1.0, stroke.width);
    Vec2 const way = stroke.to - stroke.from, margin = Vec2::Constant(half_width + 1);
    double const squared = std::max(way.squaredNorm(), 1e-12);
    blend_box(stroke.from.cwiseMin(stroke.to) - margin, stroke.from.cwiseMax(stroke.to) + margin, stroke.colour,
              [&](Vec2 const& p) {
                  Vec2 const d = p - stroke.from;
                  double const along = std::clamp(geometry::dot(d, way) / squared, 0.0, 1.0);
                  return share * clear_of(geometry::length(d - along * way) - half_width);
              });
}

void PlainPainter::add(view::ArcStroke const& arc) {
    if (!(arc.width > 0) || !(arc.radius > 0)) return;
    double const half_width = std::max(arc.width, 1.0) / 2, share = std::min(1.0, arc.width);
    double const middle = arc.from + arc.sweep / 2, half = std::min(std::abs(arc.sweep) / 2, geometry::pi);
    Vec2 const towards(std::cos(middle), std::sin(middle)), end(std::cos(half), std::sin(half));
    Vec2 const reach = Vec2::Constant(arc.radius + half_width + 1);
    blend_box(arc.centre - reach, arc.centre + reach, arc.colour, [&](Vec2 const& p) {
        Vec2 const d = p - arc.centre;
        Vec2 const local(geometry::dot(d, towards), std::abs(geometry::dot(d, geometry::turned_left(towards))));
        bool const beside = end.y() * local.x() >= end.x() * local.y();
        double const distance =
            beside ? std::abs(geometry::length(local) - arc.radius) : geometry::length(local - arc.radius * end);
        return share * clear_of(distance - half_width);
    });
}

void PlainPainter::add(view::Panel const& panel) {
    if (!(panel.size.x() > 0) || !(panel.size.y() > 0)) return;
    Vec2 const half = panel.size / 2, centre = panel.corner + half;
    double const rounding = std::clamp(panel.rounding, 0.0, half.minCoeff());
    Vec2 const core = half - Vec2::Constant(rounding), reach = half + Vec2::Constant(1);
    blend_box(centre - reach, centre + reach, panel.colour,
              [&](Vec2 const& p) { return clear_of(box_distance(p - centre, core, rounding)); });
}

// The halves, the seam and the face; stripes, limbs and the gleam of the glass take no part.
void PlainPainter::add(view::Shell const& shell) {
    if (!(shell.radius > 0)) return;
    view::Livery const livery = livery_of(shell);
    double const r = shell.radius, cosine = std::cos(shell.angle), sine = std::sin(shell.angle);
    Vec2 const reach = Vec2::Constant(r + 1);
    auto const part = [&](Colour const& colour, auto const& covered) {
        blend_box(shell.centre - reach, shell.centre + reach, colour, [&](Vec2 const& pixel) {
            Vec2 const d = (pixel - shell.centre) / r;
            return clear_of((geometry::length(d) - 1) * r) * covered(d);
        });
    };
    auto const height = [&](Vec2 const& d) { return -sine * d.x() - cosine * d.y(); };  // in the shell, upwards
    auto const oval = [&](Colour const& colour, Vec2 const& centre, Vec2 const& radii) {
        part(colour, [&](Vec2 const& d) { return oval_coverage({d.x(), -d.y()}, centre, radii, r); });
    };
    constexpr Colour fur{0.43F, 0.25F, 0.13F}, skin{0.99F, 0.83F, 0.63F}, dark{0.13F, 0.07F, 0.05F};
    part(livery.lower, [](Vec2 const&) { return 1.0; });
    part(livery.upper, [&](Vec2 const& d) { return clear_of(-height(d) * r); });
    part({1, 0.97F, 0.88F}, [&](Vec2 const& d) { return clear_of((std::abs(height(d)) - 0.065) * r); });
    oval(fur, {0, -0.31}, {0.25, 0.24});
    for (double const side : {-1.0, 1.0}) oval(fur, {0.43 * side, 0.26}, {0.14, 0.14});
    oval(fur, {0, 0.23}, {0.41, 0.41});
    for (double const side : {-1.0, 1.0}) oval(skin, {0.14 * side, 0.3}, {0.18, 0.21});
    oval(skin, {0, 0.06}, {0.31, 0.21});
    for (double const side : {-1.0, 1.0}) oval(dark, {0.12 * side, 0.31}, {0.06, 0.09});
    Colour veil = livery.upper, edge = between(livery.upper, {0, 0, 0, 1}, 0.7);
    veil.alpha = 0.26F;
    edge.alpha = 0.75F;
    part(veil, [](Vec2 const&) { return 1.0; });
    part(edge, [&](Vec2 const& d) { return clear_of((0.95 - geometry::length(d)) * r); });
}

void PlainPainter::add(view::Label const& label) {
    if (!glyphs_) glyphs_.emplace();
    double left = label.at.x();
    if (label.anchor != view::Anchor::Left) {
        double const width = glyphs_->width_of(label.text, label.height, label.weight);
        left -= label.anchor == view::Anchor::Centre ? width / 2 : width;
    }
    double const base_x = std::floor(left), base_y = std::floor(label.at.y() + 0.5);
    if (!(std::abs(base_x) <= 1e6 && std::abs(base_y) <= 1e6)) return;
    auto line = glyphs_->line(label, left - base_x);
    if (!line) {
        glyphs_->clear();
        line = glyphs_->line(label, left - base_x);
    }
    if (!line) return;
    for (auto const& [glyph, pen] : line->glyphs)
        for (int row = 0; row < glyph.height; ++row)
            for (int column = 0; column < glyph.width; ++column) {
                int const x = static_cast<int>(base_x) + pen + glyph.left + column;
                int const y = static_cast<int>(base_y) + glyph.top + row;
                if (x < 0 || y < 0 || x >= pixels_.width || y >= pixels_.height) continue;
                auto const at = static_cast<std::size_t>(glyph.atlas_y + row) * atlas_side + glyph.atlas_x + column;
                blend(x, y, label.colour, glyphs_->atlas()[at] / 255.0);
            }
}

}  // namespace screen
