#include "level/namespaces.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace level {

namespace {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

struct Name {
    std::string_view prefix, local;
};

Name split(std::string_view name) {
    std::size_t const colon = name.find(':');
    if (colon == std::string_view::npos) return {{}, name};
    return {name.substr(0, colon), name.substr(colon + 1)};
}

// What every prefix stands for here; the empty one is that of names without a colon.
class Scope {
public:
    void enter(pugi::xml_node node) {
        declared_.push_back(0);
        for (pugi::xml_attribute const attribute : node.attributes()) {
            std::string_view const name = attribute.name();
            if (name.substr(0, 5) != "xmlns" || (name.size() > 5 && name[5] != ':')) continue;
            std::string_view const prefix = name.size() > 5 ? name.substr(6) : std::string_view();
            bindings_[prefix].push_back(attribute.value());
            log_.push_back(prefix);
            ++declared_.back();
        }
    }
    void leave() {
        for (; declared_.back() > 0; --declared_.back()) {
            bindings_[log_.back()].pop_back();
            log_.pop_back();
        }
        declared_.pop_back();
    }
    Namespace of(std::string_view prefix) const {
        auto const found = bindings_.find(prefix);
        bool const bound = found != bindings_.end() && !found->second.empty() && !found->second.back().empty();
        if (!bound) return prefix.empty() ? Namespace::none : Namespace::other;
        return found->second.back() == svg_namespace ? Namespace::svg : Namespace::other;
    }

private:
    std::unordered_map<std::string_view, std::vector<std::string_view>> bindings_;
    std::vector<std::string_view> log_;  // the prefixes declared, in order
    std::vector<int> declared_;          // by open element
};

class Sieve {
public:
    explicit Sieve(pugi::xml_node root) : root_(root) { scope_.enter(root); }

    std::vector<Foreign> foreign() {
        bool const bare_is_svg = scope_.of(split(root_.name()).prefix) == Namespace::none;
        strip_prefix(root_);
        std::vector<pugi::xml_node> foreign_nodes;
        pugi::xml_node node = root_.first_child();
        while (node) {
            if (node.type() == pugi::node_element) {
                scope_.enter(node);
                Namespace const here = scope_.of(split(node.name()).prefix);
                bool const is_svg = here == Namespace::svg || (here == Namespace::none && bare_is_svg);
                if (is_svg) strip_prefix(node);
                if (is_svg && node.first_child()) {
                    node = node.first_child();
                    continue;
                }
                scope_.leave();
                if (!is_svg) foreign_nodes.push_back(node);
            }
            node = after(node);
        }
        for (pugi::xml_node const stranger : foreign_nodes) {
            note_classes(stranger);
            stranger.parent().remove_child(stranger);
        }
        return std::move(foreign_);
    }

private:
    // The next node that is not below this one; the scopes of the elements that end in between are left.
    pugi::xml_node after(pugi::xml_node node) {
        while (!node.next_sibling()) {
            node = node.parent();
            if (node == root_) return {};
            scope_.leave();
        }
        return node.next_sibling();
    }

    static void strip_prefix(pugi::xml_node node) {
        Name const name = split(node.name());
        if (!name.prefix.empty()) node.set_name(std::string(name.local).c_str());
    }

    void note_classes(pugi::xml_node top) {
        pugi::xml_node node = top;
        while (node) {
            if (auto const classes = node.attribute("class"))
                foreign_.push_back({node.offset_debug(), node.name(), classes.value()});
            if (node.first_child()) {
                node = node.first_child();
                continue;
            }
            while (node != top && !node.next_sibling()) node = node.parent();
            node = node == top ? pugi::xml_node() : node.next_sibling();
        }
    }

    pugi::xml_node root_;
    Scope scope_;
    std::vector<Foreign> foreign_;
};

}  // namespace

Namespace namespace_of_root(pugi::xml_node root) {
    Scope scope;
    scope.enter(root);
    return scope.of(split(root.name()).prefix);
}

std::vector<Foreign> without_foreign(pugi::xml_node root) { return Sieve(root).foreign(); }

}  // namespace level
