#include "bench_case.h"

#include <algorithm>
#include <cmath>

#include "bench_truth.h"
#include "geometry/elementary.h"
#include "level/level.h"
#include "level/starts.h"

namespace bench {

namespace {

using physics::Ball;
using physics::Scene;

// Start number i lies at this place in [-1, 1], spread evenly; number 0 is the start as drawn.
double place_of(int i) {
    double const golden = 0.6180339887498949 * i + 0.5;
    return 2 * (golden - std::floor(golden)) - 1;
}

// Sensors are the game's business, not a matter of the methods.
Scene scene_from(std::string const& file) {
    Scene scene = level::read_level(file).scene;
    scene.sensors.clear();
    return scene;
}

geometry::Curve const& first_curve(Scene const& scene) { return scene.terrain.pieces.at(0).curve; }

// Faster along its line by `more`, with the spin that keeps the slip as it was.
void hurry(Scene& scene, geometry::Segment const& line, double more) {
    Ball& ball = scene.balls[0];
    Vec2 const along = (line.end - line.start) / geometry::length(line.end - line.start);
    ball.start.velocity += more * along;
    ball.start.spin -= more / ball.radius;
}

Case line_case(std::string const& name, std::string const& file, double duration, double spread) {
    Scene const scene = scene_from(file);
    return {name, "closed form", [=](int i) {
                Start start{{scene, {}, duration}, {}};
                auto const line = std::get<geometry::Segment>(first_curve(scene));
                hurry(start.task.scene, line, spread * (i == 0 ? 0 : 1 + place_of(i)));
                start.truth = truth_on_line(start.task, line);
                return start;
            }};
}

Case bounce_case(std::string const& file) {
    Scene const scene = scene_from(file);
    return {"bounce", "closed form", [=](int i) {
                Start start{{scene, {}, 8}, {}};
                start.task.scene.balls[0].start.position.y() += 0.2 * place_of(i);
                double const floor = geometry::start_of(first_curve(scene)).y();
                start.truth = truth_of_bounces(start.task, floor, scene.terrain.pieces[0].material.restitution);
                return start;
            }};
}

// Puts the ball on its arc `turn` further, rolling at `speed` counter-clockwise about the arc's centre.
void put_on_arc(Scene& scene, geometry::Arc const& arc, double turn, double speed) {
    Ball& ball = scene.balls[0];
    Vec2 const from = ball.start.position - arc.centre;
    bool const outside = geometry::length(from) > arc.radius;
    double const phi = geometry::arctangent(from.y(), from.x()) + turn;
    auto const [sine, cosine] = geometry::sine_cosine(phi);
    ball.start.position = arc.centre + (arc.radius + (outside ? 1 : -1) * ball.radius) * Vec2(cosine, sine);
    ball.start.velocity = speed * Vec2(-sine, cosine);
    ball.start.spin = (outside ? 1 : -1) * speed / ball.radius;
}

enum class Jitter { place, speed };

Case circle_case(std::string const& name, std::string const& file, double duration, Jitter jitter, double spread) {
    Scene const scene = scene_from(file);
    return {name, "Runge-Kutta in 64 bits of mantissa",
            [=](int i) {
                Start start{{scene, {}, duration}, {}};
                auto const arc = std::get<geometry::Arc>(first_curve(scene));
                physics::State const& drawn = scene.balls[0].start;
                double const sense = geometry::cross(drawn.position - arc.centre, drawn.velocity) < 0 ? -1 : 1;
                double const more = spread * (i == 0 ? 0 : 1 + place_of(i));
                double const speed =
                    sense * geometry::length(drawn.velocity) * (jitter == Jitter::speed ? 1 + more : 1);
                put_on_arc(start.task.scene, arc, jitter == Jitter::place ? more : 0, speed);
                start.truth = truth_on_circle(start.task, arc);
                return start;
            },
            true};
}

Case drag_case(std::string const& name, std::string const& file) {
    Scene const scene = scene_from(file);
    return {name, "closed form", [=](int i) {
                Start start{{scene, {}, 4}, {}};
                physics::State& ball = start.task.scene.balls[0].start;
                start.task.pull = physics::Pull{0, {8, 4.5}};
                ball.position += 0.2 * place_of(i) * (start.task.pull->target - ball.position);
                start.truth = truth_on_spring(start.task);
                return start;
            }};
}

Case wall_case(std::string const& file) {
    Scene const scene = scene_from(file);
    return {"wall", "closed form", [=](int i) {
                Start start{{scene, {}, 0.1}, {}};
                start.task.scene.balls[0].start.velocity *= 1 + 0.1 * place_of(i);
                start.truth = truth_at_wall(start.task, geometry::start_of(first_curve(scene)).x());
                return start;
            }};
}

Case blow_case(std::string const& name, std::string const& file, double restitution) {
    Scene const scene = scene_from(file);
    return {name, "closed form", [=](int i) {
                Start start{{scene, {}, 4}, {}};
                start.task.scene.balls[0].start.velocity *= 1 + 0.1 * place_of(i);
                start.truth = truth_of_blows(start.task, restitution);
                return start;
            }};
}

}  // namespace

std::vector<double> frame_times(double duration) {
    std::vector<double> times(static_cast<std::size_t>(std::lround(duration * frames_per_second)));
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i + 1) / frames_per_second;
    return times;
}

