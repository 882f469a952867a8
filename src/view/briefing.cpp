#include "view/briefing.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "game/medals.h"
#include "geometry/elementary.h"
#include "view/hud.h"
#include "view/palette.h"

namespace view {

using game::Language;
using game::Text;
using game::words;

namespace {

constexpr double full_circle = 2 * geometry::pi;

// Letters with a rim, so that they can be read over anything.
void add_rimmed(std::vector<Shape>& shapes, Label label, double rim, Colour const& paint) {
    Label behind = label;
    behind.colour = paint;
    behind.swell = rim;
    shapes.emplace_back(std::move(behind));
    shapes.emplace_back(std::move(label));
}

std::string asked_for(level::Level const& level, Language language) {
    std::string text;
    auto const add = [&](std::string const& part) { text += (text.empty() ? "" : ",  ") + part; };
    if (level.pars.time) add(words(Text::seconds, language, {written(*level.pars.time, 0)}));
    if (level.pars.pulls && level.drag_reach > 0)
        add(words(*level.pars.pulls == 1 ? Text::pull : Text::pulls, language, {std::to_string(*level.pars.pulls)}));
    if (game::bananas_in(level) > 0) add(words(Text::all_bananas, language));
    return text.empty() ? text : words(Text::asked_gold, language, {text});
}

std::string verbs_of(level::Level const& level, Wording const& wording) {
    std::string const drag = words(Text::verb_drag, wording.language);
    std::string const tilt = words(Text::verb_tilt, wording.language, {wording.left, wording.right});
    if (level.drag_reach <= 0) return level.tilt_limit > 0 ? tilt : "";
    return level.tilt_limit > 0 ? drag + ",  " + tilt : drag;
}

// A pointing hand whose finger tip is at `tip`; pressed, it is a little smaller.
void add_hand(std::vector<Shape>& shapes, Vec2 const& tip, double size) {
    struct Part {
        Vec2 from, to;
        double width;
    };
    Part const parts[] = {{{0.02, 0.1}, {0.16, 0.75}, 0.2},   {{0.24, 0.62}, {0.28, 0.85}, 0.2},
                          {{0.44, 0.62}, {0.44, 0.85}, 0.2},  {{0.62, 0.68}, {0.58, 0.9}, 0.18},
                          {{-0.12, 0.72}, {0.1, 0.98}, 0.18}, {{0.2, 0.95}, {0.5, 0.95}, 0.42},
                          {{0.3, 1.1}, {0.42, 1.22}, 0.42}};
    for (double const rim : {0.1, 0.0})
        for (Part const& part : parts)
            shapes.emplace_back(Stroke{tip + size * part.from, tip + size * part.to, size * (part.width + rim),
                                       rim > 0 ? palette::ink : palette::bright});
}

}  // namespace

std::vector<std::string> lines_of(std::string const& text, std::size_t letters) {
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (lines.empty() || lines.back().size() + 1 + word.size() > letters)
            lines.push_back(word);
        else
            lines.back() += " " + word;
    }
    return lines;
}

std::vector<Shape> title_shapes(double time, Vec2 const& size, std::string const& call, std::string const& keys) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size);
    Vec2 const middle(size.x() / 2, 0.33 * size.y());
    double const bob = 5 * unit * std::sin(1.6 * time);
    add_rimmed(
        shapes,
        Label{middle + Vec2(0, bob - 42 * unit), 60 * unit, "Super", palette::bright, Anchor::Centre, Weight::bold},
        5 * unit, palette::ink);
    add_rimmed(shapes,
               Label{middle + Vec2(0, bob + 44 * unit), 104 * unit, "Monkey Ball", palette::gold, Anchor::Centre,
                     Weight::bold},
               7 * unit, palette::ink);
    add_rimmed(shapes,
               Label{middle + Vec2(268 * unit, bob + 104 * unit), 56 * unit, "2D", palette::strain, Anchor::Centre,
                     Weight::bold},
               5 * unit, palette::ink);
    double const letters = 28 * unit, width = text_width(call) * letters + 60 * unit;
    float const glow = static_cast<float>(0.8 + 0.2 * std::sin(3.2 * time));
    Vec2 const corner((size.x() - width) / 2, 0.72 * size.y());
    shapes.emplace_back(Panel{corner, {width, 52 * unit}, 26 * unit, palette::night});
    shapes.emplace_back(
        Label{{size.x() / 2, corner.y() + 35 * unit}, letters, call, faded(palette::bright, glow), Anchor::Centre});
    shapes.emplace_back(Label{{size.x() / 2, size.y() - 18 * unit}, 17 * unit, keys, palette::bright, Anchor::Centre});
    return shapes;
}

