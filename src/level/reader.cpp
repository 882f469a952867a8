#include "level/reading.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "level/attributes.h"
#include "level/document.h"
#include "level/element_reader.h"
#include "level/frame.h"
#include "level/starts.h"

namespace level {

namespace {

bool is_group(std::string_view tag) { return tag == "g" || tag == "a"; }

// What browsers never draw where it stands.
bool is_definition(std::string_view tag) {
    return tag == "defs" || tag == "symbol" || tag == "clipPath" || tag == "mask" || tag == "marker" ||
           tag == "pattern" || tag == "linearGradient" || tag == "radialGradient" || tag == "filter" ||
           tag == "title" || tag == "desc" || tag == "metadata";
}

// Walks over the drawing without recursion: groups may be nested as deeply as a file allows.
class Walk {
public:
    Walk(Document const& document, Frame const& frame, Reading& reading)
        : document_(document), reading_(reading), elements_(document, reading) {
        pugi::xml_node const root = document.root();
        Style const style = style_of(root, Style{});
        if (style.hidden) return;
        elements_.inspect_group(root, "svg");
        above_.push_back({frame.to_world, inherited_by(root, Inherited{}), style});
        walk(root);
    }

    Elements const& elements() const { return elements_; }

private:
    void walk(pugi::xml_node root) {
        pugi::xml_node node = root.first_child();
        while (node) {
            if (enter(node)) {
                node = node.first_child();
                continue;
            }
            while (!node.next_sibling()) {
                node = node.parent();
                if (node == root) return;
                above_.pop_back();
            }
            node = node.next_sibling();
        }
    }

    // Whether the children are to be looked at; their context then lies on top.
    bool enter(pugi::xml_node node) {
        std::string_view const tag = document_.tag_of(node);
        if (tag.empty() || is_definition(tag)) return false;
        Context context = above_.back();
        context.style = style_of(node, context.style);
        if (context.style.hidden) return false;
        context.inherited = inherited_by(node, context.inherited);
        context.to_world = composed(context.to_world, transform_of(node, tag));
        if (!is_group(tag)) {
            elements_.read(node, tag, context);
            return false;
        }
        elements_.inspect_group(node, tag);
        if (!node.first_child()) return false;
        above_.push_back(std::move(context));
        return true;
    }

    Affine transform_of(pugi::xml_node node, std::string_view tag) {
        try {
            return parsed_transform(node.attribute("transform").value());
        } catch (Broken const& broken) {
            reading_.report.fault(document_.line_of(node),
                                  elements_.label(node, tag) + ": transform: " + broken.what());
            reading_.in_place = false;
            return {};
        }
    }

    Document const& document_;
    Reading& reading_;
    Elements elements_;
    std::vector<Context> above_;
};

// Every failure is one line: a class that was perhaps meant to be the ball is told in it.
std::string hint_of_misspelt_ball(Report const& report) {
    for (Finding const& finding : report.misspellings())
        if (finding.text.ends_with(std::string(" ") + name_of(Role::ball)))
            return "; line " + std::to_string(finding.line) + ": " + finding.text;
    return {};
}

void choose_player(Reading& reading, Elements const& elements, int root_line) {
    if (elements.balls_met() == 0)
        reading.report.fault(root_line, "svg: there must be a ball" + hint_of_misspelt_ball(reading.report));
    std::vector<int> const& named = elements.players();
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
    read_settings(document, reading);
    Walk walk(document, frame.value_or(Frame{}), reading);
    choose_player(reading, walk.elements(), document.line_of(document.root()));
    add_fall(reading.level);
    reading.level.scene.terrain = physics::terrain_of(walk.elements().pieces());
    if (reading.in_place) settle_starts(reading);
    return reading;
}

}  // namespace level
