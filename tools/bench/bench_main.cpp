// smb2d_bench: speed against accuracy of every method and of two engines from Debian, as tables for gnuplot.
#include <iostream>

#include <CLI/CLI.hpp>

#include "bench_level.h"
#include "bench_maps.h"
#include "bench_part.h"

namespace {

using bench::Contestant;

struct Options {
    std::string lab = SMB2D_LAB;
    bench::Tables tables{"out/bench"};
    std::string level, only;
    std::optional<double> seconds;
    bool quick = false;
    bench::Report report = bench::Report::progress;

    bool wants(std::string const& name) const { return only.empty() || only == name; }
    bench::Effort effort() const { return quick ? bench::Effort{8, 5, 2e4} : bench::Effort{}; }
};

std::vector<double> rates_for(Options const& options) {
    if (options.quick) return {60, 240, 960};
    return {60, 120, 240, 480, 960, 1920, 3840, 7680};
}

bench::Contest contest_for(Options const& options) {
    bench::Contest contest{{}, bench::our_methods(rates_for(options)), options.effort()};
    for (bench::Case const& scene : bench::cases_in(options.lab))
        if (options.wants(scene.name)) contest.cases.push_back(scene);
    for (Contestant const& peer : bench::peers(rates_for(options))) contest.contestants.push_back(peer);
    for (Contestant const& peer : bench::peers_on_finer_pieces({240, 960}))
        if (!options.quick) contest.contestants.push_back(peer);
    if (!contest.cases.empty()) contest.uncertainty = bench::uncertainty_of_integration(options.lab);
    return contest;
}

// What is timed.
std::vector<bench::Part> parts_for(Options const& options) {
    bool const quick = options.quick;
    std::vector<bench::Part> parts;
    if (auto const contest = contest_for(options); !contest.cases.empty()) parts.push_back(contest_part(contest));
    if (options.wants("needs")) parts.push_back(bench::needs_part(options.effort()));
    if (options.wants("numbers"))
        parts.push_back(quick ? bench::numbers_part(options.lab, {1, 10, 100}, {10, 1000}, {32, 512}, options.effort())
                              : bench::numbers_part(options.lab, {1, 2, 5, 10, 20, 50, 100, 200, 500},
                                                    {10, 30, 100, 300, 1000, 3000, 10000},
                                                    {32, 64, 128, 256, 512, 1024, 2048}, options.effort()));
    if (options.wants("piles"))
        parts.push_back(quick ? bench::piles_part({10, 100, 300}, 4)
                              : bench::piles_part({10, 30, 100, 300, 1000, 2000, 5000}, 12));
    return parts;
}

// At 60 steps a second, everyone as advised.
std::vector<Contestant> at_frame_rate() {
    std::vector<Contestant> contestants;
    for (Contestant const& ours : bench::our_methods({60}))
        if (ours.pieces == 0) contestants.push_back(ours);
    for (Contestant const& peer : bench::peers({60})) contestants.push_back(peer);
    return contestants;
}

// What is not. Says whether there was anything.
bool draw_maps(Options const& options) {
    bool const quick = options.quick, stability = options.wants("stability"), energy = options.wants("energy");
    if (stability) {
        std::ofstream walls = options.tables.open("walls.tsv"), drag = options.tables.open("drag.tsv"),
                      stacks = options.tables.open("stacks.tsv");
        bench::map_walls(at_frame_rate(), quick ? 20 : 60, quick ? 9 : 21, walls);
        bench::map_drag(at_frame_rate(), quick ? 24 : 72, quick ? 13 : 41, drag);
        if (quick)
            bench::map_stacks({1, 5, 20}, {1, 20, 400}, 4, stacks);
        else
            bench::map_stacks({1, 2, 3, 5, 7, 10, 15, 20, 30, 40, 50}, {1, 2, 5, 10, 20, 50, 100, 200, 400}, 10,
                              stacks);
    }
    if (energy) {
        std::ofstream changes = options.tables.open("energy.tsv");
        bench::chart_energy(options.lab, at_frame_rate(), quick ? 20 : 60, changes);
    }
    return stability || energy;
}

void run(Options const& options) {
    if (!options.level.empty()) {
        bench::measure_level({options.level, options.seconds, rates_for(options), options.effort(), options.report},
                             options.tables, std::cout);
        return;
    }
    std::vector<bench::Part> const parts = parts_for(options);
    std::vector<bench::Timed> benchmarks;
    for (bench::Part const& part : parts)
        benchmarks.insert(benchmarks.end(), part.benchmarks.begin(), part.benchmarks.end());
    bench::Times const times = bench::least_times(benchmarks, options.report);
    if (!times.empty())
        for (bench::Part const& part : parts) part.write(times, options.tables);
    if (options.report == bench::Report::table) return;  // who filters benchmarks wants no maps
    if (!draw_maps(options) && parts.empty())
        throw std::invalid_argument(options.only + ": there is no such scene or part");
}

constexpr char flag_prefix[] = "--benchmark_";

// The words of the command line that are Google Benchmark's, taken out.
std::vector<std::string> taken_flags(std::vector<std::string>& words) {
    auto const is_ours = [](std::string const& word) { return word.rfind(flag_prefix, 0) != 0; };
    auto const first = std::stable_partition(words.begin(), words.end(), is_ours);
    std::vector<std::string> const flags(first, words.end());
    words.erase(first, words.end());
    return flags;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App program(
        "Speed against accuracy: tables of every method, and of other engines, on the scenes of assets/lab");
    program.add_option("level", options.level, "a level or a run of your own: our methods on it alone")
        ->type_name("LEVEL|RUN");
    program.add_option("--seconds", options.seconds, "of a level of your own (default: the run's duration, else 10)")
        ->type_name("S")
        ->check(CLI::Range(0.1, 1000.0));
    program.add_option("--lab", options.lab, "where the scenes are")->type_name("FOLDER");
    program.add_option("-o,--out", options.tables.folder, "where the tables go (default: out/bench)")
        ->type_name("FOLDER");
    program.add_option("--only", options.only, "one scene, or needs, numbers, piles, stability, energy")
        ->type_name("NAME");
    program.add_flag("--quick", options.quick, "a glance, in less than a minute");
    program.footer(
        "The flags of Google Benchmark hold too: --benchmark_filter=REGEX, --benchmark_list_tests, "
        "--benchmark_out=FILE "
        "and so on.\nExample: smb2d_bench my-level.svg --seconds 5");
    try {
        std::vector<std::string> words(argv + 1, argv + argc);
        std::vector<std::string> const flags = taken_flags(words);
        std::reverse(words.begin(), words.end());  // as CLI11 wants them
        program.parse(words);
        if (!flags.empty()) {
            bench::heed_flags(flags);
            options.report = bench::Report::table;
        }
        run(options);
    } catch (CLI::ParseError const& error) {
        if (error.get_exit_code() == 0) return program.exit(error);
        std::cerr << "smb2d_bench: " << error.what() << '\n';
        return 2;
    } catch (std::invalid_argument const& error) {
        std::cerr << "smb2d_bench: " << error.what() << '\n';
        return 2;
    } catch (std::exception const& error) {
        std::cerr << "smb2d_bench: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
