// The way through a drawing as a browser goes it: groups, copies by use, the choice of a switch, nested viewports.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "level/document.h"
#include "level/element_reader.h"
#include "level/frame.h"
#include "level/style.h"

namespace level {

// Walks without recursion: groups may be nested as deeply as a file allows.
class Walk {
public:
    Walk(Document const& document, Frame const& frame, Reading& reading);

    Elements const& elements() const { return elements_; }
    std::vector<physics::Piece> take_pieces() { return elements_.take_pieces(); }
    std::vector<Undrawn> const& undrawn() const { return styles_.undrawn(); }

private:
    enum class Siblings { all, alone };
    // What is to be visited of the children of one element.
    struct Branch {
        pugi::xml_node next;
        Siblings siblings = Siblings::all;
        Context context;
        pugi::xml_node use, target;  // where these children are a copy
    };

    Sheet read_sheets();
    void read_sheet(pugi::xml_node node, Sheet& sheet, std::size_t& size);
    void walk();
    void enter(pugi::xml_node node, Context const& above, pugi::xml_node use);
    void enter_group(pugi::xml_node node, std::string_view tag, Context context, pugi::xml_node use);
    void enter_copy(pugi::xml_node use, Context context);
    bool enter_viewport(pugi::xml_node node, pugi::xml_node use, Context& context);
    bool count_copy(pugi::xml_node node);
    Affine placement_of(pugi::xml_node node, std::string_view tag, Context const& context);
    pugi::xml_node target_of(pugi::xml_node use);
    void fault(pugi::xml_node node, std::string const& what);
    void warn(pugi::xml_node node, std::string const& what);

    Document const& document_;
    Reading& reading_;
    Styles styles_;
    Elements elements_;
    std::vector<Branch> branches_;
    std::unordered_map<std::string_view, pugi::xml_node> by_id_;
    std::unordered_set<std::size_t> open_;  // what is being copied, by hash value
    std::size_t copied_bytes_ = 0;
    int elements_met_ = 0;  // in the file, then with the copies
    bool full_ = false;     // the limits of copies are reached
};

}  // namespace level
