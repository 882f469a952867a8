#include "level/viewport.h"

#include <algorithm>
#include <string>

#include "level/css.h"
#include "level/faults.h"
#include "level/lengths.h"
#include "level/numbers.h"

namespace level {

namespace {

double length_or(pugi::xml_node node, char const* attribute, double whole, double otherwise) {
    std::string_view const text = trimmed(node.attribute(attribute).value());
    if (text.empty() || same_word(text, "auto")) return otherwise;
    try {
        return length_of_text(text, whole);
    } catch (Broken const& broken) {
        throw Broken(std::string(attribute) + ": " + broken.what());
    }
}

// Where the free space goes that a viewBox of another shape leaves: none of it, half or all before the picture.
double share_before(std::string_view align, std::size_t at) {
    std::string_view const word = align.substr(std::min(at, align.size()), 3);
    if (word == "Min") return 0;
    if (word == "Max") return 1;
    if (word == "Mid") return 0.5;
    throw Broken("preserveAspectRatio: unknown alignment " + quoted(align));
}

// SVG 2, section 8.2: the transform that fits a viewBox into a viewport.
Affine fitted(std::vector<double> const& box, Vec2 const& size, std::string_view fit) {
    auto const words = word_list(fit);
    std::string_view const align = words.empty() ? std::string_view("xMidYMid") : words[0];
    double sx = size.x() / box[2], sy = size.y() / box[3];
    Vec2 before = Vec2::Zero();
    if (align != "none") {
        double const both = words.size() > 1 && words[1] == "slice" ? std::max(sx, sy) : std::min(sx, sy);
        sx = sy = both;
        before = {share_before(align, 1) * (size.x() - both * box[2]),
                  share_before(align, 5) * (size.y() - both * box[3])};
    }
    return {sx, 0, 0, sy, before.x() - box[0] * sx, before.y() - box[1] * sy};
}

}  // namespace

std::optional<Viewport> viewport_of(pugi::xml_node node, pugi::xml_node use, Vec2 const& around) {
    Vec2 const place(length_or(node, "x", around.x(), 0), length_or(node, "y", around.y(), 0));
    Vec2 size(length_or(node, "width", around.x(), around.x()), length_or(node, "height", around.y(), around.y()));
    if (use) size = {length_or(use, "width", around.x(), size.x()), length_or(use, "height", around.y(), size.y())};
    if (!(size.x() > 0 && size.y() > 0)) return std::nullopt;
    Affine const placed_at{1, 0, 0, 1, place.x(), place.y()};
    pugi::xml_attribute const given = node.attribute("viewBox");
    geometry::Box const shown{place, place + size};
    if (!given) return Viewport{placed_at, size, shown};
    auto const box = parsed_list(given.value());
    if (!box || box->size() != 4) throw Broken("viewBox must be four finite numbers, got " + quoted(given.value()));
    if ((*box)[2] < 0 || (*box)[3] < 0)
        throw Broken("viewBox must not have a negative width or height, got " + quoted(given.value()));
    if ((*box)[2] == 0 || (*box)[3] == 0) return std::nullopt;
    return Viewport{composed(placed_at, fitted(*box, size, node.attribute("preserveAspectRatio").value())),
                    {(*box)[2], (*box)[3]},
                    shown};
}

}  // namespace level
