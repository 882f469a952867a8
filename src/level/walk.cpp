#include "level/walk.h"

#include <algorithm>

#include "level/css.h"
#include "level/lengths.h"
#include "level/numbers.h"
#include "level/scan.h"
#include "level/shapes.h"
#include "level/viewport.h"

namespace level {

namespace {

bool is_group(std::string_view tag) { return tag == "g" || tag == "a" || tag == "svg" || tag == "switch"; }

// What browsers never draw where it stands.
bool is_definition(std::string_view tag) {
    return tag == "defs" || tag == "symbol" || tag == "clipPath" || tag == "mask" || tag == "marker" ||
           tag == "pattern" || tag == "linearGradient" || tag == "radialGradient" || tag == "filter" ||
           tag == "title" || tag == "desc" || tag == "metadata" || tag == "style";
}

// What every browser says to know: XHTML and MathML, in whatever it holds.
bool are_known(std::string_view extensions) {
    std::vector<std::string_view> const names = word_list(extensions);
    return !names.empty() && std::all_of(names.begin(), names.end(), [](std::string_view name) {
        return name == "http://www.w3.org/1999/xhtml" || name == "http://www.w3.org/1998/Math/MathML";
    });
}

// SVG 2, section 5.8: whether an element is for readers such as we are. Ours read English, wherever they are, so that
// a drawing is one level.
bool applies(pugi::xml_node node) {
    pugi::xml_attribute const extensions = node.attribute("requiredExtensions");
    pugi::xml_attribute const languages = node.attribute("systemLanguage");
    if (extensions && !are_known(extensions.value())) return false;
    if (!languages) return true;
    std::string text = languages.value();
    std::replace(text.begin(), text.end(), ',', ' ');
    for (std::string_view const language : words_of(text))
        if (same_word(language, "en") || same_word(language.substr(0, 3), "en-")) return true;
    return false;
}

// What browsers copy; anything else is not there in a copy (SVG 2, section 5.6, as Chromium has it).
bool is_copied(std::string_view tag) {
    constexpr std::string_view copied[] = {"a",        "circle", "desc",     "ellipse",  "g",     "image", "line",
                                           "metadata", "path",   "polygon",  "polyline", "rect",  "svg",   "switch",
                                           "symbol",   "text",   "textPath", "title",    "tspan", "use"};
    return std::find(std::begin(copied), std::end(copied), tag) != std::end(copied);
}

// Whether it shows anything or not: a title is taken as well as a path.
pugi::xml_node first_that_applies(pugi::xml_node choice, bool in_copy) {
    for (pugi::xml_node const child : choice.children()) {
        std::string_view const tag = Document::tag_of(child);
        if (!tag.empty() && (!in_copy || is_copied(tag)) && applies(child)) return child;
    }
    return {};
}

bool is_text(pugi::xml_node node) { return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata; }

}  // namespace

Walk::Walk(Document const& document, Frame const& frame, Reading& reading)
    : document_(document), reading_(reading), styles_(read_sheets()), elements_(document, reading, styles_) {
    pugi::xml_node const root = document.root();
    Context context;
    context.style = styles_.of(root, Style{});
    if (context.style.hidden) return;
    elements_.inspect_group(root, "svg", context.style);
    Placement const& placement = context.style.placement;
    for (std::string_view const given : {placement.transform, placement.translate, placement.rotate, placement.scale})
        if (!given.empty() && !same_word(given, "none")) warn(root, "a transform has no effect on the root");
    context.to_world = frame.to_world;
    context.viewport = frame.view_box;
    context.inherited = inherited_by(root, Inherited{});
    context.grass = asks_for_grass(root.attribute("class").value());
    open_.insert(root.hash_value());
    branches_.push_back({root.first_child(), Siblings::all, std::move(context), {}, {}});
    for (pugi::xml_node node = root; node; node = next_within(node, root))
        elements_met_ += node.type() == pugi::node_element;
    walk();
}

Sheet Walk::read_sheets() {
    Sheet sheet;
    std::size_t size = 0;
    for (pugi::xml_node node = document_.root(); node; node = next_within(node, document_.root())) {
        if (node.type() != pugi::node_element) continue;
        if (std::string_view(node.attribute("style").value()).size() > largest_sheet)
            fault(node, "a style must have at most 1 MB, got more");
        if (std::string_view(node.name()) == "style" && size <= largest_sheet) read_sheet(node, sheet, size);
    }
    return sheet;
}

void Walk::read_sheet(pugi::xml_node node, Sheet& sheet, std::size_t& size) {
    std::string_view const type = trimmed(node.attribute("type").value());
    std::string_view const media = trimmed(node.attribute("media").value());
    bool const for_us = (type.empty() || same_word(type, "text/css")) && (media.empty() || is_for_screens(media));
    if (!for_us) return warn(node, "is ignored: it is not CSS for screens");
    std::string text;
    for (pugi::xml_node const child : node.children())
        if (is_text(child)) text += child.value();
    size += text.size();
    if (size > largest_sheet) return fault(node, "style sheets must have at most 1 MB together, got more");
    auto const ignored = sheet.add(std::move(text));
    if (ignored.empty()) return;
    std::string const more = ignored.size() > 1 ? ", and " + std::to_string(ignored.size() - 1) + " more" : "";
    warn(node, ignored[0] + " is ignored" + more);
}

void Walk::walk() {
    while (!branches_.empty() && !full_) {
        Branch& branch = branches_.back();
        pugi::xml_node const node = branch.next;
        if (!node) {
            if (branch.target) open_.erase(branch.target.hash_value());
            branches_.pop_back();
            continue;
        }
        branch.next = branch.siblings == Siblings::all ? node.next_sibling() : pugi::xml_node();
        // By value: entering may move the branches.
        Context const above = branch.context;
        enter(node, above, branch.use);
    }
}

void Walk::enter(pugi::xml_node node, Context const& above, pugi::xml_node use) {
    std::string_view const tag = Document::tag_of(node);
    bool const shown_symbol = tag == "symbol" && use;
    if (tag.empty() || (is_definition(tag) && !shown_symbol) || !applies(node)) return;
    if (above.copy != Copy::none && !count_copy(node)) return;
    Context context = above;
    context.copy = above.copy == Copy::none ? Copy::none : use ? Copy::itself : Copy::within;
    context.style = styles_.of(node, above.style);
    if (context.style.hidden || (context.style.contents && is_shape(tag))) return;
    bool const is_link_in_link = tag == "a" && Document::tag_of(node.parent()) == "a" && context.copy != Copy::itself;
    if (is_link_in_link) return warn(node, "shows nothing: it is the child of another a");
    context.inherited = inherited_by(node, context.inherited);
    context.grass = context.grass || asks_for_grass(node.attribute("class").value());
    context.to_world = composed(context.to_world, placement_of(node, tag, context));
    if (tag == "use") return enter_copy(node, std::move(context));
    if (is_group(tag) || shown_symbol) return enter_group(node, tag, std::move(context), use);
    context.id = node.attribute("id").value();
    if (use && use.attribute("id")) context.id = use.attribute("id").value();
    elements_.read(node, tag, context);
}

void Walk::enter_group(pugi::xml_node node, std::string_view tag, Context context, pugi::xml_node use) {
    elements_.inspect_group(node, tag, context.style);
    if (auto const role = elements_.role_of_group(node)) context.role = role;
    if ((tag == "svg" || tag == "symbol") && !enter_viewport(node, use, context)) return;
    bool const is_choice = tag == "switch";
    pugi::xml_node const first = is_choice ? first_that_applies(node, context.copy != Copy::none) : node.first_child();
    if (is_choice && is_definition(Document::tag_of(first)))
        warn(node, "shows nothing: the first of its children that applies is " + quoted(Document::tag_of(first)));
    Siblings const siblings = is_choice ? Siblings::alone : Siblings::all;
    if (first) branches_.push_back({first, siblings, std::move(context), {}, {}});
}

void Walk::enter_copy(pugi::xml_node use, Context context) {
    elements_.inspect_group(use, "use", context.style);
    if (auto const role = elements_.role_of_group(use)) context.role = role;
    pugi::xml_node const target = target_of(use);
    if (!target) return;
    if (open_.contains(target.hash_value()))
        return fault(use, "is part of what it copies, " + quoted(Document::reference_of(use)));
    try {
        Vec2 const& around = context.viewport.size;
        std::string_view const x = use.attribute("x").value(), y = use.attribute("y").value();
        double const right = trimmed(x).empty() ? 0 : length_of_text(x, around.x());
        double const down = trimmed(y).empty() ? 0 : length_of_text(y, around.y());
        context.to_world = composed(context.to_world, {1, 0, 0, 1, right, down});
    } catch (Broken const& broken) {
        return fault(use, std::string("x and y must be lengths: ") + broken.what());
    }
    context.copy = Copy::itself;
    open_.insert(target.hash_value());
    branches_.push_back({target, Siblings::alone, std::move(context), use, target});
}

bool Walk::enter_viewport(pugi::xml_node node, pugi::xml_node use, Context& context) {
    try {
        auto const viewport = viewport_of(node, use, context.viewport.size);
        if (!viewport) {
            warn(node, "shows nothing: its width, height and viewBox must be greater than 0");
            return false;
        }
        std::string_view const overflow = context.style.overflow;
        if (!same_word(overflow, "visible") && !same_word(overflow, "auto")) {
            Sight const own = sight_of(viewport->shown, context.to_world);
            context.sight = std::make_shared<Sight const>(context.sight ? common_part(own, *context.sight) : own);
        }
        context.to_world = composed(context.to_world, viewport->map);
        context.viewport = {Vec2::Zero(), viewport->size};
        return true;
    } catch (Broken const& broken) {
        fault(node, broken.what());
        reading_.in_place = false;
        return false;
    }
}

bool Walk::count_copy(pugi::xml_node node) {
    for (pugi::xml_attribute const attribute : node.attributes())
        copied_bytes_ += std::string_view(attribute.value()).size();
    bool const many = ++elements_met_ > most_elements, much = copied_bytes_ > largest_file;
    if (!many && !much) return true;
    fault(node, many ? "a level must have at most 100000 elements, copies by use included"
                     : "copies by use must have at most 64 MB, got more");
    full_ = true;
    reading_.in_place = false;
    return false;
}

Affine Walk::placement_of(pugi::xml_node node, std::string_view tag, Context const& context) {
    Placement const& given = context.style.placement;
    char const* what = "transform: ";
    try {
        bool const stays =
            given.transform.empty() && given.translate.empty() && given.rotate.empty() && given.scale.empty();
        if (stays) return {};
        ReferenceBox const box = elements_.reference_box(node, tag, given.box, context);
        Vec2 const& whole = box.size;
        Affine map = composed(
            parsed_function("translate", given.translate, whole),
            composed(parsed_function("rotate", given.rotate, whole), parsed_function("scale", given.scale, whole)));
        Transform const transform = parsed_transform(given.transform, whole);
        if (given.in_style && !transform.in_style)
            warn(node, "transform: browsers heed it in a style only with units (px, deg) and commas as CSS has them");
        if (!given.in_style && !transform.in_attribute)
            warn(node, "transform: browsers heed it as an attribute only without units and as SVG spells it");
        map = composed(map, transform.map);
        // Browsers' own sheets put the origin of all but the outermost svg at 0 0, and miss the copy of one.
        bool const is_copied_svg = tag == "svg" && context.copy == Copy::itself;
        std::string_view const usual = is_copied_svg ? "50% 50%" : "0 0";
        if (given.origin.empty() && given.box.empty() && !is_copied_svg) return map;
        what = "transform-origin: ";
        return about(parsed_origin(given.origin.empty() ? usual : given.origin, box), map);
    } catch (Broken const& broken) {
        reading_.report.fault(document_.line_of(node), elements_.label(node, tag) + ": " + what + broken.what());
        reading_.in_place = false;
        return {};
    }
}

pugi::xml_node Walk::target_of(pugi::xml_node use) {
    std::string_view const reference = Document::reference_of(use);
    if (reference.substr(0, 1) != "#") {
        warn(use, "is ignored: only elements of the same file are copied, got " + quoted(reference));
        return {};
    }
    if (by_id_.empty())
        for (pugi::xml_node node = document_.root(); node; node = next_within(node, document_.root()))
            if (pugi::xml_attribute const id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
    auto const found = by_id_.find(reference.substr(1));
    if (found != by_id_.end()) return found->second;
    warn(use, "is ignored: there is no element " + quoted(reference));
    return {};
}

void Walk::fault(pugi::xml_node node, std::string const& what) {
    reading_.report.fault(document_.line_of(node), std::string(Document::tag_of(node)) + ": " + what);
}

void Walk::warn(pugi::xml_node node, std::string const& what) {
    reading_.report.warn(document_.line_of(node), std::string(Document::tag_of(node)) + ": " + what);
}

}  // namespace level
