// What each element of a drawing becomes: terrain, ball, banana, goal or decoration.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/attributes.h"
#include "level/document.h"
#include "level/reading.h"
#include "level/style.h"
#include "level/transform.h"

namespace level {

// What an element has from itself and all that holds it.
struct Context {
    Affine to_world;
    Inherited inherited;
    Style style;
};

class Elements {
public:
    Elements(Document const& document, Reading& reading) : document_(document), reading_(reading) {}

    // Faults of a group's, or the root's, own attributes.
    void inspect_group(pugi::xml_node node, std::string_view tag);

    // Adds what the element is to the level, or its faults to the report.
    void read(pugi::xml_node node, std::string_view tag, Context const& context);

    // How findings name an element: by its role, else by its tag.
    std::string label(pugi::xml_node node, std::string_view tag) const;

    int balls_met() const { return balls_met_; }                  // sound or not
    std::vector<int> const& players() const { return players_; }  // balls with the id player
    std::vector<physics::Piece> const& pieces() const { return pieces_; }

private:
    struct Element {
        pugi::xml_node node;
        std::string_view tag;
        Context const& context;
        int line = 0;
        std::string label;
        std::optional<Role> role;
    };

    void inspect_class(pugi::xml_node node, std::string const& name);
    void inspect_data(Element const& element, Role role);
    void read_role(Element const& element, Role role);
    void read_terrain(Element const& element);
    void read_ball(Element const& element);
    void read_banana(Element const& element);
    void read_goal(Element const& element);
    void read_decoration(Element const& element);

    physics::DiscRegion disc_of(Element const& element) const;
    std::optional<physics::Region> goal_region(Element const& element);
    double number(Element const& element, Data data, double otherwise);
    Vec2 velocity(Element const& element);
    double tolerance(Element const& element);
    void add_sensor(physics::Sensor sensor, Meaning meaning, int line);
    void fault(Element const& element, std::string const& what) {
        reading_.report.fault(element.line, element.label + ": " + what);
    }
    void fault_of_place(Element const& element, TooFar const& far);
    void warn(Element const& element, std::string const& what) {
        reading_.report.warn(element.line, element.label + ": " + what);
    }

    Document const& document_;
    Reading& reading_;
    std::vector<physics::Piece> pieces_;
    std::vector<int> players_;
    int balls_met_ = 0;
};

}  // namespace level
