#include "level/element_reader.h"

#include "level/numbers.h"

// What check says of an element's attributes, whatever becomes of it.
namespace level {

namespace {

std::string no_effect_of(Style const& style) {
    return "the style property " + std::string(style.ignored) + " has no effect; make it an attribute";
}

bool is_data(std::string_view name) { return name.substr(0, 5) == "data-"; }

}  // namespace

void Elements::inspect_class(pugi::xml_node node, std::string const& name) {
    for (std::string_view const word : words_of(node.attribute("class").value()))
        if (auto const role = near_miss(word)) {
            std::string const wanted = name_of(*role);
            bool const in_capitals = same_word(word, wanted) && word.substr(1) != wanted.substr(1);
            reading_.report.warn_always(
                document_.line_of(node),
                name + ": class " + quoted(word) +
                    (in_capitals ? " gives no role, in small letters it is " : " is a letter away from ") + wanted);
        }
}

// A role typed where it has no effect, with the way to where it has one.
void Elements::inspect_name(pugi::xml_node node, std::string const& name) {
    if (!roles_in(node.attribute("class").value()).empty()) return;
    struct Named {
        char const* what;
        std::string_view text;
    };
    Named const names[] = {{"id", node.attribute("id").value()},
                           {"label", node.attribute("inkscape:label").value()},
                           {"title", node.child("title").child_value()}};
    for (Named const& given : names)
        if (auto const role = role_meant_by(given.text))
            return reading_.report.warn(document_.line_of(node), name + ": the " + given.what + " " +
                                                                     quoted(given.text) +
                                                                     " gives no role; set its attribute class to " +
                                                                     name_of(*role) + " (Inkscape: Edit > XML Editor)");
}

void Elements::inspect_group(pugi::xml_node node, std::string_view tag, Style const& style) {
    int const line = document_.line_of(node);
    std::string const name(tag);
    if (!style.ignored.empty()) reading_.report.warn(line, name + ": " + no_effect_of(style));
    inspect_class(node, name);
    auto const roles = roles_in(node.attribute("class").value());
    bool const is_root = node == document_.root();
    if (is_root && !roles.empty()) reading_.report.fault(line, name + ": cannot be " + name_of(roles[0]));
    if (roles.size() > 1)
        reading_.report.fault(
            line, name + ": has two roles, " + name_of(roles[0]) + " and " + name_of(roles[1]) + "; keep one of them");
    if (!is_root) inspect_name(node, name);
    for (pugi::xml_attribute const attribute : node.attributes()) {
        if (!is_data(attribute.name())) continue;
        if (is_root && names_look(attribute.name())) continue;
        auto const data = data_named(attribute.name());
        bool const known = data && (is_root || static_cast<std::size_t>(*data) < inherited_data);
        if (!known) {
            reading_.report.warn(line, name + ": unknown attribute " + quoted(attribute.name()));
            continue;
        }
        if (static_cast<std::size_t>(*data) >= inherited_data) continue;
        try {
            if (*data == Data::velocity)
                velocity_in(attribute.value());
            else
                number_in(*data, attribute.value(), Grip::may_be_full);
        } catch (Broken const& broken) {
            reading_.report.fault(line, name + ": " + broken.what());
        }
    }
}

// What changes the picture in a browser and not what balls touch.
void Elements::inspect_look(Element const& element) {
    Style const& style = element.context.style;
    if (!same_word(style.visibility, "visible") || style.opacity <= 0)
        warn(element, "is hidden and takes part all the same");
    if (style.clipped) warn(element, "a clip path or mask has no effect on it: it counts whole");
    if (!style.ignored.empty()) warn(element, no_effect_of(style));
    for (char const* const radius : {"rx", "ry"})
        if (same_word(trimmed(element.node.attribute(radius).value()), "auto"))
            warn(element, std::string(radius) + ": some browsers take auto as 0; leave it out, which means the same");
    for (pugi::xml_node const child : element.node.children()) {
        std::string_view const name = Document::tag_of(child);
        if (name == "set" || name.substr(0, 7) == "animate") warn(element, quoted(name) + " has no effect on it");
    }
}

void Elements::inspect_data(Element const& element, Role role) {
    for (pugi::xml_attribute const attribute : element.node.attributes()) {
        std::string_view const name = attribute.name();
        if (!is_data(name)) continue;
        auto const data = data_named(name);
        if (!data)
            warn(element, "unknown attribute " + quoted(name));
        else if (!belongs_to(*data, role))
            warn(element, quoted(name) + " has no effect here");
    }
}

}  // namespace level
