#include "bench_engine.h"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

bool is_left_of(Vec2 const& point, Vec2 const& from, Vec2 const& to) {
    return geometry::cross(to - from, point - from) > 0;
}

bool is_boulder(physics::Scene const& scene, physics::Piece const& piece) {
    auto const* arc = std::get_if<geometry::Arc>(&piece.curve);
    return arc && std::all_of(scene.balls.begin(), scene.balls.end(), [&](physics::Ball const& ball) {
               return geometry::length(ball.start.position - arc->centre) > arc->radius;
           });
}

// The middle edge decides: it is as near to the balls as any in our scenes.
void turn_left_side_to_balls(Chain& chain, physics::Scene const& scene) {
    std::size_t const i = (chain.corners.size() - 1) / 2;
    if (!is_left_of(scene.balls[0].start.position, chain.corners[i], chain.corners[i + 1]))
        std::reverse(chain.corners.begin(), chain.corners.end());
}

}  // namespace

std::vector<Boulder> boulders_of(physics::Scene const& scene) {
    std::vector<Boulder> boulders;
    for (physics::Piece const& piece : scene.terrain.pieces)
        if (is_boulder(scene, piece)) boulders.push_back({std::get<geometry::Arc>(piece.curve), piece.material});
    return boulders;
}

std::vector<Chain> chains_of(physics::Scene const& scene, int pieces_of_an_arc) {
    std::vector<Chain> chains;
    for (physics::Piece const& piece : scene.terrain.pieces) {
        if (is_boulder(scene, piece)) continue;
        std::vector<Vec2> const corners = corners_of(piece.curve, pieces_of_an_arc);
        if (chains.empty() || geometry::length(chains.back().corners.back() - corners.front()) > physics::vertex_reach)
            chains.push_back({{corners.front()}, piece.material});
        auto& chain = chains.back().corners;
        chain.insert(chain.end(), corners.begin() + 1, corners.end());
    }
    for (Chain& chain : chains) {
        chain.closed = chain.corners.size() > 2 &&
                       geometry::length(chain.corners.back() - chain.corners.front()) < physics::vertex_reach;
        turn_left_side_to_balls(chain, scene);
    }
    return chains;
}

namespace {

std::vector<Peer>& all_peers() {
    static std::vector<Peer> all;
    return all;
}

}  // namespace

std::vector<Peer> const& known_peers() { return all_peers(); }

bool make_known(Peer peer) {
    std::vector<Peer>& all = all_peers();
    auto const place = std::find_if(all.begin(), all.end(), [&](Peer const& other) { return peer.name < other.name; });
    all.insert(place, std::move(peer));
    return true;
}

std::vector<Contestant> peers(std::vector<double> const& rates) {
    std::vector<Contestant> all;
    for (Peer const& peer : known_peers())
        for (double const rate : rates)
            all.push_back({peer.name, std::to_string(static_cast<int>(rate)) + " Hz", rate, rate == 60, peer_pieces, peer.start});
    return all;
}

std::vector<Contestant> peers_on_finer_pieces(std::vector<double> const& rates) {
    std::vector<Contestant> all = peers(rates);
    for (Contestant& peer : all) {
        peer.method += " on finer pieces";
        peer.pieces = finer_peer_pieces;
    }
    return all;
}

}  // namespace bench
