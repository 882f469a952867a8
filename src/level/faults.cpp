#include "level/faults.h"

#include <algorithm>
#include <charconv>

namespace level {

namespace {

void append_once(std::vector<Finding>& findings, Finding finding) {
    bool const again =
        !findings.empty() && findings.back().line == finding.line && findings.back().text == finding.text;
    if (!again) findings.push_back(std::move(finding));
}

}  // namespace

void Report::add(Finding finding) { append_once(findings_, std::move(finding)); }

void Report::warn_always(int line, std::string text) {
    append_once(misspellings_, {line, text, false});
    warn(line, std::move(text));
}

std::vector<Finding> Report::by_line() const {
    std::vector<Finding> sorted = findings_;
    std::stable_sort(sorted.begin(), sorted.end(), [](Finding const& a, Finding const& b) { return a.line < b.line; });
    return sorted;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string result;
    for (char const c : text.substr(0, longest)) {
        bool const control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        result += control ? ' ' : c;
    }
    if (text.size() > longest) {
        // Not in the middle of a UTF-8 sequence.
        while (!result.empty() && (result.back() & 0xc0) == 0x80) result.pop_back();
        if (!result.empty() && (result.back() & 0x80)) result.pop_back();
        result += "...";
    }
    return result.find_first_not_of(' ') == std::string::npos ? "nothing" : result;
}

std::string shown(double number) {
    char text[64];
    auto const end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, 6).ptr;
    return {text, end};
}

}  // namespace level
