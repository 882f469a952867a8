// A level file as a tree of elements, with the line that each stands on.
#pragma once

#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "level/faults.h"
#include "level/source.h"

namespace level {

class Document {
public:
    // Reports what makes the file no level at all; root() is then empty. Throws std::runtime_error where the file
    // cannot be opened.
    Document(std::string const& file, Report& report);

    pugi::xml_node root() const { return root_; }
    std::string const& hash() const { return hash_; }
    int line_of(pugi::xml_node node) const { return lines_.line_at(node.offset_debug()); }

    // The name without its prefix; empty for text and comments. Elements of other namespaces are not in the tree.
    static std::string_view tag_of(pugi::xml_node node) {
        return node.type() == pugi::node_element ? std::string_view(node.name()) : std::string_view();
    }

    // The href of a use or gradient, plain or of XLink's namespace, however that is prefixed.
    static std::string_view reference_of(pugi::xml_node node);

private:
    void parse(Report& report);
    void report_stylesheets(Report& report) const;
    void report_doubled_attributes(Report& report) const;

    std::string hash_;
    std::string text_;
    Lines lines_{std::string()};
    pugi::xml_document tree_;
    pugi::xml_node root_;
};

// The next element in the order of the file, below `top` alone; empty at the end.
pugi::xml_node next_within(pugi::xml_node node, pugi::xml_node top);

}  // namespace level
