// Replays runs and writes anew what they claim: the level's hash, the method and settings, and the final state.
//
//     claim_run RUN...
#include <cstdio>
#include <memory>

#include "game/method_choice.h"
#include "game/run_file.h"
#include "game/session.h"

namespace {

void claim(std::string const& file) {
    game::Run const run = game::read_run(file);
    auto const level = std::make_shared<level::Level const>(level::read_level(run.level_file));
    physics::Method const method = game::method_for({run.method_name, run.rate}, level->scene);
    game::Session session = game::session_of(level, method, run.inputs, file);
    double const end = run.duration.value_or(run.final ? run.final->time : 10);
    game::advance(session, end);
    game::Run claimed = run;
    claimed.level_hash = level->hash;
    claimed.method_name = physics::name_of(method);
    claimed.rate = game::rate_of(method);
    claimed.duration = end;
    claimed.final = game::Run::Final{end, game::state_hash(session, end)};
    game::write_run(claimed, file);
    game::Status const status = game::status_at(session, end);
    std::printf("%s: %s, goal %s, %d bananas, %d pulls%s\n", file.c_str(), claimed.method_name->c_str(),
                status.goal_time ? (std::to_string(*status.goal_time) + " s").c_str() : "not reached", status.bananas,
                status.pulls,
                run.final && run.final->state_hash == claimed.final->state_hash ? "" : ", another final state");
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) {
        std::fprintf(stderr, "usage: claim_run RUN...\n");
        return 2;
    }
    try {
        for (int i = 1; i < count; ++i) claim(words[i]);
        return 0;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "claim_run: %s\n", error.what());
        return 1;
    }
}
