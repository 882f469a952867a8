// Which elements of a drawing are SVG, by the namespaces that prefixes stand for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <pugixml.hpp>

namespace level {

enum class Namespace { svg, none, other };

// Of the root itself, none meaning that it names no namespace at all.
Namespace namespace_of_root(pugi::xml_node root);

// A foreign element that bears a class: somebody may have meant it.
struct Foreign {
    std::ptrdiff_t offset = 0;  // in the text
    std::string name;
    std::string classes;
};

// Leaves in the tree what is of the root's namespace, by names without prefixes. A root without one is taken for SVG.
std::vector<Foreign> without_foreign(pugi::xml_node root);

}  // namespace level
