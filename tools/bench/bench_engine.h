// Engines: whatever can say where balls will be, ours and others, under one face.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench_case.h"
#include "physics/method.h"

namespace bench {

// One run from the start on. What it costs to set up is free; ours do all their work within positions_at.
class Engine {
public:
    virtual ~Engine() = default;
    // Of all balls, time by time; times ascend. One of the two may be called, once.
    virtual std::vector<Vec2> positions_at(std::vector<double> const& times) = 0;
    virtual std::vector<physics::State> states_at(std::vector<double> const& times) = 0;
};

// A method or a peer with a setting.
struct Contestant {
    std::string method;
    std::string setting;  // for people
    double rate = 0;      // steps/s; 0 = has none
    bool recommended = false;
    int pieces = 0;  // arcs are broken into so many chords; 0 = as the method does by itself
    std::unique_ptr<Engine> (*start)(Contestant const&, Task const&) = nullptr;
};

// Those of `rates` for each; rates are multiples of 60.
std::vector<Contestant> our_methods(std::vector<double> const& rates);
std::vector<Contestant> peers(std::vector<double> const& rates);
std::vector<Contestant> peers_on_finer_pieces(std::vector<double> const& rates);

// steps/s: of the steps that say how far an answer without a closed form can be trusted.
inline constexpr double finest_rate = 7680;

physics::Method method_of(Contestant const& contestant);

// Of an arc, for engines that know none.
inline constexpr int peer_pieces = 512, finer_peer_pieces = 2048;

// The terrain as open or closed chains of corners with the material of their first piece, the balls to the left.
struct Chain {
    std::vector<Vec2> corners;
    physics::Material material;
    bool closed = false;  // the last corner is the first
};
std::vector<Chain> chains_of(physics::Scene const& scene, int pieces_of_an_arc);

// An arc that the balls meet from outside can be a whole disc to an engine that knows discs.
struct Boulder {
    geometry::Arc arc;
    physics::Material material;
};
std::vector<Boulder> boulders_of(physics::Scene const& scene);

// A pile of equal discs on the way to rest, kept awake; for measuring.
class Pile {
public:
    virtual ~Pile() = default;
    virtual void frame() = 0;  // 1/60 s on
    virtual std::vector<Vec2> positions() const = 0;
};
std::unique_ptr<Pile> our_pile(physics::Scene const& scene, physics::Steps const& method);

// Somebody else's engine. It stands in the file peer_NAME.cpp, makes itself known there before main() begins, and is named
// nowhere else: CMakeLists.txt builds the files whose library is installed.
struct Peer {
    struct PileSetting {
        std::string setting;  // for people
        int iterations = 0;
    };
    std::string name;
    std::unique_ptr<Engine> (*start)(Contestant const&, Task const&) = nullptr;
    std::unique_ptr<Pile> (*pile)(physics::Scene const&, int iterations) = nullptr;
    std::vector<PileSetting> pile_settings;
};
// By name.
std::vector<Peer> const& known_peers();
bool make_known(Peer peer);

// By its classes, an Engine and a Pile.
template <typename PeerEngine, typename PeerPile>
bool make_known(std::string const& name, std::vector<Peer::PileSetting> const& pile_settings) {
    auto const start = [](Contestant const& contestant, Task const& task) -> std::unique_ptr<Engine> {
        return std::make_unique<PeerEngine>(contestant, task);
    };
    auto const pile = [](physics::Scene const& scene, int iterations) -> std::unique_ptr<Pile> {
        return std::make_unique<PeerPile>(scene, iterations);
    };
    return make_known({name, start, pile, pile_settings});
}

}  // namespace bench
