#include "level/frame.h"

#include <cmath>
#include <filesystem>

#include "level/colours.h"
#include "level/limits.h"
#include "level/numbers.h"

namespace level {

namespace {

struct ViewBox {
    double x = 0, y = 0, width = 0, height = 0;
};

double plain_size(pugi::xml_node root, char const* attribute) {
    std::string_view const text = root.attribute(attribute).value();
    Parsed const parsed = parsed_number(text);
    if (parsed.syntax != Syntax::good || !(parsed.value > 0))
        throw Broken(std::string("without a viewBox, ") + attribute + " must be a plain number greater than 0, got " +
                     quoted(trimmed(text)));
    return parsed.value;
}

ViewBox view_box_of(pugi::xml_node root) {
    pugi::xml_attribute const given = root.attribute("viewBox");
    if (!given) {
        bool const sized = root.attribute("width") && root.attribute("height");
        if (!sized) throw Broken("there must be a viewBox, or width and height in plain numbers");
        return {0, 0, plain_size(root, "width"), plain_size(root, "height")};
    }
    auto const numbers = parsed_list(given.value());
    if (!numbers || numbers->size() != 4)
        throw Broken("viewBox must be four finite numbers, got " + quoted(given.value()));
    ViewBox const box{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
    if (!(box.width > 0 && box.height > 0))
        throw Broken("viewBox must have a width and height greater than 0, got " + quoted(given.value()));
    return box;
}

std::optional<double> setting(Document const& document, Data data, Report& report) {
    pugi::xml_attribute const given = document.root().attribute(name_of(data));
    if (!given) return std::nullopt;
    try {
        return number_in(data, given.value(), Grip::finite);
    } catch (Broken const& broken) {
        report.fault(document.line_of(document.root()), std::string("svg: ") + broken.what());
        return std::nullopt;
    }
}

// The words of the root's first child of that name, a space between them.
std::string text_of_child(Document const& document, std::string_view tag) {
    for (pugi::xml_node const child : document.root().children()) {
        if (document.tag_of(child) != tag) continue;
        std::string whole;
        for (pugi::xml_node const text : child.children()) whole += text.value();
        std::string joined;
        for (std::string_view const word : words_of(whole)) {
            if (!joined.empty()) joined += ' ';
            joined += word;
        }
        return joined;
    }
    return {};
}

// So many colours between spaces; nothing, and a fault, where the attribute says anything else.
std::vector<std::string> colours_of(Document const& document, LookAttribute const& wanted, Report& report) {
    std::vector<std::string> colours;
    pugi::xml_attribute const given = document.root().attribute(wanted.name);
    if (!given) return colours;
    try {
        for (std::string_view const word : words_of(given.value())) {
            auto const colour = colour_in(word);
            colours.push_back(colour ? hexadecimal_of(*colour) : std::string(no_colour));
        }
    } catch (Unsupported const&) {
        colours.clear();
    }
    if (colours.size() == wanted.colours) return colours;
    report.fault(document.line_of(document.root()),
                 std::string("svg: ") + wanted.name + " must be " + std::to_string(wanted.colours) +
                     (wanted.colours == 1 ? " colour" : " colours") + ", got " + quoted(trimmed(given.value())));
    return {};
}

Look look_of(Document const& document, Report& report) {
    auto const one = [&](LookAttribute const& attribute) {
        auto const colours = colours_of(document, attribute, report);
        return colours.empty() ? std::string() : colours[0];
    };
    Look look;
    look.sky = colours_of(document, sky_attribute, report);
    look.hills = colours_of(document, hills_attribute, report);
    look.sun = one(sun_attribute);
    look.clouds = one(clouds_attribute);
    return look;
}

}  // namespace

std::optional<Frame> frame_of(Document const& document, Report& report) {
    // Its own fault, if any; the frame then is that of a drawing in metres.
    double const metres = setting(document, Data::metres_per_unit, report).value_or(1);
    try {
        ViewBox const box = view_box_of(document.root());
        Frame const frame{{metres, 0, 0, -metres, -box.x * metres, (box.y + box.height) * metres},
                          Vec2(box.width, box.height) * metres,
                          {Vec2::Zero(), {box.width, box.height}}};
        for (double const extent : {frame.size.x(), frame.size.y(), frame.to_world.e, frame.to_world.f})
            if (!(std::abs(extent) <= most_metres))
                throw Broken("the viewBox must lie within 1e6 m, got " + shown(extent));
        return frame;
    } catch (Broken const& broken) {
        report.fault(document.line_of(document.root()), std::string("svg: ") + broken.what());
        return std::nullopt;
    }
}

void read_settings(Document const& document, Reading& reading) {
    Level& level = reading.level;
    auto const given = [&](Data data) { return setting(document, data, reading.report); };
    level.scene.gravity = given(Data::gravity).value_or(level.scene.gravity);
    level.scene.drag.frequency = given(Data::drag_frequency).value_or(level.scene.drag.frequency);
    level.scene.drag.damping = given(Data::drag_damping).value_or(level.scene.drag.damping);
    level.drag_reach = given(Data::drag_reach).value_or(level.drag_reach);
    level.tilt_limit = given(Data::tilt_limit).value_or(level.tilt_limit);
    level.time_limit = given(Data::time_limit);
    level.pars.time = given(Data::par_time);
    if (auto const pulls = given(Data::pulls)) level.pars.pulls = static_cast<int>(*pulls);
    level.look = look_of(document, reading.report);
    level.hint = text_of_child(document, "desc");
    level.title = text_of_child(document, "title");
    if (level.title.empty()) level.title = std::filesystem::path(level.file).stem().string();
}

}  // namespace level
