#include "hunt/sketch.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "geometry/match.h"
#include "level/level.h"

namespace hunt {

namespace {

// The shortest text that reads as the same number.
std::string text_of(double number) {
    char text[32];
    auto const end = std::to_chars(text, text + sizeof text, number == 0 ? 0 : number).ptr;  // no minus nought
    return {text, end};
}

// The viewBox ends at y = 0, so that drawing and world differ by a sign and by no rounding.
std::string drawn(Vec2 const& point) { return text_of(point.x()) + " " + text_of(-point.y()); }

std::string command_of(Stroke const& stroke) {
    return std::visit(geometry::Match{[](Line const& s) { return "L " + drawn(s.to); },
                                      [](Bow const& s) {
                                          return "A " + text_of(s.radius) + " " + text_of(s.radius) + " 0 " +
                                                 (s.large ? "1 " : "0 ") + (s.left ? "0 " : "1 ") + drawn(s.to);
                                      },
                                      [](Cubic const& s) {
                                          return "C " + drawn(s.first) + " " + drawn(s.second) + " " + drawn(s.to);
                                      },
                                      [](Quadratic const& s) { return "Q " + drawn(s.handle) + " " + drawn(s.to); },
                                      [](Disc const&) { return std::string(); }},
                      stroke);
}

std::string attributes_of(physics::Material const& material) {
    std::string const friction = std::isinf(material.friction) ? "inf" : text_of(material.friction);
    return "data-friction=\"" + friction + "\" data-restitution=\"" + text_of(material.restitution) +
           "\" data-rolling-resistance=\"" + text_of(material.rolling_resistance) + "\"";
}

std::string elements_of(Element const& element) {
    std::string discs, path;
    Vec2 const* at = nullptr;
    Vec2 end = Vec2::Zero();
    for (Stroke const& stroke : element.strokes) {
        if (auto const* disc = std::get_if<Disc>(&stroke)) {
            discs += "<circle class=\"terrain\" cx=\"" + text_of(disc->centre.x()) + "\" cy=\"" +
                     text_of(-disc->centre.y()) + "\" r=\"" + text_of(disc->radius) + "\" " +
                     attributes_of(element.material) + "/>\n";
            continue;
        }
        if (at == nullptr || end != from_of(stroke)) path += "M " + drawn(from_of(stroke)) + " ";
        path += command_of(stroke) + " ";
        end = to_of(stroke);
        at = &end;
    }
    if (path.empty()) return discs;
    path.pop_back();
    return discs + "<path class=\"terrain\" fill=\"none\" d=\"" + path + "\" " + attributes_of(element.material) +
           "/>\n";
}

}  // namespace

Vec2 from_of(Stroke const& stroke) {
    return std::visit(geometry::Match{[](Disc const& s) -> Vec2 { return s.centre + Vec2(s.radius, 0); },
                                      [](auto const& s) -> Vec2 { return s.from; }},
                      stroke);
}

Vec2 to_of(Stroke const& stroke) {
    return std::visit(geometry::Match{[](Disc const& s) -> Vec2 { return s.centre + Vec2(s.radius, 0); },
                                      [](auto const& s) -> Vec2 { return s.to; }},
                      stroke);
}

std::string svg_of(Sketch const& sketch) {
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 " + text_of(-sketch.height) + " " +
                       text_of(sketch.width) + " " + text_of(sketch.height) + "\" data-gravity=\"" +
                       text_of(sketch.gravity) + "\"";
    if (!sketch.inputs.empty())
        text += " data-drag-frequency=\"" + text_of(sketch.drag_frequency) + "\" data-drag-damping=\"" +
                text_of(sketch.drag_damping) + "\" data-drag-reach=\"" + text_of(sketch.drag_reach) + "\"";
    text += ">\n";
    for (Element const& element : sketch.elements) text += elements_of(element);
    physics::Ball const& ball = sketch.ball;
    return text + "<circle class=\"ball\" cx=\"" + text_of(ball.start.position.x()) + "\" cy=\"" +
           text_of(-ball.start.position.y()) + "\" r=\"" + text_of(ball.radius) + "\" data-inertia=\"" +
           text_of(ball.inertia) + "\" data-velocity=\"" + text_of(ball.start.velocity.x()) + " " +
           text_of(ball.start.velocity.y()) + "\" data-spin=\"" + text_of(ball.start.spin) + "\"/>\n</svg>\n";
}

level::Level level_of(Sketch const& sketch) {
    std::filesystem::path const file =
        std::filesystem::temp_directory_path() / ("smb2d-hunt-" + std::to_string(getpid()) + ".svg");
    std::ofstream(file, std::ios::binary) << svg_of(sketch);
    struct Removed {
        std::filesystem::path const& file;
        ~Removed() { std::filesystem::remove(file); }
    } const removed{file};
    return level::read_level(file.string());
}

}  // namespace hunt
