// Draws levels by seed, plays them and prints what is wrong: `hunter --kind arcs --seeds 0 1000`.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/run_file.h"
#include "hunt/apart.h"
#include "hunt/judge.h"
#include "hunt/kinds.h"
#include "hunt/shrink.h"

namespace {

struct Wishes {
    std::vector<std::string> kinds;     // none = all
    std::uint64_t from = 0, to = 1000;  // seeds, `to` excluded
    double seconds = 0;                 // s, how long to go on from `from`; 0: up to `to`
    std::size_t jobs = 1;
    std::string method = "exact";
    bool cut = true;     // what is written
    std::string folder;  // where what fails is written, cut down; empty: nowhere
};

char const usage[] =
    "hunter [--kind KIND]... [--seeds FROM TO] [--for SECONDS] [--jobs N] [--method exact|steps] [--write FOLDER] [--uncut]";

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
        } else if (words[i] == "--for") {
            wishes.seconds = static_cast<double>(whole_number(value()));
        } else if (words[i] == "--jobs") {
            wishes.jobs = std::max<std::size_t>(1, whole_number(value()));
        } else if (words[i] == "--method") {
            wishes.method = value();
        } else if (words[i] == "--uncut") {
            wishes.cut = false;
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

physics::Method method_of(Wishes const& wishes) {
    return wishes.method == "exact" ? physics::Method(physics::Exact{}) : physics::Method(physics::Steps{});
}

// The same kind of failure, and not a tenth of it.
hunt::Sketch cut_down(hunt::Sketch const& sketch, hunt::Finding const& finding, physics::Method const& method) {
    bool const of_time = finding.wrong == hunt::Wrong::slow || finding.wrong == hunt::Wrong::stall;
    hunt::Clock const clock = of_time ? hunt::Clock::judged : hunt::Clock::ignored;
    return hunt::shrunk(sketch, finding.time, [&](hunt::Sketch const& smaller) {
        auto const verdict = hunt::Errand([&] { return hunt::judged(smaller, method, clock); }).finish();
        return std::any_of(verdict.findings.begin(), verdict.findings.end(), [&](hunt::Finding const& other) {
            return other.wrong == finding.wrong && other.measured >= finding.measured / 10;
        });
    });
}

// A case and the child that judges it.
struct Chase {
    std::string kind;
    std::uint64_t seed = 0;
    hunt::Errand errand;
};

Chase chase(std::string const& kind, std::uint64_t seed, Wishes const& wishes) {
    return {kind, seed, hunt::Errand([&] {
                hunt::Sketch const sketch = hunt::sketch_of(kind, seed);
                hunt::Verdict const verdict = hunt::judged(sketch, method_of(wishes), hunt::Clock::judged);
                if (!verdict.findings.empty() && !wishes.folder.empty())
                    write(wishes.cut ? cut_down(sketch, verdict.findings.front(), method_of(wishes)) : sketch, wishes,
                          kind + "-" + std::to_string(seed));
                return verdict;
            })};
}

class Hunt {
public:
    explicit Hunt(Wishes const& wishes) : wishes_(wishes) {}

    // Whether nothing failed.
    bool down() {
        auto const start = std::chrono::steady_clock::now();
        auto const is_over = [&](std::uint64_t seed) {
            if (wishes_.seconds == 0) return seed >= wishes_.to;
            return std::chrono::steady_clock::now() - start > std::chrono::duration<double>(wishes_.seconds);
        };
        for (std::uint64_t seed = wishes_.from; !is_over(seed); ++seed)
            for (std::string const& kind : wishes_.kinds) {
                while (chases_.size() >= wishes_.jobs) finish_one();
                chases_.push_back(chase(kind, seed, wishes_));
            }
        while (!chases_.empty()) finish_one();
        for (auto const& [kind, tally] : tallies_) print(kind, tally);
        return std::all_of(tallies_.begin(), tallies_.end(), [](auto const& each) { return each.second.failed == 0; });
    }

private:
    void finish_one() {
        Chase& first = chases_.front();
        hunt::Verdict const verdict = first.errand.finish();
        add(tallies_[first.kind], verdict);
        if (!verdict.findings.empty()) {
            print(first.kind, first.seed, verdict);
            if (verdict.findings.front().wrong == hunt::Wrong::no_end && !wishes_.folder.empty())
                write(hunt::sketch_of(first.kind, first.seed), wishes_, first.kind + "-" + std::to_string(first.seed));
        }
        chases_.pop_front();
    }

    Wishes wishes_;
    std::deque<Chase> chases_;
    std::map<std::string, Tally> tallies_;
};

}  // namespace

int main(int count, char** arguments) {
    try {
        return Hunt(wishes_in({arguments + 1, arguments + count})).down() ? 0 : 1;
    } catch (std::invalid_argument const& error) {
        std::fprintf(stderr, "hunter: %s; usage: %s\n", error.what(), usage);
        return 2;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "hunter: %s\n", error.what());
        return 1;
    }
}