std::vector<Shape> briefing_shapes(level::Level const& level, double presence, Vec2 const& size, Side side,
                                   Wording const& wording) {
    std::vector<Shape> shapes;
    if (presence <= 0) return shapes;
    float const alpha = static_cast<float>(std::min(presence, 1.0));
    double const unit = hud_scale(size), letters = 20 * unit, line = 27 * unit;
    // Lines of about equal length, as few as fit.
    std::size_t constexpr most_letters = 76, slack = 8;
    std::size_t const count = level.hint.size() / most_letters + 1;
    std::vector<std::string> const lines =
        lines_of(level.hint, std::min(most_letters, level.hint.size() / count + slack));
    std::string const verbs = verbs_of(level, wording), asked = asked_for(level, wording.language);
    double const width = std::min(880 * unit, size.x() - 24 * unit);
    double const height = 62 * unit + line * static_cast<double>(lines.size());
    double const below_the_figures = 62 * unit;
    Vec2 const corner((size.x() - width) / 2, side == Side::upper ? below_the_figures : size.y() - height - 18 * unit);
    shapes.emplace_back(Panel{corner, {width, height}, 18 * unit, faded(colour(0x14202c, 0.84f), alpha)});
    Vec2 at(size.x() / 2, corner.y() + 32 * unit);
    for (std::string const& text : lines) {
        shapes.emplace_back(Label{at, letters, text, faded(palette::bright, alpha), Anchor::Centre});
        at.y() += line;
    }
    at.y() += 4 * unit;
    double const margin = 28 * unit;
    double const both = text_width(verbs + asked) + 1.5;  // and a gap between them
    double const small = std::min(letters, (width - 2 * margin) / both);
    if (!verbs.empty())
        shapes.emplace_back(
            Label{{corner.x() + margin, at.y()}, small, verbs, faded(palette::turf_lit, alpha), Anchor::Left});
    if (!asked.empty())
        shapes.emplace_back(
            Label{{corner.x() + width - margin, at.y()}, small, asked, faded(palette::gold, alpha), Anchor::Right});
    return shapes;
}

std::vector<Shape> pulling_hand_shapes(Vec2 const& from, Vec2 const& way, double time, double unit) {
    std::vector<Shape> shapes;
    double constexpr period = 2.4, reaching = 0.5, pulling = 1.7;  // s
    double const phase = std::fmod(time, period);
    auto const eased = [](double share) { return share * share * (3 - 2 * share); };
    double const share = std::clamp((phase - reaching) / (pulling - reaching), 0.0, 1.0);
    bool const holds = phase >= reaching && phase < pulling;
    Vec2 const approach = (1 - eased(std::clamp(phase / reaching, 0.0, 1.0))) * Vec2(30, 40) * unit;
    Vec2 const tip = from + approach + eased(share) * way;
    if (holds) {
        int constexpr dots = 7;
        for (int i = 1; i < dots; ++i)
            shapes.emplace_back(
                Disc{from + (tip - from) * i / dots, 3.2 * unit, palette::strain, palette::ink, 1 * unit, 0});
        shapes.emplace_back(ArcStroke{tip, 9 * unit, 0, full_circle, 3 * unit, palette::bright});
    }
    add_hand(shapes, tip, (holds ? 42 : 46) * unit);
    return shapes;
}

std::vector<Shape> tilting_keys_shapes(double time, Vec2 const& size, Wording const& wording) {
    std::vector<Shape> shapes;
    double const unit = hud_scale(size), side = 52 * unit;
    double const phase = std::fmod(time, 2.4);
    for (int i = 0; i < 2; ++i) {
        double const way = i == 0 ? -1 : 1;
        bool const down = i == 0 ? phase < 0.7 : phase >= 1.2 && phase < 1.9;
        Vec2 const middle(size.x() / 2 + way * 36 * unit, 0.6 * size.y() + (down ? 4 * unit : 0));
        Vec2 const corner = middle - Vec2(side, side) / 2;
        shapes.emplace_back(Panel{corner + Vec2(0, (down ? 2 : 6) * unit), {side, side}, 10 * unit, palette::ink});
        shapes.emplace_back(Panel{corner, {side, side}, 10 * unit, down ? palette::gold : colour(0xeef2f5)});
        std::string const& key = i == 0 ? wording.left : wording.right;
        if (key != (i == 0 ? Wording{}.left : Wording{}.right)) {
            double const letters = std::min(26 * unit, 0.8 * side / std::max(text_width(key), 1e-9));
            Vec2 const base = middle + Vec2(0, 0.34 * letters);
            shapes.emplace_back(Label{base, letters, key, palette::ink, Anchor::Centre});
            continue;
        }
        Area arrow;
        arrow.rings = {{middle + Vec2(way * 13, 0) * unit, middle + Vec2(-way * 9, -12) * unit,
                        middle + Vec2(-way * 9, 12) * unit}};
        arrow.paint.top = arrow.paint.bottom = palette::ink;
        shapes.emplace_back(std::move(arrow));
    }
    return shapes;
}

std::vector<Shape> grip_shapes(Vec2 const& centre, double radius, double unit) {
    double const ring = radius + 6 * unit;
    return {ArcStroke{centre, ring, 0, full_circle, 5 * unit, faded(palette::ink, 0.5f)},
            ArcStroke{centre, ring, 0, full_circle, 3 * unit, palette::bright}};
}

std::vector<Shape> ghost_shapes(Vec2 const& centre, double radius, double angle) {
    Vec2 const spoke = radius * Vec2(std::cos(angle), -std::sin(angle));
    return {Disc{centre, radius, colour(0xffffff, 0.28f), colour(0xffffff, 0.75f), 0.1 * radius, 0},
            Stroke{centre - 0.8 * spoke, centre + 0.8 * spoke, 0.12 * radius, colour(0xffffff, 0.5f)}};
}

}  // namespace view
