// A population of scenes drawn at random, for fitting and judging advice: kinds with a closed form, and kinds without.
#pragma once

#include <optional>

#include "bench_case.h"

namespace bench {

struct Member {
    std::string kind;
    Task task;
    std::optional<std::vector<Moment>> truth;  // by frame, where a closed form knows it
};

// A spring that nobody pulls at is no part of a scene.
Task without_idle_spring(Task task);

// So many scenes, kind by kind in turn; other seeds give other scenes.
std::vector<Member> population(unsigned seed, int count);

// Discs that fall on hilly ground.
Member few_of(int count, unsigned seed);

// Discs without gravity or friction in a square box, `side` to a row.
Member gas_of(int side, unsigned seed);

}  // namespace bench
