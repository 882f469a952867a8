#include "level/document.h"

#include <algorithm>
#include <span>
#include <vector>

#include "level/encoding.h"
#include "level/hash.h"
#include "level/namespaces.h"
#include "level/numbers.h"
#include "level/roles.h"
#include "level/scan.h"

namespace level {

namespace {

// pugixml speaks in sentences with a capital letter.
std::string reason(pugi::xml_parse_result const& result) {
    std::string text = result.description();
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return text;
}

}  // namespace

Document::Document(std::string const& file, Report& report) {
    std::string bytes = bytes_of(file);
    if (bytes.size() > largest_file) {
        report.fault(1, "svg: the file must have at most 64 MB, got more");
        return;
    }
    hash_ = fnv1a_hex(std::as_bytes(std::span<char const>(bytes.data(), bytes.size())));
    Decoded text;
    try {
        text = decoded(unpacked(std::move(bytes)));
    } catch (Broken const& broken) {
        report.fault(1, broken.what());
        return;
    }
    text_ = std::move(text.text);
    lines_ = Lines(text_);
    if (text_.size() > largest_file) {
        report.fault(1, "svg: the file must unpack to at most 64 MB, got more");
        return;
    }
    if (!text.wrong.empty()) {
        report.fault(lines_.line_at(static_cast<std::ptrdiff_t>(text_.size())), "not XML: " + text.wrong);
        return;
    }
    if (auto const objection = objection_to(text_)) {
        report.fault(lines_.line_at(objection->offset), objection->what);
        return;
    }
    parse(report);
}

void Document::parse(Report& report) {
    // In place: the scan is done with the text, and the lines are known.
    pugi::xml_parse_result const result = tree_.load_buffer_inplace(
        text_.data(), text_.size(), pugi::parse_default | pugi::parse_pi, pugi::encoding_utf8);
    if (!result) {
        report.fault(lines_.line_at(result.offset), "not XML: " + reason(result));
        return;
    }
    root_ = tree_.document_element();
    Namespace const own = namespace_of_root(root_);
    std::string_view const name = root_.name();
    bool const is_svg = name.substr(name.find(':') + 1) == "svg";
    if (!is_svg || own == Namespace::other) {
        std::string const what =
            is_svg ? ": the root element is of a namespace that is not SVG's" : ": the root element must be svg";
        report.fault(line_of(root_), quoted(name) + what);
        root_ = {};
        return;
    }
    if (own == Namespace::none)
        report.warn(line_of(root_), "svg: without xmlns=\"http://www.w3.org/2000/svg\" browsers show nothing");
    report_stylesheets(report);
    report_doubled_attributes(report);
    for (Foreign const& foreign : without_foreign(root_))
        if (!roles_in(foreign.classes).empty())
            report.warn(lines_.line_at(foreign.offset),
                        quoted(foreign.name) + ": is of another namespace and counts for nothing");
}

std::string_view Document::reference_of(pugi::xml_node node) {
    std::string_view reference;
    for (pugi::xml_attribute const attribute : node.attributes()) {
        std::string_view const name = attribute.name();
        if (name == "href") return trimmed(attribute.value());
        if (name.ends_with(":href")) reference = trimmed(attribute.value());
    }
    return reference;
}

// Rules that browsers would fetch.
void Document::report_stylesheets(Report& report) const {
    for (pugi::xml_node const node : tree_.children())
        if (node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet")
            report.warn(line_of(node),
                        "xml-stylesheet: is ignored: nothing is fetched; put its rules into a style element");
}

void Document::report_doubled_attributes(Report& report) const {
    std::vector<std::string_view> names;
    for (pugi::xml_node node = root_; node; node = next_within(node, root_)) {
        names.clear();
        for (pugi::xml_attribute const attribute : node.attributes()) names.push_back(attribute.name());
        std::sort(names.begin(), names.end());
        auto const twice = std::adjacent_find(names.begin(), names.end());
        if (twice != names.end())
            report.fault(line_of(node), "not XML: the attribute " + quoted(*twice) + " stands twice in " + node.name());
    }
}

pugi::xml_node next_within(pugi::xml_node node, pugi::xml_node top) {
    if (node.first_child()) return node.first_child();
    while (node && node != top && !node.next_sibling()) node = node.parent();
    return node == top ? pugi::xml_node() : node.next_sibling();
}

}  // namespace level
