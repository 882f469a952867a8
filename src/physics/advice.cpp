#include "physics/advice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/elementary.h"

namespace physics {

namespace {

constexpr double frames = 60;              // 1/s, how often costs ask
constexpr double slowest_rate = 60;        // steps/s, of what is advised
constexpr int doublings = 10;              // of that rate: up to 61440 steps/s
constexpr double reach = 4;                // m, how far the drag spring is drawn out unless a level says
constexpr double promise = 0.5;            // of the tolerance: what is foretold is foretold for 19 scenes of 20
constexpr std::size_t fewest_leaning = 3;  // two balls are held by closed forms
constexpr double usual_gravity = 9.81;     // m/s^2, under which piles were measured

double height_of(Scene const& scene) {
    geometry::Box box = scene.terrain.pieces.empty() ? geometry::Box{} : scene.terrain.bounds;
    for (Ball const& ball : scene.balls) box = united(box, {ball.start.position, ball.start.position});
    return scene.balls.empty() ? 0 : box.high.y() - box.low.y();
}

double speed_at_start(Scene const& scene) {
    double most = 0;
    for (Ball const& ball : scene.balls) most = std::max(most, geometry::length(ball.start.velocity));
    return most;
}

double ends_per_metre(Terrain const& terrain) {
    double length = 0;
    for (Piece const& piece : terrain.pieces) length += geometry::length_of(piece.curve);
    return length > 0 ? static_cast<double>(terrain.pieces.size()) / length : 0;
}

Forecast forecast_of_exact(Sketch const& scene, Experience const& seen) {
    double const pairs = scene.balls * (scene.balls - 1) / 2;
    return {Exact{}, seen.exact_error,
            scene.balls * (seen.exact_ball + seen.exact_joint * scene.speed * scene.ends) + seen.exact_pair * pairs +
                seen.exact_lean * scene.leaning};
}

Forecast forecast_of_steps(Sketch const& scene, double rate, Experience const& seen) {
    double const kink = scene.meets ? seen.kink_error * scene.speed / rate : 0;
    double const sag = seen.sag_error * scene.acceleration / (rate * rate);
    double const crowd = 1 + seen.steps_crowd * scene.radius * scene.ends;
    return {Steps{rate}, kink + sag, scene.balls * crowd * (seen.steps_frame * frames + seen.steps_step * rate)};
}

// Overlap grows with the pile as a power of the number of balls, taken from the two measured piles nearest in size; it
// is in proportion to gravity and, where a heavy ball lies on a light one, to their masses (physics.md 9.2).
Forecast forecast_of_pile(Scene const& scene, double rate, Experience const& seen) {
    std::vector<PileExperience> piles;
    for (PileExperience const& pile : seen.piles)
        if (pile.rate == rate) piles.push_back(pile);
    if (piles.size() < 2) return {Steps{rate}, INFINITY, INFINITY};
    double const balls = static_cast<double>(scene.balls.size());
    std::size_t i = 1;
    while (i + 1 < piles.size() && piles[i].balls < balls) ++i;
    PileExperience const &smaller = piles[i - 1], &larger = piles[i];
    double const power = std::log(larger.overlap / smaller.overlap) / std::log(larger.balls / smaller.balls);
    double const overlap = smaller.overlap * std::pow(balls / smaller.balls, power);
    auto const [lightest, heaviest] = std::minmax_element(scene.balls.begin(), scene.balls.end(),
                                                          [](Ball const& a, Ball const& b) { return a.mass < b.mass; });
    double widest = 0;
    for (Ball const& ball : scene.balls) widest = std::max(widest, ball.radius);
    return {Steps{rate}, overlap * widest * scene.gravity / usual_gravity * heaviest->mass / lightest->mass,
            balls * larger.cost};
}

bool has_piles(std::vector<Reason> const& needs) {
    return std::any_of(needs.begin(), needs.end(), [](Reason const& reason) { return reason.need == Need::piles; });
}

std::string in_metres(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g m", length);
    return text;
}

std::string in_seconds(double nanoseconds) {
    char text[32];
    if (nanoseconds < 1e6)
        std::snprintf(text, sizeof text, "%.3g us", nanoseconds / 1e3);
    else
        std::snprintf(text, sizeof text, "%.3g ms", nanoseconds / 1e6);
    return text;
}

std::string said_of(Forecast const& forecast) {
    std::string context;
    if (auto const* steps = std::get_if<Steps>(&forecast.method))
        context = " at " + std::to_string(std::lround(steps->rate)) + " steps/s";
    return name_of(forecast.method) + context + ": " + in_seconds(forecast.cost) + " a simulated second, error up to " +
           in_metres(forecast.error);
}

}  // namespace

Experience const& experience() {
    static Experience const measured = {
#include "physics/advice_table.inc"
    };
    return measured;
}

Sketch sketch_of(Scene const& scene) {
    Sketch sketch;
    sketch.balls = static_cast<double>(scene.balls.size());
    if (scene.balls.size() >= fewest_leaning && scene.gravity > 0) sketch.leaning = sketch.balls;
    double const start = speed_at_start(scene), stretch = 2 * geometry::pi * scene.drag.frequency;
    sketch.speed = std::sqrt(start * start + 2 * scene.gravity * height_of(scene)) + stretch * reach;
    sketch.acceleration = scene.gravity + stretch * stretch * reach;
    for (Ball const& ball : scene.balls)
        sketch.radius = sketch.radius > 0 ? std::min(sketch.radius, ball.radius) : ball.radius;
    sketch.ends = ends_per_metre(scene.terrain);
    sketch.meets = !scene.terrain.pieces.empty() || scene.balls.size() > 1;
    return sketch;
}

std::vector<Forecast> forecasts_for(Scene const& scene, Experience const& experience) {
    std::vector<Reason> const needs = needs_of(scene);
    Sketch const sketch = sketch_of(scene);
    bool const piles = has_piles(needs);
    std::vector<Forecast> forecasts;
    if (!piles) forecasts.push_back(forecast_of_exact(sketch, experience));
    double rate = slowest_rate;
    for (int i = 0; i <= doublings; ++i, rate *= 2)
        forecasts.push_back(piles ? forecast_of_pile(scene, rate, experience)
                                  : forecast_of_steps(sketch, rate, experience));
    return forecasts;
}

Choice advice_for(Scene const& scene, double tolerance, Experience const& experience) {
    std::vector<Forecast> all = forecasts_for(scene, experience);
    std::stable_sort(all.begin(), all.end(), [](Forecast const& a, Forecast const& b) { return a.cost < b.cost; });
    auto const keeps = [&](Forecast const& one) { return one.error <= promise * tolerance; };
    auto const chosen = std::find_if(all.begin(), all.end(), keeps);
    if (chosen == all.end()) {
        auto const nearest = std::min_element(all.begin(), all.end(),
                                              [](Forecast const& a, Forecast const& b) { return a.error < b.error; });
        return {nearest->method,
                "nothing is known to keep " + in_metres(tolerance) + "; nearest, " + said_of(*nearest)};
    }
    std::string why = "the cheapest known to keep " + in_metres(tolerance) + ", " + said_of(*chosen);
    auto const next = std::find_if(chosen + 1, all.end(), keeps);
    if (next != all.end()) why += "; next, " + said_of(*next);
    return {chosen->method, why};
}

}  // namespace physics
