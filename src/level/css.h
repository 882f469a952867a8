// Style sheets: declarations, and rules with simple selectors.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <pugixml.hpp>

namespace level {

inline constexpr std::size_t largest_sheet = 1'000'000;  // bytes, of all sheets of a drawing together, or one style

struct Declaration {
    std::string_view name;  // as written, without -webkit-; CSS does not tell upper from lower case
    std::string_view value;
    bool important = false;
};

bool same_word(std::string_view a, std::string_view b);  // in whatever case

// Whether one of the media, between commas, is all or screen without conditions.
bool is_for_screens(std::string_view media);

bool has_comment(std::string_view css);
std::string without_comments(std::string_view css);

// name: value; name: value !important ... The text holds no comments. What is no declaration is left out, as CSS says.
std::vector<Declaration> declarations_in(std::string_view css);

// All rules of a drawing's sheets whose selector is a type, a class, an id or *.
class Sheet {
public:
    // What was not understood of it, selectors and @-rules, for findings.
    std::vector<std::string> add(std::string text);

    bool empty() const { return rules_.empty(); }

    // What the rules say of an element, the weaker before the stronger, important ones included.
    std::vector<Declaration> declarations_for(pugi::xml_node node) const;

private:
    struct Ruled {
        Declaration declaration;
        int order = 0;
    };
    void add_rule(std::string_view selectors, std::string_view block, std::vector<std::string>& ignored);
    void collect(std::string const& selector, std::vector<Ruled>& found) const;

    std::deque<std::string> texts_;  // what the declarations refer to
    std::unordered_map<std::string, std::vector<Ruled>> rules_;
    int order_ = 0;
};

}  // namespace level