std::vector<Case> cases_in(std::string const& lab) {
    return {
        line_case("ramp", lab + "/ramp.svg", 10, 0.1),
        line_case("skid", lab + "/skid.svg", 10, 0.1),
        line_case("slide", lab + "/slide.svg", 10, 0.1),
        bounce_case(lab + "/bounce.svg"),
        circle_case("valley", lab + "/valley.svg", 20, Jitter::place, 0.05),
        circle_case("hill", lab + "/hill.svg", 1.75, Jitter::speed, 0.02),
        circle_case("loop", lab + "/loop.svg", 5, Jitter::speed, 0.02),
        drag_case("drag-soft", lab + "/drag-soft.svg"),
        drag_case("drag-stiff", lab + "/drag-stiff.svg"),
        line_case("flat", lab + "/flat.svg", 8, 0.1),
        wall_case(lab + "/wall.svg"),
        blow_case("pair", lab + "/pair.svg", 0.5),
        blow_case("row", lab + "/row.svg", 1),
    };
}

std::vector<Vec2> corners_of(geometry::Curve const& curve, int pieces_of_an_arc) {
    auto const* arc = std::get_if<geometry::Arc>(&curve);
    if (!arc) return {geometry::start_of(curve), geometry::end_of(curve)};
    std::vector<Vec2> corners;
    for (int i = 0; i <= pieces_of_an_arc; ++i) {
        auto const [sine, cosine] = geometry::sine_cosine(arc->from + arc->sweep * i / pieces_of_an_arc);
        corners.push_back(arc->centre + arc->radius * Vec2(cosine, sine));
    }
    if (std::abs(arc->sweep) > 2 * geometry::pi - 1e-9) corners.back() = corners.front();
    return corners;
}

physics::Scene in_pieces(Scene const& scene, int pieces) {
    std::vector<physics::Piece> chords;
    for (physics::Piece const& piece : scene.terrain.pieces) {
        std::vector<Vec2> const corners = corners_of(piece.curve, pieces);
        for (std::size_t i = 1; i < corners.size(); ++i) {
            physics::Piece chord = piece;
            chord.curve = geometry::Segment{corners[i - 1], corners[i]};
            chords.push_back(chord);
        }
    }
    Scene broken = scene;
    broken.terrain = physics::terrain_of(std::move(chords));
    // Chords cut into the room of a ball inside the circle; it is moved out as the reader of levels does.
    broken.balls = level::moved_out(broken, level::overlaps_in(broken));
    return broken;
}

double uncertainty_of_integration(std::string const& lab) {
    long double most = 0;
    for (Case const& scene : cases_in(lab)) {
        if (!scene.arcs) continue;
        Start const start = scene.start(1);
        auto const arc = std::get<geometry::Arc>(first_curve(start.task.scene));
        auto const finer = truth_on_circle(start.task, arc, 2 * integration_steps);
        for (std::size_t i = 0; i < finer.size(); ++i)
            most = std::max(most, std::hypot(finer[i][0].x - start.truth[i][0].x, finer[i][0].y - start.truth[i][0].y));
    }
    return static_cast<double>(most);
}

}  // namespace bench
