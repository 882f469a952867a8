#include "screen/shape_batch.h"

#include <algorithm>
#include <cmath>

namespace screen {
namespace {

using view::Colour;
using view::Vec2;

constexpr double pi = 3.14159265358979323846;

float narrow(double value) { return static_cast<float>(value); }

// Half a pixel of anti-aliasing on each side, and a margin for rounding.
constexpr double fringe = 1;  // pixels

constexpr std::array<view::Livery, 8> liveries{{
    {{0.96F, 0.26F, 0.21F}, {1.00F, 0.86F, 0.35F}},  // coral and honey: the player's
    {{0.16F, 0.45F, 0.93F}, {0.62F, 0.88F, 1.00F}},  // blue and ice
    {{0.13F, 0.66F, 0.33F}, {0.80F, 0.95F, 0.45F}},  // green and lime
    {{0.56F, 0.27F, 0.86F}, {1.00F, 0.70F, 0.88F}},  // violet and pink
    {{0.98F, 0.52F, 0.10F}, {1.00F, 0.94F, 0.78F}},  // orange and cream
    {{0.05F, 0.62F, 0.66F}, {0.70F, 0.98F, 0.86F}},  // teal and mint
    {{0.28F, 0.31F, 0.38F}, {0.86F, 0.89F, 0.94F}},  // graphite and silver
    {{0.86F, 0.16F, 0.50F}, {1.00F, 0.80F, 0.62F}},  // magenta and peach
}};

Quad coloured(Colour const& colour) {
    Quad quad;
    quad.colour = floats(colour);
    return quad;
}

// Shapes thinner than a pixel are drawn a pixel wide and fainter: the same light in all.
Colour faded(Colour colour, double share) {
    colour.alpha *= narrow(std::min(1.0, share));
    return colour;
}

std::array<float, 8> slanted(Vec2 const& centre, Vec2 const& along, double half_length, double half_width) {
    Vec2 const a = along * half_length, b = geometry::turned_left(along) * half_width;
    std::array<float, 8> corners{};
    std::size_t i = 0;
    for (Vec2 const& corner :
         {Vec2(centre - a - b), Vec2(centre + a - b), Vec2(centre - a + b), Vec2(centre + a + b)}) {
        corners[i++] = narrow(corner.x());
        corners[i++] = narrow(corner.y());
    }
    return corners;
}

// Quads side by side around a circle that hold all of a ring's pixels once, and few others.
void add_ring(Batch& batch, Quad quad, Vec2 const& centre, double inner, double outer, double from, double sweep) {
    int const pieces = std::clamp(static_cast<int>(std::ceil(std::abs(sweep) * std::sqrt(outer) / 2)), 1, 512);
    double const step = sweep / pieces, reach = outer / std::cos(step / 2);
    auto const put = [&](std::size_t at, int i, double radius) {
        // The last spoke of a full circle is the first one, to the bit.
        double const angle = from + (i == pieces && std::abs(sweep) >= 2 * pi ? 0 : i) * step;
        quad.corners[at] = narrow(centre.x() + radius * std::cos(angle));
        quad.corners[at + 1] = narrow(centre.y() + radius * std::sin(angle));
    };
    for (int i = 0; i < pieces; ++i) {
        put(0, i, inner);
        put(2, i, reach);
        put(4, i + 1, inner);
        put(6, i + 1, reach);
        batch.add(Program::arc, quad);
    }
}

}  // namespace

void Batch::add(Program program, Quad const& quad, Blending blending) {
    if (runs.empty() || runs.back().program != program || runs.back().blending != blending)
        runs.push_back({program, blending, static_cast<int>(quads.size()), 0});
    quads.push_back(quad);
    ++runs.back().count;
}

void Batch::clear() {
    quads.clear();
    runs.clear();
}

std::array<float, 8> upright(double left, double top, double right, double bottom) {
    return {narrow(left), narrow(top),    narrow(right), narrow(top),
            narrow(left), narrow(bottom), narrow(right), narrow(bottom)};
}

std::array<float, 4> floats(Colour const& colour) {
    auto const unit = [](float value) { return std::clamp(value, 0.0F, 1.0F); };
    return {unit(colour.red), unit(colour.green), unit(colour.blue), unit(colour.alpha)};
}

view::Livery livery_of(view::Shell const& shell) {
    auto const count = static_cast<int>(liveries.size());
    return shell.own.value_or(liveries[static_cast<std::size_t>((shell.livery % count + count) % count)]);
}

void add_shape(Batch& batch, view::Sky const& sky, Box const& box, int height) {
    Quad quad = coloured(sky.top);
    quad.second_colour = floats(sky.bottom);
    quad.corners = upright(box.left, box.top, box.right, box.bottom);
    quad.form = {0, narrow(height), 0, 0};
    batch.add(Program::smooth_area, quad,
              sky.top.alpha >= 1 && sky.bottom.alpha >= 1 ? Blending::opaque : Blending::over);
}

void add_shape(Batch& batch, view::Disc const& disc) {
    if (!(disc.radius > 0)) return;
    if (disc.fill.alpha <= 0 && disc.rim_width > 0 && disc.rim_width < disc.radius && disc.softness <= 1) {
        double const radius = disc.radius - disc.rim_width / 2;
        return add_shape(batch, view::ArcStroke{disc.centre, radius, 0, 2 * pi, disc.rim_width, disc.rim});
    }
    double const radius = std::max(disc.radius, 0.5), share = 4 * disc.radius * disc.radius;
    double const reach = radius + std::max(disc.softness, 1.0) / 2 + fringe;
    Quad quad = coloured(faded(disc.fill, share));
    quad.second_colour = floats(faded(disc.rim, share));
    quad.corners = slanted(disc.centre, {1, 0}, reach, reach);
    quad.place = {narrow(disc.centre.x()), narrow(disc.centre.y()), narrow(radius), narrow(disc.softness)};
    quad.form[0] = narrow(disc.rim_width);
    batch.add(Program::disc, quad);
}

void add_shape(Batch& batch, view::Stroke const& stroke) {
    if (!(stroke.width > 0)) return;
    Vec2 const along = stroke.to - stroke.from, middle = (stroke.from + stroke.to) / 2;
    double const length = geometry::length(along), half_width = std::max(stroke.width, 1.0) / 2;
    Vec2 const direction = length > 0 ? Vec2(along / length) : Vec2(1, 0);
    Quad quad = coloured(faded(stroke.colour, stroke.width));
    quad.corners = slanted(middle, direction, length / 2 + half_width + fringe, half_width + fringe);
    quad.place = {narrow(middle.x()), narrow(middle.y()), narrow(direction.x()), narrow(direction.y())};
    quad.form = {narrow(length / 2), 0, narrow(half_width), 0};
    batch.add(Program::box, quad);
}

void add_shape(Batch& batch, view::ArcStroke const& arc) {
    if (!(arc.width > 0) || !(arc.radius > 0)) return;
    double const half_width = std::max(arc.width, 1.0) / 2, half_angle = std::min(std::abs(arc.sweep) / 2, pi);
    double const middle = arc.from + arc.sweep / 2, outer = arc.radius + half_width + fringe;
    Quad quad = coloured(faded(arc.colour, arc.width));
    quad.place = {narrow(arc.centre.x()), narrow(arc.centre.y()), narrow(std::cos(middle)), narrow(std::sin(middle))};
    quad.form = {narrow(arc.radius), narrow(half_width), narrow(std::cos(half_angle)), narrow(std::sin(half_angle))};
    constexpr double small = 24;  // pixels: below, one square costs less than a ring of quads
    if (outer < small) {
        quad.corners = slanted(arc.centre, {1, 0}, outer, outer);
        return batch.add(Program::arc, quad);
    }
    double const inner = std::max(0.0, arc.radius - half_width - fringe);
    double const cap = inner > 0 ? std::asin(std::min(1.0, (half_width + fringe) / arc.radius)) : pi;
    double const half_reach = std::min(half_angle + cap, pi);
    add_ring(batch, quad, arc.centre, inner, outer, middle - half_reach, 2 * half_reach);
}

void add_shape(Batch& batch, view::Panel const& panel) {
    if (!(panel.size.x() > 0) || !(panel.size.y() > 0)) return;
    Vec2 const half = panel.size / 2, centre = panel.corner + half;
    double const rounding = std::clamp(panel.rounding, 0.0, std::min(half.x(), half.y()));
    Quad quad = coloured(panel.colour);
    quad.corners = slanted(centre, {1, 0}, half.x() + fringe, half.y() + fringe);
    quad.place = {narrow(centre.x()), narrow(centre.y()), 1, 0};
    quad.form = {narrow(half.x() - rounding), narrow(half.y() - rounding), narrow(rounding), 0};
    batch.add(Program::box, quad);
}

void add_shape(Batch& batch, view::Shell const& shell) {
    if (!(shell.radius > 0)) return;
    view::Livery const livery = livery_of(shell);
    double const brightness = geometry::length(shell.light), reach = shell.radius + fringe;
    Vec2 const light = brightness > 0 ? Vec2(shell.light / brightness) : Vec2(0, -1);
    Quad quad = coloured(livery.upper);
    quad.second_colour = floats(livery.lower);
    quad.corners = slanted(shell.centre, {1, 0}, reach, reach);
    view::Monkey const& monkey = shell.monkey;
    quad.place = {narrow(shell.centre.x()), narrow(shell.centre.y()), narrow(shell.radius), narrow(monkey.blink)};
    quad.more = {narrow(std::cos(monkey.lean)), narrow(std::sin(monkey.lean)), narrow(monkey.stride),
                 narrow(monkey.swing)};
    quad.colour[3] = narrow(0.5 + 0.5 * std::clamp(monkey.gaze.x(), -1.0, 1.0));
    quad.second_colour[3] = narrow(0.5 + 0.5 * std::clamp(monkey.gaze.y(), -1.0, 1.0));
    quad.form = {narrow(std::cos(shell.angle)), narrow(std::sin(shell.angle)), narrow(light.x()), narrow(light.y())};
    batch.add(Program::shell, quad);
}

}  // namespace screen
