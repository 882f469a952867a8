#include "level/document.h"

#include <algorithm>
#include <span>
#include <vector>

#include "level/hash.h"
#include "level/scan.h"

namespace level {

namespace {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

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
    text_ = utf8_of(std::move(bytes));
    lines_ = Lines(text_);
    if (auto const objection = objection_to(text_)) {
        report.fault(lines_.line_at(objection->offset), objection->what);
        return;
    }
    parse(report);
}

void Document::parse(Report& report) {
    // In place: the scan is done with the text, and the lines are known.
    pugi::xml_parse_result const result =
        tree_.load_buffer_inplace(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
        report.fault(lines_.line_at(result.offset), "not XML: " + reason(result));
        return;
    }
    root_ = tree_.document_element();
    find_prefix();
    report_doubled_attributes(report);
    if (tag_of(root_) == "svg") return;
    report.fault(line_of(root_), quoted(root_.name()) + ": the root element must be svg");
    root_ = {};
}

void Document::find_prefix() {
    for (pugi::xml_attribute const attribute : root_.attributes()) {
        std::string_view const name = attribute.name();
        if (name.substr(0, 6) == "xmlns:" && attribute.value() == svg_namespace)
            prefix_ = std::string(name.substr(6)) + ":";
    }
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

std::string_view Document::tag_of(pugi::xml_node node) const {
    if (node.type() != pugi::node_element) return {};
    std::string_view const name = node.name();
    if (name.find(':') == std::string_view::npos) return name;
    if (!prefix_.empty() && name.substr(0, prefix_.size()) == prefix_) return name.substr(prefix_.size());
    return {};
}

pugi::xml_node next_within(pugi::xml_node node, pugi::xml_node top) {
    if (node.first_child()) return node.first_child();
    while (node && node != top && !node.next_sibling()) node = node.parent();
    return node == top ? pugi::xml_node() : node.next_sibling();
}

}  // namespace level
