#include "hunt/shrink.h"

#include <algorithm>
#include <cmath>

#include "geometry/match.h"
#include "hunt/kinds.h"

namespace hunt {

namespace {

constexpr int most_rounds = 4;
constexpr int most_questions = 1500;
constexpr int most_decimals = 6;

void add(std::vector<double*>& numbers, Vec2& point) { numbers.insert(numbers.end(), {&point.x(), &point.y()}); }

void add_stroke(std::vector<double*>& numbers, Stroke& stroke) {
    auto const points = [&](auto&... each) { (add(numbers, each), ...); };
    std::visit(geometry::Match{[&](Line& s) { points(s.from, s.to); },
                               [&](Bow& s) {
                                   points(s.from, s.to);
                                   numbers.push_back(&s.radius);
                               },
                               [&](Cubic& s) { points(s.from, s.first, s.second, s.to); },
                               [&](Quadratic& s) { points(s.from, s.handle, s.to); },
                               [&](Disc& s) {
                                   points(s.centre);
                                   numbers.push_back(&s.radius);
                               }},
               stroke);
}

// All that may be rounded.
std::vector<double*> numbers_of(Sketch& sketch) {
    std::vector<double*> numbers = {&sketch.drag_frequency, &sketch.drag_damping,    &sketch.drag_reach,
                                    &sketch.ball.radius,    &sketch.ball.inertia,    &sketch.ball.start.spin,
                                    &sketch.duration,       &sketch.ball.start.angle};
    add(numbers, sketch.ball.start.position);
    add(numbers, sketch.ball.start.velocity);
    for (Element& element : sketch.elements)
        for (Stroke& stroke : element.strokes) add_stroke(numbers, stroke);
    for (game::Input& input : sketch.inputs) {
        numbers.push_back(&input.time);
        std::visit(geometry::Match{[&](game::Grab& a) { add(numbers, a.pointer); },
                                   [&](game::Move& a) { add(numbers, a.pointer); }, [](game::Release&) {},
                                   [&](game::Tilt& a) { numbers.push_back(&a.angle); }},
                   input.action);
    }
    return numbers;
}

// Without moves and releases of what is not held.
std::vector<game::Input> lawful(std::vector<game::Input> const& inputs) {
    std::vector<game::Input> kept;
    bool held = false;
    for (game::Input const& input : inputs) {
        bool const wants_held =
            std::holds_alternative<game::Move>(input.action) || std::holds_alternative<game::Release>(input.action);
        if (wants_held && !held) continue;
        if (std::holds_alternative<game::Grab>(input.action)) held = true;
        if (std::holds_alternative<game::Release>(input.action)) held = false;
        kept.push_back(input);
    }
    return kept;
}

class Shrinking {
public:
    Shrinking(Sketch const& sketch, std::function<bool(Sketch const&)> const& fails) : best_(sketch), fails_(fails) {}

    Sketch const& best() const { return best_; }

    bool shorten(double duration) {
        return attempt([=](Sketch& s) { s.duration = std::min(s.duration, duration); });
    }

    bool drop() {
        bool changed = false;
        for (std::size_t i = best_.inputs.size(); i-- > 0;)
            changed |= i < best_.inputs.size() && attempt([=](Sketch& s) {
                           s.inputs.erase(s.inputs.begin() + static_cast<std::ptrdiff_t>(i));
                           s.inputs = lawful(s.inputs);
                       });
        for (std::size_t i = best_.elements.size(); i-- > 0;) {
            if (attempt([=](Sketch& s) { s.elements.erase(s.elements.begin() + static_cast<std::ptrdiff_t>(i)); })) {
                changed = true;
                continue;
            }
            for (std::size_t j = best_.elements[i].strokes.size(); j-- > 0;)
                changed |= attempt([=](Sketch& s) {
                    auto& strokes = s.elements[i].strokes;
                    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(j));
                });
        }
        return changed;
    }

    bool plain() {
        bool changed = attempt([](Sketch& s) { s.ball.start.velocity = Vec2::Zero(); });
        changed |= attempt([](Sketch& s) { s.ball.start.spin = 0; });
        changed |= attempt([](Sketch& s) { s.ball.inertia = 0.5; });
        changed |= attempt([](Sketch& s) { each_material(s, &physics::Material::rolling_resistance, 0); });
        changed |= attempt([](Sketch& s) { each_material(s, &physics::Material::restitution, 0); });
        changed |= attempt([](Sketch& s) { each_material(s, &physics::Material::friction, 0); });
        return changed;
    }

    // All numbers at once as far as that goes, then each value wherever it stands.
    bool round() {
        bool changed = false;
        for (int decimals = 0; decimals <= most_decimals && !changed; ++decimals)
            changed = attempt([=](Sketch& s) {
                for (double* number : numbers_of(s)) *number = rounded(*number, decimals);
            });
        std::vector<double> values;
        for (double const* number : numbers_of(best_)) values.push_back(*number);
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
        for (double const value : values)
            for (int decimals = 0; decimals <= most_decimals && rounded(value, decimals) != value; ++decimals)
                if (attempt([=](Sketch& s) { replace(s, value, rounded(value, decimals)); })) {
                    changed = true;
                    break;
                }
        return changed;
    }

private:
    static double rounded(double number, int decimals) {
        double const scale = std::pow(10, decimals);
        return std::round(number * scale) / scale;
    }
    static void replace(Sketch& sketch, double value, double other) {
        for (double* number : numbers_of(sketch))
            if (*number == value) *number = other;
    }
    static void each_material(Sketch& sketch, double physics::Material::*property, double value) {
        for (Element& element : sketch.elements) element.material.*property = value;
    }

    // Keeps the change if it fails as before.
    bool attempt(std::function<void(Sketch&)> const& change) {
        Sketch changed = best_;
        change(changed);
        if (is_same(changed)) return false;
        bool const is_sound =
            changed.ball.radius > 0 && changed.ball.inertia > 0 && changed.duration > 0 && starts_clear(changed);
        if (!is_sound || ++questions_ > most_questions || !fails_(changed)) return false;
        best_ = changed;
        return true;
    }
    bool is_same(Sketch& other) {
        std::vector<double*> const a = numbers_of(best_), b = numbers_of(other);
        return svg_of(other) == svg_of(best_) &&
               std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double* x, double* y) { return *x == *y; });
    }

    Sketch best_;
    std::function<bool(Sketch const&)> const& fails_;
    int questions_ = 0;
};

}  // namespace

Sketch shrunk(Sketch const& sketch, double fails_at, std::function<bool(Sketch const&)> const& fails) {
    Shrinking shrinking(sketch, fails);
    for (double const more : {0.05, 0.5, 2.0})
        if (fails_at > 0 && shrinking.shorten(fails_at + more)) break;
    for (int round = 0; round < most_rounds; ++round) {
        bool const dropped = shrinking.drop(), plainer = shrinking.plain(), rounder = shrinking.round();
        if (!dropped && !plainer && !rounder) break;
    }
    return shrinking.best();
}

}  // namespace hunt
