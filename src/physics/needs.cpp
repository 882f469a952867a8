#include "physics/needs.h"

#include <algorithm>
#include <cmath>

namespace physics {

namespace {

// More balls than this under gravity come to rest on each other sooner or later, whatever they do at first.
constexpr std::size_t most_loose_balls = 8;

template <typename Test>
int first_piece(Scene const& scene, Test&& test) {
    for (int i = 0; i < static_cast<int>(scene.terrain.pieces.size()); ++i)
        if (test(scene.terrain.pieces[i])) return i;
    return -1;
}

class NeedsFinder {
public:
    explicit NeedsFinder(Scene const& scene) : scene_(scene) {}

    std::vector<Reason> found() {
        of_piece(Need::arcs, "is round", [](Piece const& p) { return std::holds_alternative<geometry::Arc>(p.curve); });
        bool const exposed = std::any_of(scene_.terrain.vertices.begin(), scene_.terrain.vertices.end(),
                                         [](Vertex const& v) { return v.cone_width >= joint_turn; });
        if (exposed) add(Need::corners, "the terrain has ends or corners to pivot on");
        of_piece(Need::bounces, "has restitution above 0", [](Piece const& p) { return p.material.restitution > 0; });
        of_piece(Need::slip, "has friction that can be overcome",
                 [](Piece const& p) { return std::isfinite(p.material.friction); });
        of_piece(Need::resistance, "has rolling resistance",
                 [](Piece const& p) { return p.material.rolling_resistance > 0; });
        if (scene_.drag.frequency > 0) add(Need::drag, "the ball can be dragged");
        std::size_t const balls = scene_.balls.size();
        if (balls > 1) add(Need::pairs, std::to_string(balls) + " balls can meet");
        if (balls > most_loose_balls && scene_.gravity > 0)
            add(Need::piles, std::to_string(balls) + " balls under gravity come to rest on each other");
        return reasons_;
    }

private:
    void add(Need need, std::string const& why, int surface = -1) {
        Reason& reason = reasons_.emplace_back();
        reason.need = need;
        reason.why = why;
        reason.surface = surface;
    }

    template <typename Test>
    void of_piece(Need need, char const* what, Test&& test) {
        int const piece = first_piece(scene_, test);
        if (piece < 0) return;
        add(need, what, scene_.terrain.pieces[piece].surface);
    }

    Scene const& scene_;
    std::vector<Reason> reasons_;
};

}  // namespace

std::vector<Reason> needs_of(Scene const& scene) { return NeedsFinder(scene).found(); }

char const* name_of(Need need) {
    switch (need) {
        case Need::arcs:
            return "arcs";
        case Need::corners:
            return "corners";
        case Need::bounces:
            return "bounces";
        case Need::slip:
            return "slip";
        case Need::resistance:
            return "rolling resistance";
        case Need::drag:
            return "drag";
        case Need::pairs:
            return "pairs";
        case Need::piles:
            return "piles";
    }
    return "";
}

bool exact_covers(Need need) { return need != Need::piles; }

Choice choice_for(Scene const& scene) {
    std::vector<Reason> const needs = needs_of(scene);
    auto const piles = std::find_if(needs.begin(), needs.end(), [](Reason const& r) { return !exact_covers(r.need); });
    if (piles == needs.end())
        return {Exact{}, "it covers every need and is right to rounding on all that it was tried on (docs/physics.md)"};
    return {Steps{}, "the exact method does not cover " + std::string(name_of(piles->need)) + ": " + piles->why};
}

}  // namespace physics
