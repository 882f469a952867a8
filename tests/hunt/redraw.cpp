// Whether a ball cares how its ground was drawn.
#include <algorithm>
#include <cmath>
#include <memory>

#include "game/session.h"
#include "hunt/ground.h"
#include "hunt/otherwise.h"

namespace hunt {

namespace {

constexpr int events_compared = 6;
constexpr double nearly = 0.35;  // rad, of half a turn
constexpr double looks_per_second = 240;
constexpr double most_apart = 1e-9;     // m, of ten
constexpr double nudge = 1e-12;         // m: some thousand times the rounding of a place
constexpr double most_amplified = 100;  // what starts a nudge apart may be so many nudges apart later, else it is chaos

bool keeps_its_ends(Stroke const& stroke) {
    if (auto const* bow = std::get_if<Bow>(&stroke))
        return std::abs(std::abs(limb_of(*bow).sweep) - geometry::pi) < nearly;
    return std::holds_alternative<Cubic>(stroke) || std::holds_alternative<Quadratic>(stroke);
}

template <typename Change>
Sketch changed(Sketch const& sketch, Change const& change) {
    Sketch other = sketch;
    for (Element& element : other.elements) {
        std::vector<Stroke> strokes;
        for (Stroke const& stroke : element.strokes)
            for (Stroke const& part : change(stroke)) strokes.push_back(part);
        element.strokes = strokes;
    }
    return other;
}

// Every stroke its own element.
Sketch in_pieces(Sketch const& sketch) {
    Sketch other = sketch;
    other.elements.clear();
    for (Element const& element : sketch.elements)
        for (Stroke const& stroke : element.strokes) other.elements.push_back({{stroke}, element.material});
    return other;
}

Sketch shuffled(Dice& dice, Sketch const& sketch) {
    Sketch other = in_pieces(sketch);
    for (std::size_t i = other.elements.size(); i > 1; --i)
        std::swap(other.elements[i - 1],
                  other.elements[static_cast<std::size_t>(dice.whole(0, static_cast<int>(i) - 1))]);
    return other;
}

Sketch twice(Sketch const& sketch) {
    Sketch other = sketch;
    other.elements.insert(other.elements.end(), sketch.elements.begin(), sketch.elements.end());
    return other;
}

struct Way {
    game::Session session;
    double until = 0;  // s, the time of the sixth event, or the end
};

Way way_of(Sketch const& sketch) {
    auto const level = std::make_shared<level::Level const>(level_of(sketch));
    Way way{game::session_of(level, physics::Exact{}, sketch.inputs, "run.json")};
    int counted = 0;
    std::size_t seen = 0;
    for (int row = 1; row <= sketch.duration * looks_per_second; ++row) {
        way.until = row / looks_per_second;
        game::advance(way.session, way.until);
        auto const& events = way.session.history.events;
        for (; seen < events.size(); ++seen)
            if (events[seen].kind != physics::EventKind::joint && ++counted == events_compared) {
                way.until = events[seen].time;
                return way;
            }
    }
    return way;
}

struct Apart {
    double way = 0;   // share of what is allowed
    double time = 0;  // s
};

// Up to the earlier of both ends.
Apart apart(Way const& a, Way const& b) {
    Apart most;
    double const until = std::min(a.until, b.until);
    for (int row = 0; row / looks_per_second < until; ++row) {
        double const time = row / looks_per_second;
        Vec2 const here = physics::state_at(a.session.history, 0, time).position,
                   there = physics::state_at(b.session.history, 0, time).position;
        double const way = geometry::length(there - here) / std::max(1.0, geometry::length(here) / 10);
        if (!(way <= most.way)) most = {way, time};
    }
    return most;
}

// How far starts a nudge away come apart from it, in the same time.
double scatter(Sketch const& sketch, Way const& way) {
    double most = 0;
    for (Vec2 const& aside : {Vec2(nudge, 0), Vec2(-nudge, 0), Vec2(0, nudge), Vec2(0, -nudge)}) {
        Sketch other = sketch;
        other.ball.start.position += aside;
        most = std::max(most, apart(way, way_of(other)).way);
    }
    return most;
}

// Whether lines or arcs miss each other by less than what makes one vertex of their ends, but not by rounding. Then the
// whole of them is moved to the vertex, or, drawn in two, the nearer half alone (docs/physics.md 12.2).
bool has_slight_gaps(Sketch const& sketch) {
    std::vector<Vec2> ends;
    for (Limb const& limb : ground_of(sketch.elements)) {
        if (limb.round && std::abs(limb.sweep) > 6.28) continue;
        ends.push_back(limb.from);
        ends.push_back(limb.to);
    }
    for (Vec2 const& a : ends)
        for (Vec2 const& b : ends) {
            double const gap = geometry::length(b - a);
            if (gap > 1e-13 && gap <= 1.001e-6) return true;
        }
    return false;
}

}  // namespace

std::vector<Redrawing> redrawings_of(Sketch const& sketch) {
    Dice dice(2);
    auto const turned = [](Stroke const& s) { return std::vector<Stroke>{keeps_its_ends(s) ? s : backwards(s)}; };
    auto const parted = [&](Stroke const& s) { return keeps_its_ends(s) ? std::vector<Stroke>{s} : split(dice, s); };
    Sketch backward = changed(sketch, turned);
    std::reverse(backward.elements.begin(), backward.elements.end());
    std::vector<Redrawing> all{{"twice", twice(sketch)},
                               {"backwards", backward},
                               {"in pieces", in_pieces(sketch)},
                               {"shuffled", shuffled(dice, sketch)}};
    if (!has_slight_gaps(sketch)) all.push_back({"split", changed(sketch, parted)});
    return all;
}

std::optional<Finding> moves_otherwise(Sketch const& sketch) {
    Way const way = way_of(sketch);
    std::optional<Finding> worst;
    std::optional<double> scattered;
    for (Redrawing const& redrawing : redrawings_of(sketch)) {
        Apart const most = apart(way, way_of(redrawing.sketch));
        if (most.way <= most_apart) continue;
        if (!scattered) scattered = scatter(sketch, way);
        bool const is_chaos = *scattered > most_amplified * nudge && most.way < *scattered * 100;
        if (!is_chaos && (!worst || most.way > worst->measured))
            worst = Finding{Wrong::otherwise, most.way, most.time, redrawing.name};
    }
    return worst;
}

}  // namespace hunt
