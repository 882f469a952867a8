// What each element of a drawing becomes: terrain, ball, banana, goal or decoration.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "level/attributes.h"
#include "level/document.h"
#include "level/in_sight.h"
#include "level/limits.h"
#include "level/outlines.h"
#include "level/paints.h"
#include "level/reading.h"
#include "level/style.h"
#include "level/transform.h"

namespace level {

// Whether an element stands in the drawing, is what a use refers to, or stands within that.
enum class Copy { none, itself, within };

// What an element has from itself and all that holds it.
struct Context {
    Affine to_world;
    Inherited inherited;
    Style style;
    std::optional<Role> role;            // of the nearest group that has one
    bool grass = false;                  // terrain is asked to be grass and soil, however it is painted
    ReferenceBox viewport;               // what per cent are of
    std::shared_ptr<Sight const> sight;  // what nested svg elements leave in sight; none: all
    Copy copy = Copy::none;
    std::string_view id;  // of a copy, that of its use
};

class Elements {
public:
    Elements(Document const& document, Reading& reading, Styles& styles)
        : document_(document), reading_(reading), paints_(document.root(), styles) {}

    // Faults of a group's, or the root's, own attributes.
    void inspect_group(pugi::xml_node node, std::string_view tag, Style const& style);

    // Adds what the element is to the level, or its faults to the report.
    void read(pugi::xml_node node, std::string_view tag, Context const& context);

    // The role that a group's class gives to what it holds.
    std::optional<Role> role_of_group(pugi::xml_node node) const;

    // What transform-origin is measured from, by transform-box. Throws Broken.
    ReferenceBox reference_box(pugi::xml_node node, std::string_view tag, std::string_view box,
                               Context const& context) const;

    // How findings name an element: by its role, else by its tag.
    std::string label(pugi::xml_node node, std::string_view tag) const;

    bool is_overfull() const { return pieces_met_ > most_pieces; }  // no terrain is to be made of what was read
    bool met_gradients() const { return paints_.met_gradients(); }
    int balls_met() const { return balls_met_; }                  // sound or not
    std::vector<int> const& players() const { return players_; }  // balls with the id player
    std::vector<int> const& copied_players() const { return copied_players_; }
    std::vector<physics::Piece> take_pieces() { return std::move(pieces_); }  // none are left

private:
    struct Element {
        pugi::xml_node node;
        std::string_view tag;
        Context const& context;
        int line = 0;
        std::string label;
        std::optional<Role> role;
    };

    void inspect_name(pugi::xml_node node, std::string const& name);
    void inspect_look(Element const& element);
    void inspect_class(pugi::xml_node node, std::string const& name);
    void inspect_data(Element const& element, Role role);
    void read_role(Element const& element, Role role);
    void read_terrain(Element const& element);
    std::vector<Decoration> painted(Element const& element, std::vector<Outline> const& outlines, Style const& style);
    void paint_terrain(Element const& element, std::vector<Outline>& outlines);
    void read_ball(Element const& element);
    void read_banana(Element const& element);
    void read_goal(Element const& element);
    void read_decoration(Element const& element);

    physics::DiscRegion disc(Element const& element) const;
    double number(Element const& element, Data data, double otherwise);
    Vec2 velocity(Element const& element);
    double tolerance(Element const& element);
    Traced traced_within_limits(Element const& element, Shape const& shape);
    void add_sensor(Element const& element, physics::Sensor sensor, Meaning meaning);
    void fault(Element const& element, std::string const& what) {
        reading_.report.fault(element.line, element.label + ": " + what);
    }
    void fault_of_place(Element const& element, TooFar const& far);
    void warn(Element const& element, std::string const& what) {
        reading_.report.warn(element.line, element.label + ": " + what);
    }

    Document const& document_;
    Reading& reading_;
    Paints paints_;
    std::vector<physics::Piece> pieces_;
    std::vector<int> players_, copied_players_;
    std::size_t pieces_met_ = 0, goal_corners_met_ = 0;
    int balls_met_ = 0, sensor_elements_ = 0;
    bool grass_met_ = false;  // terrain that the drawing does not paint itself
};

}  // namespace level
