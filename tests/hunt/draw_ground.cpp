// Lines and hills, tangent arcs, stones, grids of lines that cross.
#include <cmath>

#include "hunt/kinds.h"
#include "hunt/pen.h"

namespace hunt {

namespace {

using geometry::pi;

// Mostly closed, so that the ball lives until the end.
void maybe_box(Dice& dice, Sketch& sketch, physics::Material const& material) {
    if (!dice.chance(0.75)) return;
    add_box(sketch, material, dice.chance(0.7) ? 0 : dice.between(0.2, 4));
}

Element hills(Dice& dice, Sketch const& sketch, physics::Material const& material) {
    int const count = dice.whole(3, 14);
    double const roughness = dice.scaled(0.05, 5);
    std::vector<Stroke> strokes;
    Vec2 at(0.3, dice.between(0.5, 3));
    for (int i = 0; i < count; ++i) {
        Vec2 to(0.3 + (i + 1) * (sketch.width - 0.6) / count, 0.5 + dice.unit() * roughness);
        if (dice.chance(0.1)) to.x() = at.x();  // upright
        if (dice.chance(0.1)) to.y() = at.y();
        strokes.push_back(Line{at, to});
        at = to;
    }
    return {strokes, material};
}

// Half a pipe or a bathtub: down, round, along, round, up, and maybe over.
std::vector<Stroke> half_pipe(Dice& dice, Vec2 const& at, double width) {
    double const left = dice.between(0.2, width / 2), right = dice.between(0.2, width / 2);
    Pen pen(at, {0, -1});
    pen.ahead(dice.between(0, 3)).bend(left, pi / 2).ahead(std::max(0.0, width - left - right));
    pen.bend(right, pi / 2).ahead(dice.between(0, 3));
    if (dice.chance(0.3)) pen.bend(dice.between(0.2, 2), pi / 2).ahead(dice.between(0, 2));
    return pen.strokes();
}

std::vector<Stroke> bowl(Dice& dice, Vec2 const& centre) {
    double const radius = dice.chance(0.5) ? dice.between(0.5, 4) : dice.pick({0.5, 1, 2, 3}),
                 half = dice.between(0.3, 3);
    auto const [sine, cosine] = geometry::sine_cosine(half);
    Pen pen(centre + radius * Vec2(-sine, -cosine), Vec2(cosine, -sine));
    pen.bend(radius, 2 * half);
    if (dice.chance(0.5)) pen.ahead(dice.between(0.1, 2));
    return pen.strokes();
}

std::vector<Stroke> loop(Dice& dice, Vec2 const& at) {
    double const radius = dice.between(0.5, 2.5);
    Pen pen(at, {1, 0});
    pen.ahead(dice.between(0.5, 5)).bend(radius, dice.between(1, 2) * pi).ahead(dice.between(0.1, 4));
    return pen.strokes();
}

// Lines and arcs as they come, tangents kept.
std::vector<Stroke> snake(Dice& dice, Vec2 const& at) {
    Pen pen(at, dice.chance(0.5) ? Vec2(1, 0) : dice.direction());
    int const count = dice.whole(2, 10);
    for (int i = 0; i < count; ++i) {
        if (dice.chance(0.4)) pen.ahead(dice.scaled(0.05, 5));
        double const angle = dice.chance(0.4) ? dice.pick({0.25, 0.5, 1}) * pi : dice.scaled(0.02, 3.5);
        pen.bend(dice.scaled(0.1, 5), dice.sign() * angle);
    }
    return pen.strokes();
}

Vec2 snapped(Vec2 const& point, double step) {
    return {std::round(point.x() / step) * step, std::round(point.y() / step) * step};
}

}  // namespace

std::vector<Vec2> draw_lines(Dice& dice, Sketch& sketch) {
    physics::Material const material = drawn_material(dice);
    maybe_box(dice, sketch, material);
    bool const hilly = dice.chance(0.7) || sketch.elements.empty();
    if (hilly) sketch.elements.push_back(hills(dice, sketch, material));
    int const loose = dice.whole(hilly ? 0 : 2, 7);
    for (int i = 0; i < loose; ++i) {
        std::vector<Stroke> strokes;
        Vec2 at = drawn_point(dice, sketch);
        for (int j = dice.whole(1, 4); j > 0; --j) {
            Vec2 const to =
                dice.chance(0.5) ? drawn_point(dice, sketch) : Vec2(at + dice.scaled(0.02, 3) * dice.direction());
            strokes.push_back(Line{at, to});
            at = to;
        }
        sketch.elements.push_back({strokes, dice.chance(0.7) ? material : drawn_material(dice)});
    }
    return {};
}

std::vector<Vec2> draw_arcs(Dice& dice, Sketch& sketch) {
    physics::Material const material = drawn_material(dice);
    maybe_box(dice, sketch, material);
    std::vector<Vec2> hints;
    for (int i = dice.whole(1, 3); i > 0; --i) {
        Vec2 const at = drawn_point(dice, sketch);
        Element element{{}, dice.chance(0.8) ? material : drawn_material(dice)};
        switch (dice.whole(0, 4)) {
            case 0:
                element.strokes = half_pipe(dice, at, dice.between(1, 14));
                break;
            case 1:
                element.strokes = bowl(dice, at);
                break;
            case 2:
                element.strokes = loop(dice, at);
                break;
            case 3:
                element.strokes = snake(dice, at);
                break;
            default: {
                double const radius = sketch.ball.radius * dice.between(1.1, 6);
                element.strokes = {Disc{at, radius}};  // a ring with the ball in it
                hints.push_back(at + dice.unit() * (radius - sketch.ball.radius) * dice.direction());
            }
        }
        sketch.elements.push_back(element);
    }
    return dice.chance(0.5) ? hints : std::vector<Vec2>();
}

std::vector<Vec2> draw_stones(Dice& dice, Sketch& sketch) {
    physics::Material const material = drawn_material(dice);
    maybe_box(dice, sketch, material);
    if (dice.chance(0.4)) sketch.elements.push_back(hills(dice, sketch, material));
    for (int i = dice.whole(1, 8); i > 0; --i) {
        Vec2 const at = drawn_point(dice, sketch);
        Element stone{{}, dice.chance(0.7) ? material : drawn_material(dice)};
        double const size = dice.scaled(0.02, 2);
        if (dice.chance(0.4)) {
            stone.strokes = {Disc{at, size}};
        } else if (dice.chance(0.5)) {
            int const corners = dice.whole(3, 8);
            Pen pen(at, dice.direction());
            for (int corner = 1; corner < corners; ++corner)
                pen.ahead(size * dice.between(0.5, 1)).corner(2 * pi / corners);
            stone.strokes = pen.to(at).strokes();
        } else {
            double const rounding = size * dice.between(0.1, 1);
            Pen pen(at, dice.chance(0.5) ? Vec2(1, 0) : dice.direction());
            double const sides[] = {dice.between(0, 3), dice.between(0, 1)};
            for (int side = 0; side < 4; ++side) pen.ahead(sides[side % 2]).bend(rounding, pi / 2);
            stone.strokes = pen.strokes();
        }
        sketch.elements.push_back(stone);
    }
    return {};
}

std::vector<Vec2> draw_grid(Dice& dice, Sketch& sketch) {
    physics::Material const material = drawn_material(dice);
    double const step = dice.pick({0.25, 0.5, 1});
    if (dice.chance(0.6)) maybe_box(dice, sketch, material);
    Element grid{{Line{{0, step}, {sketch.width, step}}}, material};
    int const count = dice.whole(4, 24);
    for (int i = 0; i < count; ++i) {
        Vec2 const from = snapped(drawn_point(dice, sketch), step);
        Vec2 to = snapped(drawn_point(dice, sketch), step);
        if (dice.chance(0.4)) to.x() = from.x();
        if (dice.chance(0.4)) to.y() = from.y();
        if (to == from) to.x() += step;
        grid.strokes.push_back(Line{from, to});
        if (dice.chance(0.15)) grid.strokes.push_back(Line{from, to});                        // doubled
        if (dice.chance(0.15)) grid.strokes.push_back(Line{to, from});                        // and back
        if (dice.chance(0.15)) grid.strokes.push_back(Line{from, from + 0.5 * (to - from)});  // in part
        if (dice.chance(0.15)) grid.strokes.push_back(Line{from + 0.5 * (to - from), drawn_point(dice, sketch)});
        if (dice.chance(0.08)) grid.strokes.push_back(Bow{from, to, 0.6 * geometry::length(to - from), false, true});
    }
    if (dice.chance(0.5)) {
        sketch.elements.push_back(grid);
    } else {
        for (Stroke const& stroke : grid.strokes) sketch.elements.push_back({{stroke}, material});
    }
    return {};
}

}  // namespace hunt
