// Draws levels by seed, plays them and prints what is wrong: `hunter --kind arcs --seeds 0 1000`.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/run_file.h"
#include "hunt/judge.h"
#include "hunt/kinds.h"

namespace {

struct Wishes {
    std::vector<std::string> kinds;     // none = all
    std::uint64_t from = 0, to = 1000;  // seeds, `to` excluded
    std::string method = "exact";
    std::string folder;  // empty: nothing is written
};

char const usage[] = "usage: hunter [--kind KIND]... [--seeds FROM TO] [--method exact|steps] [--write FOLDER]\n";

std::uint64_t whole_number(std::string const& text) {
    std::size_t used = 0;
    std::uint64_t const number = std::stoull(text, &used);
    if (used != text.size()) throw std::invalid_argument(text);
    return number;
}

Wishes wishes_in(std::vector<std::string> const& words) {
    Wishes wishes;
    for (std::size_t i = 0; i < words.size(); ++i) {
        auto const value = [&] {
            if (i + 1 == words.size()) throw std::invalid_argument(words[i] + " wants a value");
            return words[++i];
        };
        if (words[i] == "--kind") {
            wishes.kinds.push_back(value());
        } else if (words[i] == "--seeds") {
            wishes.from = whole_number(value());
            wishes.to = whole_number(value());
        } else if (words[i] == "--method") {
            wishes.method = value();
        } else if (words[i] == "--write") {
            wishes.folder = value();
        } else {
            throw std::invalid_argument("no such option: " + words[i]);
        }
    }
    if (wishes.kinds.empty()) wishes.kinds = hunt::kind_names();
    if (wishes.method != "exact" && wishes.method != "steps")
        throw std::invalid_argument("no such method: " + wishes.method);
    return wishes;
}

void write(hunt::Sketch const& sketch, Wishes const& wishes, std::string const& name) {
    std::filesystem::create_directories(wishes.folder);
    std::string const file = wishes.folder + "/" + name + ".svg";
    std::ofstream(file, std::ios::binary) << hunt::svg_of(sketch);
    if (sketch.inputs.empty()) return;
    game::Run run;
    run.level_file = file;
    run.method_name = wishes.method;
    run.duration = sketch.duration;
    run.inputs = sketch.inputs;
    game::write_run(run, wishes.folder + "/" + name + ".json");
}

struct Tally {
    long long cases = 0, failed = 0, events = 0;
    double busiest = 0, slowest = 0, worst_row = 0;
    std::map<std::string, int> wrongs;
};

void print(std::string const& kind, std::uint64_t seed, hunt::Verdict const& verdict) {
    std::printf("%s %llu", kind.c_str(), static_cast<unsigned long long>(seed));
    for (hunt::Finding const& finding : verdict.findings)
        std::printf(" %s %.3g at %.6g s%s%s", name_of(finding.wrong), finding.measured, finding.time,
                    finding.words.empty() ? "" : ": ", finding.words.c_str());
    std::printf("\n");
    std::fflush(stdout);
}

void add(Tally& tally, hunt::Verdict const& verdict) {
    ++tally.cases;
    tally.events += verdict.events;
    tally.busiest = std::max(tally.busiest, verdict.busiest);
    tally.slowest = std::max(tally.slowest, verdict.seconds);
    tally.worst_row = std::max(tally.worst_row, verdict.worst_row);
    tally.failed += !verdict.findings.empty();
    for (hunt::Finding const& finding : verdict.findings) ++tally.wrongs[name_of(finding.wrong)];
}

void print(std::string const& kind, Tally const& tally) {
    std::printf("# %s: %lld of %lld fail, %lld events, %.0f in 0.1 s, %.3g s for a run, %.3g s for a row;",
                kind.c_str(), tally.failed, tally.cases, tally.events, tally.busiest, tally.slowest, tally.worst_row);
    for (auto const& [wrong, times] : tally.wrongs) std::printf(" %s %d", wrong.c_str(), times);
    std::printf("\n");
    std::fflush(stdout);
}

bool hunt_down(Wishes const& wishes) {
    physics::Method const method =
        wishes.method == "exact" ? physics::Method(physics::Exact{}) : physics::Method(physics::Steps{});
    long long failed = 0;
    for (std::string const& kind : wishes.kinds) {
        Tally tally;
        for (std::uint64_t seed = wishes.from; seed < wishes.to; ++seed) {
            hunt::Sketch const sketch = hunt::sketch_of(kind, seed);
            hunt::Verdict const verdict = hunt::judged(sketch, method, hunt::Clock::judged);
            add(tally, verdict);
            if (verdict.findings.empty()) continue;
            print(kind, seed, verdict);
            if (!wishes.folder.empty()) write(sketch, wishes, kind + "-" + std::to_string(seed));
        }
        print(kind, tally);
        failed += tally.failed;
    }
    return failed == 0;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        return hunt_down(wishes_in({arguments + 1, arguments + count})) ? 0 : 1;
    } catch (std::invalid_argument const& error) {
        std::fprintf(stderr, "hunter: %s; %s", error.what(), usage);
        return 2;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "hunter: %s\n", error.what());
        return 1;
    }
}
