#include "level/css.h"

#include <algorithm>
#include <unordered_set>

#include "level/faults.h"
#include "level/numbers.h"
#include "level/style.h"

namespace level {

namespace {

constexpr auto not_found = std::string_view::npos;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

// The end of the string that begins at `at` with a quote.
std::size_t end_of_string(std::string_view css, std::size_t at) {
    char const quote = css[at];
    for (++at; at < css.size() && css[at] != quote; ++at)
        if (css[at] == '\\') ++at;
    return std::min(at, css.size());
}

// The first of `marks` that stands outside of strings, brackets and escapes, or the end.
std::size_t find_outside(std::string_view css, std::string_view marks, std::size_t at) {
    int depth = 0;
    for (; at < css.size(); ++at) {
        char const c = css[at];
        if (depth == 0 && marks.find(c) != not_found) return at;
        if (c == '\\') ++at;
        if (c == '"' || c == '\'') at = end_of_string(css, at);
        if (c == '(' || c == '[' || c == '{') ++depth;
        if ((c == ')' || c == ']' || c == '}') && depth > 0) --depth;
    }
    return css.size();
}

std::size_t find_escape(std::string_view css) {
    for (std::size_t at = 0; at < css.size(); ++at) {
        if (css[at] == '\\') return at;
        if (css[at] == '"' || css[at] == '\'') at = end_of_string(css, at);
    }
    return css.size();
}

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || (c & 0x80);
    });
}

bool is_simple(std::string_view selector) {
    if (selector == "*") return true;
    bool const marked = !selector.empty() && (selector[0] == '.' || selector[0] == '#');
    return is_name(selector.substr(marked ? 1 : 0));
}

// No effect on what is shown, or none that a single selector has.
bool is_harmless(std::string_view at_rule) {
    return at_rule.substr(0, 8) == "@charset" || at_rule.substr(0, 10) == "@font-face" ||
           at_rule.substr(0, 10) == "@namespace" || at_rule.substr(0, 5) == "@page";
}

