// Curves of paths, ends that miss each other, places as wide as the ball, ground drawn twice, no gravity.
#include <algorithm>
#include <cmath>

#include "hunt/kinds.h"
#include "hunt/otherwise.h"
#include "hunt/pen.h"

namespace hunt {

namespace {

using geometry::pi;

// What is a bit too wide, just right and a bit too narrow for a ball, m.
double slight(Dice& dice) { return dice.pick({0, 0, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3, 0.02, 0.2}); }

Vec2 shifted(Dice& dice, Vec2 const& point) {
    return point + dice.pick({1e-12, 1e-10, 1e-8, 1e-7, 9e-7, 1.1e-6, 1e-5, 1e-4}) * dice.direction();
}

Stroke shifted(Dice& dice, Stroke stroke) {
    if (auto* line = std::get_if<Line>(&stroke)) {
        if (dice.chance(0.5)) line->from = shifted(dice, line->from);
        if (dice.chance(0.5)) line->to = shifted(dice, line->to);
    } else if (auto* bow = std::get_if<Bow>(&stroke)) {
        if (dice.chance(0.5)) bow->from = shifted(dice, bow->from);
        if (dice.chance(0.5)) bow->to = shifted(dice, bow->to);
    }
    return stroke;
}

// Tangents kept from one curve to the next, as C, S, Q and T draw them.
std::vector<Stroke> smooth_path(Dice& dice, Vec2 at, double width) {
    std::vector<Stroke> strokes;
    int const count = dice.whole(1, 6);
    Vec2 lead = dice.between(0.2, 2) * dice.direction();
    bool const cubic = dice.chance(0.6);
    for (int i = 0; i < count; ++i) {
        Vec2 const to = at + Vec2(width / count, dice.between(-1.5, 1.5));
        if (dice.chance(0.2)) lead = dice.between(0.2, 2) * dice.direction();  // a corner
        if (cubic) {
            Vec2 const second = to + dice.between(0.1, 2) * dice.direction();
            strokes.push_back(Cubic{at, at + lead, second, to});
            lead = to - second;
        } else {
            Vec2 const handle = at + lead;
            strokes.push_back(Quadratic{at, handle, to});
            lead = 0.5 * (to - handle);
        }
        at = to;
    }
    return strokes;
}

struct Place {
    std::vector<Stroke> strokes;
    Vec2 start = Vec2::Zero();  // of a ball that goes in
};

// Two lines from one point.
Place wedge(Dice& dice, Vec2 const& at, double radius) {
    double const half = dice.chance(0.2) ? pi / 4 : dice.scaled(0.005, 1.5);
    Vec2 const middle = dice.chance(0.6) ? Vec2(0, 1) : dice.direction();
    auto const [sine, cosine] = geometry::sine_cosine(half);
    Vec2 const left = geometry::turned(middle, cosine, sine), right = geometry::turned(middle, cosine, -sine);
    double const deep = radius / sine;
    return {{Line{at + (deep + 3) * left, at}, Line{at, at + (deep + 2) * right}},
            at + (deep + dice.between(0, 2)) * middle};
}

// A slot between two walls, open or closed below.
Place slot(Dice& dice, Vec2 const& at, double radius) {
    double const width = 2 * radius + slight(dice) * (dice.chance(0.85) ? 1 : -1), depth = dice.between(0.5, 4);
    Vec2 const left = at, right = at + Vec2(width, 0), down(0, -depth);
    Place place{{Line{left, left + down}, Line{right, right + down}},
                at + Vec2(width / 2, dice.between(0, 2) * radius + radius * 1.01)};
    if (dice.chance(0.5)) place.strokes.push_back(Line{left + down, right + down});
    if (dice.chance(0.7)) place.strokes.push_back(Line{left - Vec2(dice.between(0.5, 3), 0), left});
    if (dice.chance(0.7)) place.strokes.push_back(Line{right, right + Vec2(dice.between(0.5, 3), 0)});
    if (dice.chance(0.3)) place.start = at + Vec2(width / 2, -depth / 2);
    return place;
}

// A cup of the ball's own width, or a bit more or less.
Place cup(Dice& dice, Vec2 const& at, double radius) {
    double const wide = radius + slight(dice) * (dice.chance(0.8) ? 1 : -0.1);
    double const half = dice.chance(0.4) ? pi / 2 : dice.between(0.3, 3.1);
    auto const [sine, cosine] = geometry::sine_cosine(half);
    Pen pen(at + wide * Vec2(-sine, -cosine), Vec2(cosine, -sine));
    pen.bend(wide, half).bend(wide, half);
    if (dice.chance(0.4)) pen.ahead(dice.between(0.1, 2));
    return {pen.strokes(), dice.chance(0.3) ? at : Vec2(at + Vec2(0, dice.between(1, 4) * radius))};
}

// A lane that goes down with a bend, a bit wider than the ball: the ball as a bead in a pipe.
Place pipe(Dice& dice, Vec2 const& at, double radius) {
    double const slope = dice.between(-1.2, -0.05), width = 2 * radius + slight(dice), bend = dice.between(0.1, 2),
                 turn = dice.sign() * dice.between(0.2, 2), length = dice.between(0.5, 3);
    auto const [sine, cosine] = geometry::sine_cosine(slope);
    Vec2 const along(cosine, sine), up(-sine, cosine);
    Pen low(at, along), high(at + width * up, along);
    low.ahead(length).bend(turn > 0 ? bend + width : bend, turn).ahead(1);
    high.ahead(length).bend(turn > 0 ? bend : bend + width, turn).ahead(1);
    Place place{low.strokes(), at + (dice.unit() * length / 2) * along + (width / 2) * up};
    place.strokes.insert(place.strokes.end(), high.strokes().begin(), high.strokes().end());
    return place;
}

// A groove whose edges, or a hole whose rims, hold the ball at its widest.
Place hole(Dice& dice, Vec2 const& at, double radius) {
    double const width = 2 * radius + slight(dice) * dice.pick({1, 1, -1});
    Vec2 const left = at, right = at + Vec2(width, 0);
    Place place{{Line{left - Vec2(dice.between(0.3, 4), dice.between(-1, 0.2)), left},
                 Line{right, right + Vec2(dice.between(0.3, 4), dice.between(-0.2, 1))}},
                at + Vec2(width / 2 + dice.pick({0, 0, 0.01, 0.3}) * dice.sign(), radius * dice.between(1.1, 4))};
    if (dice.chance(0.3)) place.strokes.push_back(Line{left - Vec2(0, dice.between(0.1, 2)), right - Vec2(0, 0.2)});
    return place;
}

}  // namespace

std::vector<Vec2> draw_curves(Dice& dice, Sketch& sketch) {
    physics::Material const material = drawn_material(dice);
    if (dice.chance(0.75)) add_box(sketch, material, 0);
    sketch.elements.push_back(
        {smooth_path(dice, {dice.between(0.2, 4), dice.between(1, 4)}, dice.between(4, 15)), material});
    for (int i = dice.whole(0, 2); i > 0; --i)
        sketch.elements.push_back({smooth_path(dice, drawn_point(dice, sketch), dice.between(0.2, 6)),
                                   dice.chance(0.8) ? material : drawn_material(dice)});
    return {};
}

std::vector<Vec2> draw_gaps(Dice& dice, Sketch& sketch) {
    std::vector<Vec2> hints = any_ground(dice)(dice, sketch);
    for (Element& element : sketch.elements) {
        std::vector<Stroke> whole;
        whole.swap(element.strokes);
        for (Stroke const& stroke : whole) {
            std::vector<Stroke> const parts = dice.chance(0.3) ? split(dice, stroke) : std::vector<Stroke>{stroke};
            for (Stroke const& part : parts) {
                element.strokes.push_back(dice.chance(0.5) ? shifted(dice, part) : part);
                // Let go where it comes down on an end.
                if (dice.chance(0.1))
                    hints.push_back(from_of(part) + Vec2(0, sketch.ball.radius * dice.between(1.0, 3)));
            }
        }
    }
    return hints;
}

std::vector<Vec2> draw_narrow(Dice& dice, Sketch& sketch) {
    physics::Material const material = drawn_material(dice);
    if (dice.chance(0.75)) add_box(sketch, material, 0);
    constexpr Place (*places[])(Dice&, Vec2 const&, double) = {wedge, slot, cup, pipe, hole};
    std::vector<Vec2> hints;
    for (int i = dice.whole(1, 2); i > 0; --i) {
        Vec2 const at(dice.between(3, 12), dice.between(2, 6));
        Place const place = places[dice.whole(0, 4)](dice, at, sketch.ball.radius);
        sketch.elements.push_back({place.strokes, dice.chance(0.7) ? material : drawn_material(dice)});
        hints.push_back(place.start);
    }
    if (dice.chance(0.5)) sketch.ball.start.velocity *= 0.1;
    return hints;
}

std::vector<Vec2> draw_twice(Dice& dice, Sketch& sketch) {
    std::vector<Vec2> const hints = any_ground(dice)(dice, sketch);
    std::vector<Element> const once = sketch.elements;
    bool const same = dice.chance(0.5);
    for (Element const& element : once) {
        if (!dice.chance(0.8)) continue;
        Element copy{{}, same ? element.material : drawn_material(dice)};
        for (Stroke const& stroke : element.strokes) {
            std::vector<Stroke> const parts = split(dice, stroke);
            int const which = dice.whole(0, 3);
            if (which == 0) copy.strokes.push_back(stroke);
            if (which == 1) copy.strokes.push_back(backwards(stroke));
            if (which == 2) copy.strokes.push_back(parts.front());
            if (which == 3) copy.strokes.push_back(backwards(parts.back()));
        }
        auto const place = dice.chance(0.5) ? sketch.elements.end() : sketch.elements.begin();
        sketch.elements.insert(place, copy);
    }
    return hints;
}

std::vector<Vec2> draw_zero_g(Dice& dice, Sketch& sketch) {
    constexpr Drawing grounds[] = {draw_lines, draw_arcs, draw_stones, draw_grid, draw_curves, draw_gaps, draw_narrow};
    std::vector<Vec2> const hints = grounds[dice.whole(0, 6)](dice, sketch);
    sketch.gravity = 0;
    if (sketch.ball.start.velocity == Vec2::Zero())
        sketch.ball.start.velocity = dice.scaled(0.1, 20) * dice.direction();
    return hints;
}

namespace {

Vec2 rounded(Vec2 const& place, double unit) {
    return {std::round(place.x() / unit) * unit, std::round(place.y() / unit) * unit};
}

void round_off(Stroke& stroke, double unit) {
    if (auto* line = std::get_if<Line>(&stroke)) *line = {rounded(line->from, unit), rounded(line->to, unit)};
    if (auto* bow = std::get_if<Bow>(&stroke)) {
        bow->from = rounded(bow->from, unit);
        bow->to = rounded(bow->to, unit);
    }
}

}  // namespace

// As editors write them, with so many decimals: tangents agree by no more.
std::vector<Vec2> draw_rounded(Dice& dice, Sketch& sketch) {
    constexpr Drawing grounds[] = {draw_arcs, draw_stones, draw_lines};
    grounds[dice.whole(0, 2)](dice, sketch);
    double const unit = std::pow(10, -dice.whole(2, 12));
    for (Element& element : sketch.elements)
        for (Stroke& stroke : element.strokes) round_off(stroke, unit);
    return {};
}

}  // namespace hunt
