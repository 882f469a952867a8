#include "view/ending.h"

#include <algorithm>
#include <cmath>

#include "game/medals.h"
#include "geometry/elementary.h"
#include "view/hud.h"
#include "view/palette.h"

namespace view {

namespace {

using game::Text;
using game::words;

constexpr double card_rise = 0.25;  // s: a card opens over this time
// Where motion is reduced a card is whole at once.
double age_of(double age, Motion motion) { return motion == Motion::full ? age : std::max(age, card_rise); }

constexpr double bold_share = 1.2;  // of the width of regular letters

// Pieces of paper whose way through the air depends on the time since the goal alone.
void add_confetti(std::vector<Shape>& shapes, double age, Vec2 const& size) {
    Colour const colours[] = {palette::red, palette::gold, palette::green, palette::blue, palette::violet};
    double const unit = hud_scale(size);
    int constexpr pieces = 90;
    for (int i = 0; i < pieces; ++i) {
        double const across = std::fmod(i * 0.61803398875, 1.0), luck = std::fmod(i * 0.7548776662, 1.0);
        double const fall = (age - 0.9 * luck) * (170 + 130 * luck) * unit;
        if (fall < 0 || fall > size.y() + 40 * unit) continue;
        double const sway = 22 * unit * std::sin(2.5 * age + 9 * luck);
        double const turn = age * (3 + 4 * luck) + i;
        Vec2 const at(across * size.x() + sway, fall - 20 * unit);
        Vec2 const half = 6 * unit * Vec2(std::cos(turn), 0.6 * std::sin(turn));
        double const width = (2.5 + 4 * std::abs(std::sin(0.7 * turn + i))) * unit;
        shapes.emplace_back(Stroke{at - half, at + half, width, colours[i % 5]});
    }
}

// A card that opens: all on it fades in, its headline swells.
struct Card {
    Vec2 corner = Vec2::Zero();  // pixels
    double width = 0, height = 0;
    double unit = 1;
    double open = 1;  // 0 to 1