// The names of the CSS Compatibility Standard, section 2.3, that browsers read as those without the prefix.
std::string_view without_prefix(std::string_view name) {
    constexpr std::string_view prefix = "-webkit-";
    constexpr std::string_view prefixed[] = {"transform",  "transform-origin", "clip-path", "mask",
                                             "mask-image", "opacity",          "filter"};
    if (!same_word(name.substr(0, prefix.size()), prefix)) return name;
    std::string_view const rest = name.substr(prefix.size());
    bool const is_known = std::any_of(std::begin(prefixed), std::end(prefixed),
                                      [&](std::string_view known) { return same_word(rest, known); });
    return is_known ? rest : name;
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

bool is_for_screens(std::string_view media) {
    for (std::size_t at = 0; at < media.size();) {
        std::size_t const end = std::min(media.find(',', at), media.size());
        std::string_view const one = trimmed(media.substr(at, end - at));
        if (same_word(one, "all") || same_word(one, "screen")) return true;
        at = end + 1;
    }
    return false;
}

bool has_comment(std::string_view css) { return css.find("/*") != not_found; }

std::string without_comments(std::string_view css) {
    std::string text;
    for (std::size_t at = 0; at < css.size();) {
        if (css.substr(at, 2) == "/*") {
            std::size_t const end = css.find("*/", at + 2);
            text += ' ';
            at = end == not_found ? css.size() : end + 2;
            continue;
        }
        std::size_t const end = css[at] == '"' || css[at] == '\'' ? end_of_string(css, at) + 1 : at + 1;
        text += css.substr(at, end - at);
        at = end;
    }
    return text;
}

std::vector<Declaration> declarations_in(std::string_view css) {
    std::vector<Declaration> declarations;
    for (std::size_t at = 0; at < css.size();) {
        std::size_t const end = find_outside(css, ";", at);
        std::string_view const text = css.substr(at, end - at);
        at = end + 1;
        std::size_t const colon = text.find(':');
        if (colon == not_found) continue;
        std::string_view value = trimmed(text.substr(colon + 1));
        std::size_t const mark = find_outside(value, "!", 0);
        bool const important = mark < value.size() && same_word(trimmed(value.substr(mark + 1)), "important");
        if (mark < value.size() && !important) continue;
        declarations.push_back(
            {without_prefix(trimmed(text.substr(0, colon))), trimmed(value.substr(0, mark)), important});
    }
    return declarations;
}

std::vector<std::string> Sheet::add(std::string text) {
    std::string_view const css = texts_.emplace_back(without_comments(text));
    std::vector<std::string> ignored;
    if (auto const escape = find_escape(css); escape < css.size())
        ignored.push_back("an escape, " + quoted(css.substr(escape)) + ",");
    int open_media = 0;
    for (std::size_t at = 0; at < css.size();) {
        at = std::min(css.find_first_not_of(" \t\r\n\f", at), css.size());
        if (open_media > 0 && css.substr(at, 1) == "}") {
            --open_media;
            ++at;
            continue;
        }
        bool const html_comment = css.substr(at, 4) == "<!--" || css.substr(at, 3) == "-->";
        if (html_comment) {
            at += css[at] == '<' ? 4 : 3;
            continue;
        }
        bool const at_rule = at < css.size() && css[at] == '@';
        std::size_t const open = find_outside(css, at_rule ? "{;" : "{", at);
        std::string_view const head = trimmed(css.substr(at, open - at));
        bool const is_media =
            at_rule && same_word(head.substr(0, 6), "@media") && is_for_screens(trimmed(head.substr(6)));
        if (is_media && open < css.size() && css[open] == '{') {
            ++open_media;
            at = open + 1;
            continue;
        }
        if (at_rule && !is_harmless(head)) ignored.push_back(quoted(head));
        if (open == css.size()) break;
        bool const has_block = css[open] == '{';
        std::size_t const close = has_block ? find_outside(css, "}", open + 1) : open;
        if (!at_rule) add_rule(head, css.substr(open + 1, close - open - 1), ignored);
        at = close + 1;
    }
    return ignored;
}

void Sheet::add_rule(std::string_view selectors, std::string_view block, std::vector<std::string>& ignored) {
    std::vector<Declaration> const declarations = declarations_in(block);
    if (find_outside(block, "{", 0) < block.size())
        ignored.push_back("a rule within the rule of " + quoted(trimmed(selectors)));
    for (std::size_t at = 0; at <= selectors.size();) {
        std::size_t const end = find_outside(selectors, ",", at);
        std::string_view const selector = trimmed(selectors.substr(at, end - at));
        at = end + 1;
        if (!is_simple(selector)) {
            ignored.push_back("the selector " + quoted(selector));
            continue;
        }
        std::vector<Ruled>& rules = rules_[std::string(selector)];
        for (Declaration const& declaration : declarations) {
            if (!is_understood(declaration.name)) continue;
            // A later one of the same strength replaces the earlier.
            std::erase_if(rules, [&](Ruled const& earlier) {
                return earlier.declaration.important == declaration.important &&
                       same_word(earlier.declaration.name, declaration.name);
            });
            rules.push_back({declaration, ++order_});
        }
    }
}

void Sheet::collect(std::string const& selector, std::vector<Ruled>& found) const {
    auto const rules = rules_.find(selector);
    if (rules != rules_.end()) found.insert(found.end(), rules->second.begin(), rules->second.end());
}

std::vector<Declaration> Sheet::declarations_for(pugi::xml_node node) const {
    std::vector<Ruled> found;
    collect("*", found);
    collect(node.name(), found);
    auto const first_class = static_cast<std::ptrdiff_t>(found.size());
    std::unordered_set<std::string_view> met;
    for (std::string_view const word : words_of(node.attribute("class").value()))
        if (met.insert(word).second) collect("." + std::string(word), found);
    // Classes are equal in rank: the later rule wins, in whatever order the element names them.
    std::stable_sort(found.begin() + first_class, found.end(),
                     [](Ruled const& a, Ruled const& b) { return a.order < b.order; });
    if (auto const id = node.attribute("id")) collect("#" + std::string(id.value()), found);
    std::vector<Declaration> declarations;
    for (Ruled const& ruled : found) declarations.push_back(ruled.declaration);
    return declarations;
}

}  // namespace level
