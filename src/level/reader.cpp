#include "level/reading.h"

#include <optional>

#include "level/document.h"
#include "level/frame.h"
#include "level/starts.h"
#include "level/walk.h"

namespace level {

namespace {

// Every failure is one line: a class that was perhaps meant to be the ball is told in it.
std::string hint_of_misspelt_ball(Report const& report) {
    for (Finding const& finding : report.misspellings())
        if (finding.text.ends_with(std::string(" ") + name_of(Role::ball)))
            return "; line " + std::to_string(finding.line) + ": " + finding.text;
    return "; give a circle the class ball";
}

void choose_player(Reading& reading, Elements const& elements, int root_line) {
    if (elements.balls_met() == 0)
        reading.report.fault(root_line, "svg: there must be a ball" + hint_of_misspelt_ball(reading.report));
    // Copies of the player's ball are balls, and the player only where the ball itself is a definition.
    std::vector<int> const& named = elements.players().empty() ? elements.copied_players() : elements.players();
    for (std::size_t i = 1; i < named.size(); ++i)
        reading.report.fault(reading.ball_lines[named[i]], "ball: a second ball with the id player");
    if (!named.empty()) reading.level.player = named[0];
    for (std::size_t i = 0; i < reading.level.meanings.size(); ++i)
        if (reading.level.meanings[i] == Meaning::goal) reading.level.scene.sensors[i].ball = reading.level.player;
}

// A ball is lost when its centre leaves the viewBox grown by half its width and height on every side.
void add_fall(Level& level) {
    Vec2 const low = -level.size / 2, high = level.size * 1.5;
    physics::Sensor sensor;
    sensor.region = physics::PolygonRegion{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
    sensor.outside = true;
    sensor.each_ball = true;
    level.scene.sensors.push_back(sensor);
    level.meanings.push_back(Meaning::fall);
    level.sensor_elements.push_back(-1);
}

std::string overlap_in_words(Overlap const& overlap) {
    std::string const whom = overlap.other < 0 ? "terrain" : "ball " + std::to_string(overlap.other);
    return "overlaps " + whom + " by " + shown(overlap.depth) + " m";
}

void settle_starts(Reading& reading) {
    physics::Scene& scene = reading.level.scene;
    auto const overlaps = overlaps_in(scene);
    bool all_slight = true;
    for (Overlap const& overlap : overlaps) {
        std::string const what = "ball: " + overlap_in_words(overlap);
        int const line = reading.ball_lines[overlap.ball];
        if (overlap.slight) {
            reading.report.warn(line, what + " and is moved out");
        } else {
            reading.report.fault(line, what + ", more than 5 % of its radius");
        }
        all_slight = all_slight && overlap.slight;
    }
    if (!all_slight || overlaps.empty()) return;
    scene.balls = moved_out(scene, overlaps);
    for (Overlap const& left : overlaps_in(scene))
        reading.report.fault(reading.ball_lines[left.ball],
                             "ball: does not fit between what it touches: moved out, it " + overlap_in_words(left));
}

std::string and_more(std::size_t count) { return count > 1 ? ", and " + std::to_string(count - 1) + " more" : ""; }

void remark(Level& level, int line, std::string text) { level.remarks.push_back({line, std::move(text), false}); }

// What balls touch is the middle of a stroke: a wide one looks as if they sank into it.
void remark_on_strokes(Reading& reading) {
    constexpr double widest = 0.02;  // of the ball's diameter
    if (reading.ball_lines.empty()) return;
    Level& level = reading.level;
    double const across = 2 * level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    Surface const* first = nullptr;
    std::size_t wide = 0;
    for (Surface const& surface : reading.surfaces) {
        if (surface.stroke_width <= widest * across) continue;
        if (++wide == 1) first = &surface;
    }
    if (wide == 0) return;
    remark(level, first->line,
           "terrain: a stroke of " + shown(first->stroke_width) +
               " m is wider than 2 % of the ball, which touches its middle" + and_more(wide));
}

void remark_on_look(Reading& reading, Document const& document, Walk const& walk) {
    if (walk.elements().met_gradients())
        remark(reading.level, document.line_of(document.root()), "svg: gradients are shown as their mean colour");
    for (Undrawn const& undrawn : walk.undrawn()) {
        remark(reading.level, document.line_of(undrawn.first),
               std::string(Document::tag_of(undrawn.first)).append(": ").append(undrawn.property) + " is not drawn" +
                   and_more(static_cast<std::size_t>(undrawn.elements)));
    }
}

}  // namespace

Reading reading_of(std::string const& file) {
    Reading reading;
    reading.level.file = file;
    Document const document(file, reading.report);
    reading.level.hash = document.hash();
    if (!document.root()) {
        reading.in_place = false;
        return reading;
    }
    auto const frame = frame_of(document, reading.report);
    reading.in_place = frame.has_value();
    reading.level.size = frame.value_or(Frame{}).size;
    reading.level.metres_per_unit = scale_of(frame.value_or(Frame{}).to_world);
    read_settings(document, reading);
    Walk walk(document, frame.value_or(Frame{}), reading);
    choose_player(reading, walk.elements(), document.line_of(document.root()));
    add_fall(reading.level);
    if (walk.elements().is_overfull()) reading.in_place = false;
    if (reading.in_place) reading.level.scene.terrain = physics::terrain_of(walk.take_pieces());
    if (reading.in_place) settle_starts(reading);
    remark_on_strokes(reading);
    remark_on_look(reading, document, walk);
    return reading;
}

}  // namespace level