    float presence() const { return static_cast<float>(open); }
    double middle() const { return corner.x() + width / 2; }
};

Card card_for(double age, double width, double height, Vec2 const& size) {
    double const unit = hud_scale(size);
    Card card{Vec2::Zero(), width * unit, height * unit, unit, std::clamp(age / card_rise, 0.0, 1.0)};
    card.corner = {(size.x() - card.width) / 2, std::max(62 * unit, 0.36 * size.y() - card.height / 2)};
    return card;
}

void add_card(std::vector<Shape>& shapes, Card const& card) {
    Vec2 const extent(card.width, card.height);
    shapes.emplace_back(Panel{card.corner + Vec2(0, 5 * card.unit), extent, 22 * card.unit,
                              faded(palette::ink, 0.25f * card.presence())});
    shapes.emplace_back(Panel{card.corner, extent, 22 * card.unit, faded(colour(0xfffdf6, 0.93f), card.presence())});
}

void add_headline(std::vector<Shape>& shapes, Card const& card, std::string const& text, Colour const& paint) {
    double const swell = 1 + 0.25 * std::sin(geometry::pi * card.open) * (1 - card.open);
    double const room = (card.width - 40 * card.unit) / std::max(bold_share * text_width(text), 1e-9);
    double const height = std::min(58 * card.unit, room) * swell * (0.6 + 0.4 * card.open);
    Vec2 const at(card.middle(), card.corner.y() + 62 * card.unit);
    shapes.emplace_back(Label{at, height, text, faded(paint, card.presence()), Anchor::Centre, Weight::bold});
}

void add_line(std::vector<Shape>& shapes, Card const& card, double down, std::string const& text, double letters = 20) {
    double const room = card.width - 40 * card.unit;
    double const height = std::min(letters * card.unit, room / std::max(text_width(text), 1e-9));
    Vec2 const at(card.middle(), card.corner.y() + down * card.unit);
    shapes.emplace_back(Label{at, height, text, faded(palette::ink, card.presence()), Anchor::Centre});
}

struct Metal {
    Colour face, rim;
    Text name;
};
Metal metal_of(game::Medal medal) {
    switch (medal) {
        case game::Medal::gold:
            return {palette::gold, palette::gold_deep, Text::gold};
        case game::Medal::silver:
            return {colour(0xdfe6ec), colour(0x8b99a6), Text::silver};
        default:
            return {colour(0xd9935a), colour(0x99572a), Text::bronze};
    }
}

// A tick or a cross; nothing where nothing is asked for.
void add_tick(std::vector<Shape>& shapes, Vec2 const& at, double size, game::Met met, float presence) {
    if (met == game::Met::not_asked) return;
    auto const stroke = [&](Vec2 const& from, Vec2 const& to, Colour const& paint) {
        shapes.emplace_back(Stroke{at + size * from, at + size * to, 0.22 * size, faded(paint, presence)});
    };
    if (met == game::Met::yes) {
        stroke({-0.5, 0}, {-0.15, 0.4}, palette::green);
        stroke({-0.15, 0.4}, {0.55, -0.45}, palette::green);
    } else {
        stroke({-0.4, -0.4}, {0.4, 0.4}, palette::red);
        stroke({-0.4, 0.4}, {0.4, -0.4}, palette::red);
    }
}

std::string counted(int count, Text one, Text many, game::Language language) {
    return words(count == 1 ? one : many, language, {std::to_string(count)});
}

// What was done and, where the level asks for something, what it asks for.
void add_score(std::vector<Shape>& shapes, Card const& card, level::Level const& level, game::Status const& status,
               game::Language language) {
    game::Marks const marks = game::marks_of(level, status);
    struct Item {
        std::string value, asked;
        game::Met met;
    };
    std::vector<Item> items;
    auto const par = [&](std::string const& value) { return words(Text::par, language, {value}); };
    auto const seconds = [&](double value, int digits) {
        return words(Text::seconds, language, {written(value, digits)});
    };
    items.push_back({seconds(*status.goal_time, 2), level.pars.time ? par(seconds(*level.pars.time, 1)) : std::string(),
                     marks.time});
    if (level.drag_reach > 0)
        items.push_back({counted(status.pulls, Text::pull, Text::pulls, language),
                         level.pars.pulls ? par(std::to_string(*level.pars.pulls)) : std::string(), marks.pulls});
    if (int const bananas = game::bananas_in(level); bananas > 0)
        items.push_back({counted(status.bananas, Text::banana, Text::bananas, language),
                         words(Text::of_all, language, {std::to_string(bananas)}), marks.bananas});
    double const column = (card.width - 20 * card.unit) / static_cast<double>(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        Item const& item = items[i];
        Vec2 const at(card.corner.x() + 10 * card.unit + (static_cast<double>(i) + 0.5) * column,
                      card.corner.y() + 112 * card.unit);
        float const presence = card.presence();
        shapes.emplace_back(Label{at, 24 * card.unit, item.value, faded(palette::ink, presence), Anchor::Centre});
        if (item.asked.empty()) continue;
        Vec2 const below = at + Vec2(10, 26) * card.unit;
        double const half = 0.5 * text_width(item.asked) * 18 * card.unit;
        shapes.emplace_back(
            Label{below, 18 * card.unit, item.asked, faded(colour(0x5b6a77), presence), Anchor::Centre});
        add_tick(shapes, below - Vec2(half + 12 * card.unit, 6 * card.unit), 15 * card.unit, item.met, presence);
    }
}

// What the next medal takes: gold all that is asked for, silver all but one.
std::string next_step(level::Level const& level, game::Status const& status, game::Medal medal,
                      game::Language language) {
    if (medal == game::Medal::none || medal == game::Medal::gold) return {};
    game::Marks const marks = game::marks_of(level, status);
    auto const at_most = [&](std::string const& value) { return words(Text::at_most, language, {value}); };
    std::vector<std::string> missed;
    if (marks.time == game::Met::no)
        missed.push_back(at_most(words(Text::seconds, language, {written(*level.pars.time, 1)})));
    if (marks.pulls == game::Met::no)
        missed.push_back(at_most(counted(*level.pars.pulls, Text::pull, Text::pulls, language)));
    if (marks.bananas == game::Met::no) missed.push_back(words(Text::all_bananas, language));
    std::string way = missed.front();
    if (missed.size() == 2) way = words(Text::either, language, {missed[0], missed[1]});
    if (missed.size() == 3) way = words(Text::two_of, language, {missed[0], missed[1], missed[2]});
    return words(medal == game::Medal::silver ? Text::for_gold : Text::for_silver, language, {way});
}

struct Button {
    Vec2 corner, extent;  // pixels
};

// The card after the goal, as it is at this moment: its lines, and where its button is.
struct GoalCard {
    Card card;
    game::Medal medal = game::Medal::none;
    std::vector<std::string> lines;
    std::optional<Button> film;
};

GoalCard goal_card(level::Level const& level, Moment const& moment, Vec2 const& size, EndingNote const& note) {
    GoalCard goal;
    game::Status const& status = moment.status;
    double const goal_time = *status.goal_time;
    goal.medal = game::medal_for(level, status);
    if (std::string const step = next_step(level, status, goal.medal, note.language); !step.empty())
        goal.lines.push_back(step);
    if (note.best) {
        bool const is_best = goal_time < *note.best;
        goal.lines.push_back(words(is_best ? Text::new_best : Text::best, note.language, {written(*note.best, 2)}));
    }
    if (!note.hint.empty()) goal.lines.push_back(note.hint);
    double const lines_end = 160 + 30 * static_cast<double>(goal.lines.size());
    goal.card =
        card_for(age_of(moment.time - goal_time, note.motion), 540, lines_end + (note.film.empty() ? 0 : 48), size);
    if (note.film.empty()) return goal;
    double const unit = goal.card.unit;
    Vec2 const extent = Vec2(text_width(note.film) * 18 + 44, 36) * unit;
    goal.film = Button{{goal.card.middle() - extent.x() / 2, goal.card.corner.y() + (lines_end - 4) * unit}, extent};
    return goal;
}

void add_goal_card(std::vector<Shape>& shapes, level::Level const& level, Moment const& moment, Vec2 const& size,
                   EndingNote const& note) {
    GoalCard const goal = goal_card(level, moment, size, note);
    Card const& card = goal.card;
    add_card(shapes, card);
    std::string const headline =
        words(goal.medal == game::Medal::none ? Text::goal : metal_of(goal.medal).name, note.language);
    add_headline(shapes, card, headline, palette::gold_deep);
    if (goal.medal != game::Medal::none)
        for (double const side : {-1.0, 1.0}) {
            Vec2 const at(card.middle() + side * 190 * card.unit, card.corner.y() + 40 * card.unit);
            for (Shape& shape : medal_shapes(at, 25 * card.unit, goal.medal, card.presence()))
                shapes.emplace_back(std::move(shape));
        }
    add_score(shapes, card, level, moment.status, note.language);
    double down = 170;
    for (std::string const& line : goal.lines) {
        add_line(shapes, card, down, line);
        down += 30;
    }
    if (!goal.film) return;
    auto const& [corner, extent] = *goal.film;
    double const unit = card.unit;
    shapes.emplace_back(
        Panel{corner + Vec2(0, 3 * unit), extent, extent.y() / 2, faded(palette::gold_deep, card.presence())});
    shapes.emplace_back(Panel{corner, extent, extent.y() / 2, faded(palette::gold, card.presence())});
    shapes.emplace_back(Label{corner + Vec2(extent.x() / 2, 24 * unit), 18 * unit, note.film,
                              faded(palette::ink, card.presence()), Anchor::Centre});
}

void add_message(std::vector<Shape>& shapes, std::string const& headline, double age, Vec2 const& size,
                 EndingNote const& note) {
    Card const card = card_for(age_of(age, note.motion), 480, note.hint.empty() ? 90 : 125, size);
    add_card(shapes, card);
    add_headline(shapes, card, headline, palette::red);
    if (!note.hint.empty()) add_line(shapes, card, 103, note.hint);
}

}  // namespace

std::vector<Shape> medal_shapes(Vec2 const& at, double radius, game::Medal medal, float presence) {
    std::vector<Shape> shapes;
    Metal const metal = metal_of(medal);
    for (double const side : {-1.0, 1.0})
        shapes.emplace_back(Stroke{at + radius * Vec2(0.15 * side, 0.3), at + radius * Vec2(0.75 * side, 1.75),
                                   0.5 * radius, faded(side < 0 ? palette::blue : palette::red, presence)});
    shapes.emplace_back(Disc{at, radius, faded(metal.face, presence), faded(metal.rim, presence), 0.14 * radius, 0});
    int const stars = medal == game::Medal::gold ? 3 : medal == game::Medal::silver ? 2 : 1;
    for (int i = 0; i < stars; ++i) {
        Vec2 const middle = at + radius * Vec2(0.5 * (i - (stars - 1) / 2.0), i == 1 && stars == 3 ? -0.18 : 0.05);
        Area star;
        std::vector<Vec2>& ring = star.rings.emplace_back();
        for (int point = 0; point < 10; ++point) {
            double const angle = point * 0.62831853 - 1.57079633;
            ring.push_back(middle + (point % 2 == 0 ? 0.26 : 0.11) * radius * Vec2(std::cos(angle), std::sin(angle)));
        }
        star.paint.top = star.paint.bottom = faded(metal.rim, presence);
        shapes.emplace_back(std::move(star));
    }
    return shapes;
}

bool is_on_film_button(level::Level const& level, Moment const& moment, Vec2 const& pixel, Vec2 const& size,
                       EndingNote const& note) {
    if (!moment.status.goal_time) return false;
    auto const button = goal_card(level, moment, size, note).film;
    if (!button) return false;
    Vec2 const inside = pixel - button->corner;
    return inside.x() >= 0 && inside.y() >= 0 && inside.x() < button->extent.x() && inside.y() < button->extent.y();
}

std::vector<Shape> ending_shapes(level::Level const& level, Moment const& moment, Vec2 const& size,
                                 EndingNote const& note) {
    std::vector<Shape> shapes;
    game::Status const& status = moment.status;
    if (status.goal_time) {
        if (note.motion == Motion::full) add_confetti(shapes, moment.time - *status.goal_time, size);
        add_goal_card(shapes, level, moment, size, note);
    } else if (status.fall_time) {
        add_message(shapes, words(Text::fall, note.language), moment.time - *status.fall_time, size, note);
    } else if (status.out_of_time && level.time_limit) {
        add_message(shapes, words(Text::time_over, note.language), moment.time - *level.time_limit, size, note);
    }
    return shapes;
}

}  // namespace view
