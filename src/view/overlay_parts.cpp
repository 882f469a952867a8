#include "view/overlay_parts.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "view/palette.h"

namespace view {

namespace {

using game::Text;

constexpr Colour velocity_paint = colour(0x1668d8), normal_paint = colour(0xd8262f), kept_paint = colour(0x0b8a4a);
constexpr Colour roll_paint = colour(0x9a35c9), gravity_paint = colour(0x5a4632), drag_paint = colour(0xf0731a);
constexpr Colour motion_paint = colour(0x2f7de1), rotation_paint = colour(0xb05be0), height_paint = colour(0x35a85b);
constexpr Colour spring_paint = colour(0xf0832a);

// Long arrows are drawn in: what is twice as large is drawn longer, but never out of the picture.
Vec2 drawn_in(Vec2 const& way, double limit) {
    double const length = geometry::length(way);
    return length > 0 ? Vec2(way * (limit * std::tanh(length / limit) / length)) : way;
}

// On which side of a way another lies: 1 to its left, else -1.
double side_of(Vec2 const& way, Vec2 const& other) { return geometry::cross(way, other) > 0 ? 1 : -1; }

std::string pair_text(Vec2 const& v) {
    std::string text(1, '(');
    return text.append(written(v.x(), 2)).append(", ").append(written(v.y(), 2)).append(")");
}

Text text_of(physics::Phase phase) {
    switch (phase) {
        case physics::Phase::flight:
            return Text::shown_in_flight;
        case physics::Phase::roll:
            return Text::shown_rolling;
        case physics::Phase::slide:
            return Text::shown_sliding;
        case physics::Phase::rest:
            break;
    }
    return Text::shown_at_rest;
}

std::string words_on(Slate const& slate, Text text) { return game::words(text, slate.language); }

// How far the ball turns in a third of a second, as a curved arrow round it.
void draw_roll(Slate& slate, Vec2 const& centre, double radius, double spin) {
    double const sweep = std::clamp(spin / 3, -4.5, 4.5);
    if (std::abs(sweep) < 0.03) return;
    Camera const& camera = *slate.camera;
    Vec2 const middle = pixel_of(camera, centre);
    double const around = 1.28 * radius * camera.scale, unit = hud_scale(camera.size);
    double const from = -geometry::pi / 2;
    slate.shapes->emplace_back(ArcStroke{middle, around, from, -sweep, 4.5 * unit, palette::bright});
    slate.shapes->emplace_back(ArcStroke{middle, around, from, -sweep, 3 * unit, roll_paint});
    double const end = from - sweep;
    Vec2 const tip = middle + around * Vec2(std::cos(end), std::sin(end));
    Vec2 const out(std::cos(end), std::sin(end));
    Vec2 const on = (sweep > 0 ? -1 : 1) * Vec2(-out.y(), out.x());
    for (double const side : {-1.0, 1.0})
        slate.shapes->emplace_back(Stroke{tip, tip - 9 * unit * on + side * 6 * unit * out, 3 * unit, roll_paint});
}

// The newest rows last; energies of each kind on top of each other.
void draw_chart(Slate& slate, level::Level const& level, Moment const& moment, double lowest, double highest) {
    double const unit = hud_scale(slate.camera->size);
    Vec2 const size(table_width * unit, 96 * unit);
    Vec2 const corner(slate.table_left, slate.next_table);
    slate.shapes->emplace_back(Panel{corner, size, 10 * unit, palette::night});
    slate.next_table += size.y() + 8 * unit;
    double const span = std::max(highest - lowest, 1e-9);
    Vec2 const inner = size - Vec2(20, 20) * unit;
    auto const place = [&](double then, double value) -> Vec2 {
        double const x = 1 - std::clamp((moment.time - then) / chart_length, 0.0, 1.0);
        double const y = std::clamp((value - lowest) / span, 0.0, 1.0);
        return corner + Vec2(10, 10) * unit + Vec2(x * inner.x(), (1 - y) * inner.y());
    };
    double const newest = std::floor(moment.time / chart_spacing) * chart_spacing;
    struct Line {
        Colour paint;
        double (*value)(Energy const&);
    };
    Line const lines[] = {{height_paint, [](Energy const& e) { return e.height; }},
                          {motion_paint, [](Energy const& e) { return e.height + e.motion; }},
                          {rotation_paint, [](Energy const& e) { return e.height + e.motion + e.rotation; }}};
    for (Line const& line : lines)
        for (std::size_t i = 1; i < moment.recent.size(); ++i) {
            auto const energy = [&](std::size_t row) {
                return line.value(energy_of(level, moment.recent[row], {moment.forces.tilt, std::nullopt}));
            };
            auto const then = [&](std::size_t row) {
                return newest - chart_spacing * static_cast<double>(moment.recent.size() - 1 - row);
            };
            Vec2 const from = place(then(i - 1), energy(i - 1)), to = place(then(i), energy(i));
            slate.shapes->emplace_back(Stroke{from, to, 2.2 * unit, line.paint});
        }
}

double lowest_height_energy(level::Level const& level, physics::Forces const& forces) {
    // Measured from the level's lowest corner along gravity, so that bars do not go below nothing inside the level.
    Vec2 const gravity = physics::gravity_of(level.scene, forces);
    double reach = -1e300;
    for (double const x : {0.0, level.size.x()})
        for (double const y : {0.0, level.size.y()}) reach = std::max(reach, geometry::dot(gravity, Vec2(x, y)));
    double mass = 0;
    for (physics::Ball const& ball : level.scene.balls) mass += ball.mass;
    return -mass * reach;
}

bool overlap(Panel const& a, Panel const& b) {
    Vec2 const a_end = a.corner + a.size, b_end = b.corner + b.size;
    return a.corner.x() < b_end.x() && b.corner.x() < a_end.x() && a.corner.y() < b_end.y() && b.corner.y() < a_end.y();
}

// Where the name of an arrow stands: beside its tip (pixels), clear of the shaft, so that figures and forces along one
// line do not write over each other; where another name stands already, on the other side or farther on.
Panel plate_of(Slate const& slate, Arrow const& arrow, Vec2 const& tip, Vec2 const& along) {
    double const unit = hud_scale(slate.camera->size);
    Vec2 const size((text_width(arrow.name) * 17 + 10) * unit, 20 * unit);
    auto const plate_at = [&](double side, double step) {
        Vec2 const aside = -side * geometry::turned_left(along);
        double const clear = std::abs(aside.x()) * (size.x() / 2 + 10 * unit) + std::abs(aside.y()) * 20 * unit;
        double const on = step * (std::abs(along.x()) * (size.x() + 4 * unit) + std::abs(along.y()) * 24 * unit);
        Vec2 const at = tip + clear * aside + on * along + Vec2(0, 5 * unit);
        return Panel{at - Vec2(size.x() / 2, 15 * unit), size, 6 * unit, colour(0xffffff, 0.8f)};
    };
    for (double const step : {0.0, 1.0, 2.0})
        for (double const side : {arrow.side, -arrow.side}) {
            Panel const plate = plate_at(side, step);
            auto const is_taken = [&](Panel const& other) { return overlap(plate, other); };
            if (std::none_of(slate.names.begin(), slate.names.end(), is_taken)) return plate;
        }
    return plate_at(arrow.side, 0);
}

}  // namespace

void draw_arrow(Slate& slate, Arrow const& arrow) {
    Camera const& camera = *slate.camera;
    double const unit = hud_scale(camera.size);
    Vec2 const from = pixel_of(camera, arrow.from), to = pixel_of(camera, arrow.from + arrow.way);
    double const length = geometry::length(to - from);
    if (length < 3 * unit) return;
    Vec2 const along = (to - from) / length, across = geometry::turned_left(along);
    double const head = std::min(13 * unit, 0.6 * length);
    Vec2 const neck = to - head * along;
    slate.shapes->emplace_back(Stroke{from, neck, 6 * unit, faded(palette::bright, 0.85f)});
    auto const add_head = [&](double swell, Colour const& paint) {
        Area area;
        Vec2 const back = neck - swell * along;
        area.rings = {{to + 1.6 * swell * along, back + (0.5 * head + 1.2 * swell) * across,
                       back - (0.5 * head + 1.2 * swell) * across}};
        area.paint.top = area.paint.bottom = paint;
        slate.shapes->emplace_back(std::move(area));
    };
    add_head(1.5 * unit, faded(palette::bright, 0.85f));
    slate.shapes->emplace_back(Stroke{from, neck, 3.5 * unit, arrow.paint});
    add_head(0, arrow.paint);
    if (arrow.name.empty()) return;
    Panel const plate = plate_of(slate, arrow, to, along);
    slate.names.push_back(plate);
    slate.shapes->emplace_back(plate);
    Vec2 const at = plate.corner + Vec2(plate.size.x() / 2, 15 * unit);
    slate.shapes->emplace_back(Label{at, 17 * unit, arrow.name, arrow.paint, Anchor::Centre});
}

void draw_table(Slate& slate, std::string const& title, std::vector<Row> const& rows) {
    double const unit = hud_scale(slate.camera->size);
    double const line = 22 * unit, letters = 15 * unit;
    Vec2 const corner(slate.table_left, slate.next_table);
    Vec2 const size(table_width * unit, line * static_cast<double>(rows.size()) + 40 * unit);
    slate.shapes->emplace_back(Panel{corner, size, 12 * unit, colour(0xfffdf6, 0.88f)});
    Vec2 at = corner + Vec2(14, 24) * unit;
    slate.shapes->emplace_back(Label{at, 16 * unit, title, palette::ink, Anchor::Left});
    for (Row const& row : rows) {
        at.y() += line;
        slate.shapes->emplace_back(Label{at, letters, row.name, row.paint, Anchor::Left});
        Vec2 const right(corner.x() + size.x() - 14 * unit, at.y());
        slate.shapes->emplace_back(Label{right, letters, row.value, palette::ink, Anchor::Right});
    }
    slate.next_table += size.y() + 8 * unit;
}

void draw_figures(Slate& slate, level::Level const& level, Moment const& moment) {
    auto const player = static_cast<std::size_t>(level.player);
    physics::State const& state = moment.balls[player];
    double const radius = level.scene.balls[player].radius;
    double constexpr metres = 0.3;  // of an arrow for each m/s
    double const limit = 0.3 * slate.camera->size.y() / slate.camera->scale;
    std::optional<Figures> const figures = figures_of(level, moment, level.player);
    std::vector<Row> rows = {{"v", pair_text(state.velocity) + " m/s", velocity_paint}};
    if (figures) {
        Vec2 const contact = figures->contact;
        draw_arrow(slate, {contact, 1.6 * radius * figures->normal, normal_paint, "n"});
        draw_arrow(slate, {contact, drawn_in(metres * figures->kept, limit), kept_paint, "t",
                           side_of(figures->kept, figures->normal)});
        rows.push_back({"n", pair_text(figures->normal), normal_paint});
        rows.push_back({"t = v - (v.n) n", pair_text(figures->kept) + " m/s", kept_paint});
        rows.push_back({"L = v ^ n", written(figures->length, 3) + " m/s", kept_paint});
        rows.push_back({"\xce\xb8 = L / r", written(figures->roll, 3) + " rad/s", roll_paint});
    }
    draw_arrow(slate, {state.position, drawn_in(metres * state.velocity, limit), velocity_paint, "v"});
    draw_roll(slate, state.position, radius, state.spin);
    rows.push_back({words_on(slate, Text::shown_spin), written(state.spin, 3) + " rad/s", roll_paint});
    rows.push_back({words_on(slate, Text::shown_angle), written(state.angle, 3) + " rad", roll_paint});
    draw_table(slate,
               game::words(Text::shown_figures, slate.language, {words_on(slate, text_of(moment.phases[player]))}),
               rows);
}

void draw_forces(Slate& slate, level::Level const& level, Moment const& moment) {
    auto const player = static_cast<std::size_t>(level.player);
    physics::State const& state = moment.balls[player];
    double const mass = level.scene.balls[player].mass;
    double const elapsed = std::min(force_interval, moment.time);
    Vec2 const gravity = mass * physics::gravity_of(level.scene, moment.forces);
    Vec2 drag = Vec2::Zero();
    if (moment.forces.pull && moment.forces.pull->ball == level.player) {
        double const omega = 2 * geometry::pi * level.scene.drag.frequency;
        drag = mass * (omega * omega * (moment.forces.pull->target - state.position) -
                       2 * level.scene.drag.damping * omega * state.velocity);
    }
    // What the ground does is what is missing to the change of the velocity, as it was measured.
    Vec2 const total =
        elapsed > 0 ? Vec2(mass * (state.velocity - moment.before[player].velocity) / elapsed) : Vec2(Vec2::Zero());
    std::optional<Figures> const figures = figures_of(level, moment, level.player);
    double const metres = 0.11 / std::max(mass * level.scene.gravity / 9.81, 1e-3);  // of an arrow for each newton
    double const limit = 0.3 * slate.camera->size.y() / slate.camera->scale;
    auto const arrow = [&](Vec2 const& from, Vec2 const& force, Colour const& paint, Text name, double side = -1) {
        draw_arrow(slate, {from, drawn_in(metres * force, limit), paint, words_on(slate, name), side});
    };
    auto const newtons = [](Vec2 const& force) { return written(geometry::length(force), 2) + " N"; };
    std::vector<Row> rows = {{words_on(slate, Text::shown_gravity), newtons(gravity), gravity_paint}};
    arrow(state.position, gravity, gravity_paint, Text::shown_gravity);
    if (figures && figures->touching) {
        Vec2 const ground = total - gravity - drag;
        Vec2 const normal = geometry::dot(ground, figures->normal) * figures->normal;
        Vec2 const friction = ground - normal;
        arrow(figures->contact, normal, normal_paint, Text::shown_normal);
        arrow(figures->contact, friction, kept_paint, Text::shown_friction, -side_of(friction, figures->normal));
        rows.push_back({words_on(slate, Text::shown_normal), newtons(normal), normal_paint});
        rows.push_back({words_on(slate, Text::shown_friction), newtons(friction), kept_paint});
    }
    if (moment.forces.pull) {
        arrow(state.position, drag, drag_paint, Text::shown_drag);
        rows.push_back({words_on(slate, Text::shown_drag), newtons(drag), drag_paint});
    }
    draw_table(slate, words_on(slate, Text::shown_forces), rows);
}

void draw_energy(Slate& slate, level::Level const& level, Moment const& moment) {
    Energy const energy = energy_of(level, moment.balls, moment.forces);
    double const ground = lowest_height_energy(level, moment.forces);
    auto const joules = [](double value) { return written(value, 3) + " J"; };
    draw_table(slate, words_on(slate, Text::shown_energy),
               {{words_on(slate, Text::shown_motion), joules(energy.motion), motion_paint},
                {words_on(slate, Text::shown_rotation), joules(energy.rotation), rotation_paint},
                {words_on(slate, Text::shown_height), joules(energy.height - ground), height_paint},
                {words_on(slate, Text::shown_spring), joules(energy.spring), spring_paint},
                {words_on(slate, Text::shown_total), joules(energy.total() - ground), palette::ink}});
    double highest = energy.total() - energy.spring;
    for (std::vector<physics::State> const& balls : moment.recent)
        highest = std::max(highest, energy_of(level, balls, {moment.forces.tilt, std::nullopt}).total());
    double lowest = energy.height;
    for (std::vector<physics::State> const& balls : moment.recent)
        lowest = std::min(lowest, energy_of(level, balls, {moment.forces.tilt, std::nullopt}).height);
    double const margin = 0.08 * (highest - lowest);
    if (moment.recent.size() > 1) draw_chart(slate, level, moment, lowest - margin, highest + margin);
}

}  // namespace view
