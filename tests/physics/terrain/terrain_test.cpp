#include <cmath>
#include <random>
#include <stdexcept>

#include <doctest/doctest.h>

#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;
using geometry::Arc;

TEST_CASE("ends within a micrometre are one vertex, further apart two") {
    CHECK(terrain_of({line({0, 0}, {1, 0}), line({1 + 9e-7, 0}, {2, 0})}).vertices.size() == 3);
    CHECK(terrain_of({line({0, 0}, {1, 0}), line({1 + 2e-6, 0}, {2, 0})}).vertices.size() == 4);
}

TEST_CASE("ends are one vertex or two by their distance alone, wherever they are and however many") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> metres(-0.5, 0.5), angle(-pi, pi);
    for (double const distance : {9e-7, 1.1e-6}) {
        constexpr int pairs = 900;
        std::vector<Piece> pieces;
        for (int i = 0; i < pairs; ++i) {
            double const far = i % 3 == 0 ? 1e4 : 1;  // m
            Vec2 const end = far * Vec2(3 * (i % 30), 3 * (i / 30)) + Vec2(metres(random), metres(random));
            auto const [sine, cosine] = geometry::sine_cosine(angle(random));
            pieces.push_back(line(end - Vec2(0.5, 0), end));
            pieces.push_back(line(end + distance * Vec2(cosine, sine), end + Vec2(0.5, 0.25)));
        }
        CHECK(terrain_of(pieces).vertices.size() == (distance < vertex_reach ? 3 : 4) * pairs);
    }
}

TEST_CASE("a whole circle has no vertex") {
    Terrain const terrain = terrain_of({arc({0, 0}, 1, 0, 2 * pi)});
    CHECK(terrain.vertices.empty());
    CHECK(terrain.start_vertex[0] == -1);
}

TEST_CASE("of many circles about one centre each is there once, with the greatest numbers and the first name") {
    constexpr int circles = 500;
    std::vector<Piece> pieces;
    for (int i = 0; i < circles; ++i) pieces.push_back({Arc{{8, 4}, 0.01 * (i + 1), 0, 2 * pi}, {0.3, 0, 0.1}, i});
    for (int i = 0; i < circles; ++i) {
        Vec2 const centre(8 + (i % 2 == 0 ? 5e-10 : -5e-10), 4);
        pieces.push_back({Arc{centre, 0.01 * (i + 1) - 5e-10, 1, -2 * pi}, {0.7, 0.2, 0}, circles + i});
    }
    Terrain const terrain = terrain_of(pieces);
    REQUIRE(terrain.pieces.size() == circles);
    for (Piece const& piece : terrain.pieces) {
        CHECK(piece.material.friction == 0.7);
        CHECK(piece.material.restitution == 0.2);
        CHECK(piece.material.rolling_resistance == 0.1);
        CHECK(piece.surface == std::lround(std::get<Arc>(piece.curve).radius * 100) - 1);
    }
}

TEST_CASE("of many arcs between the same two points each is there once") {
    constexpr int arcs = 300;
    std::vector<Piece> pieces;
    for (int i = 0; i < arcs; ++i) {
        double const half = 0.5 + 0.003 * i;  // rad, of the sweep
        auto const [sine, cosine] = geometry::sine_cosine(half);
        double const radius = 0.5 / sine;
        Arc const arc{{0.5, -radius * cosine}, radius, pi / 2 + half, -2 * half};
        pieces.push_back({arc, {}, i});
        pieces.push_back({geometry::reversed(arc), {}, i});
    }
    Terrain const terrain = terrain_of(pieces);
    CHECK(terrain.pieces.size() == arcs);
    CHECK(terrain.vertices.size() == 2);
}

static Vertex const& vertex_at(Terrain const& terrain, Vec2 const& point) {
    for (Vertex const& vertex : terrain.vertices)
        if (vertex.point == point) return vertex;
    throw std::logic_error("no vertex there");
}

TEST_CASE("a flat joint exposes no direction, a corner those between its normals") {
    Terrain const flat = terrain_of(chain({{-1, 0}, {0, 0}, {1, 0}}));
    Terrain const corner = terrain_of(chain({{-1, 0}, {0, 0}, {0, -1}}));
    Vec2 const up(0, 1), out(std::sqrt(0.5), std::sqrt(0.5)), back(-0.6, 0.8);
    CHECK_FALSE(exposes(vertex_at(flat, {0, 0}), up));
    CHECK(exposes(vertex_at(corner, {0, 0}), out));
    CHECK_FALSE(exposes(vertex_at(corner, {0, 0}), back));
}

TEST_CASE("a track keeps the centre at the radius from its surface, on both sides") {
    Terrain const terrain = terrain_of({arc({1, 2}, 3, 0.3, 2), line({0, 0}, {3, 4})});
    for (int const side : {1, -1}) {
        Track const round = track_of(terrain, {0, side}, 0.5), straight = track_of(terrain, {1, side}, 0.5);
        for (double const q : {0.0, 0.7, 2.0}) {
            CHECK(geometry::length(position_at(round, q) - Vec2(1, 2)) == doctest::Approx(side > 0 ? 2.5 : 3.5));
            CHECK(geometry::cross(Vec2(0.6, 0.8), position_at(straight, q)) == doctest::Approx(0.5 * side));
            CHECK(nearest_coordinate(round, position_at(round, q)) == doctest::Approx(q));
            CHECK(nearest_coordinate(straight, position_at(straight, q)) == doctest::Approx(q));
        }
    }
}

TEST_CASE("an arc as tight as the ball has no track inside") {
    Terrain const terrain = terrain_of({arc({0, 0}, 0.5, 0, 2)});
    CHECK_FALSE(fits(terrain, {0, 1}, 0.5));
    CHECK(fits(terrain, {0, -1}, 0.5));
    CHECK(fits(terrain, {0, 1}, 0.4));
}

TEST_CASE("tilt turns gravity counter-clockwise") {
    Scene scene;
    CHECK(gravity_of(scene, {0.3, {}}).x() == doctest::Approx(9.81 * std::sin(0.3)));
    CHECK(gravity_of(scene, {0.3, {}}).y() == doctest::Approx(-9.81 * std::cos(0.3)));
}

TEST_CASE("a history answers with the later of two legs that meet, and forgets what ended before") {
    History history;
    Leg first, second;
    first.until = second.since = 1;
    first.motion = Straight{{{0, 0}, {1, 0}, 0, 0}, {1, 0}, 0};
    second.motion = Straight{{{1, 0}, {0, 2}, 0, 0}, {0, 2}, 0};
    history.legs = {{first, second}};
    CHECK(state_at(history, 0, 0.5).position == Vec2(0.5, 0));
    CHECK(state_at(history, 0, 1).velocity == Vec2(0, 2));
    CHECK(state_at(history, 0, 1.5).position == Vec2(1, 1));
    forget_before(history, 1);
    CHECK(history.legs[0].size() == 1);
    CHECK(history.from == 1);
}

TEST_CASE("a leg on a spring is the damped oscillator, forward and back") {
    SpringFlight spring;
    spring.from.position = {1, 0};
    spring.oscillator = {0, 4};
    Leg leg;
    leg.since = 2;
    leg.motion = spring;
    CHECK(at(leg, 3).position.x() == doctest::Approx(std::cos(2.0)).epsilon(1e-14));
    CHECK(at(leg, 1).velocity.x() == doctest::Approx(2 * std::sin(2.0)).epsilon(1e-14));
    CHECK(acceleration_bound(leg, 2, 9) == doctest::Approx(4).epsilon(1e-12));
}
