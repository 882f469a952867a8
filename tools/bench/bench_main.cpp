// smb2d_bench: speed against accuracy of every method and of two engines from Debian, as tables for gnuplot.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "bench_maps.h"

namespace {

using bench::Case;
using bench::Contestant;

struct Options {
    std::string lab = SMB2D_LAB;
    std::string out = "out/bench";
    std::string only;
    bool quick = false;
};

struct Row {
    std::string scene;
    Contestant contestant;
    bench::Errors errors;
    bench::Costs costs;
};

std::ofstream table(Options const& options, std::string const& name) {
    std::filesystem::create_directories(options.out);
    std::ofstream file(std::filesystem::path(options.out) / name);
    if (!file) throw std::runtime_error(options.out + "/" + name + ": cannot be written");
    return file;
}

std::vector<double> rates_for(Options const& options) {
    if (options.quick) return {60, 240, 960};
    return {60, 120, 240, 480, 960, 1920, 3840, 7680};
}

std::vector<Row> rows_of(Case const& scene, Options const& options) {
    bench::Effort const effort = options.quick ? bench::Effort{8, 5, 0.05} : bench::Effort{};
    std::vector<bench::Start> starts;
    for (int i = 0; i < effort.starts; ++i) starts.push_back(scene.start(i));
    std::vector<Contestant> contestants = bench::our_methods(rates_for(options));
    for (Contestant const& peer : bench::peers(rates_for(options))) contestants.push_back(peer);
    for (Contestant const& peer : bench::peers_on_finer_pieces({240, 960}))
        if (!options.quick) contestants.push_back(peer);
    std::vector<Row> rows;
    for (Contestant const& contestant : contestants) {
        if (contestant.method.find(" on ") != std::string::npos && !scene.arcs) continue;
        rows.push_back({scene.name, contestant, bench::errors_of(contestant, starts),
                        bench::costs_of(contestant, starts[0].task, effort)});
    }
    return rows;
}

void write_rows(std::vector<Row> const& rows, std::ostream& to) {
    to << "# errors in m over the jittered starts (nan: failed), costs in ns per simulated second\n"
       << "# scene\tmethod\tsetting\trate\trecommended\tmedian\tp95\tfailed\tsampled\tunsampled\n";
    for (Row const& row : rows)
        to << row.scene << '\t' << row.contestant.method << '\t' << row.contestant.setting << '\t'
           << row.contestant.rate << '\t' << row.contestant.recommended << '\t' << row.errors.median << '\t'
           << row.errors.high << '\t' << row.errors.failed << '\t' << row.costs.sampled << '\t' << row.costs.unsampled
           << '\n';
}

constexpr double wanted[] = {16.0 / 1280, 1e-6, 1e-10};  // m; the first is a pixel of a level 16 m wide at 1280

// By scene and method, the cheapest way there, ns per simulated second; never is infinite.
void write_reach(std::vector<Row> const& rows, std::ostream& to) {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, std::array<double, 3>> least;
    for (Row const& row : rows) {
        std::string const& method = row.contestant.method;
        auto const key = std::make_pair(row.scene, method.substr(0, method.find(" on ")));
        if (method == "exact on pieces") continue;
        if (!least.contains(key)) {
            order.push_back(key);
            least[key].fill(INFINITY);
        }
        for (int i = 0; i < 3; ++i)
            if (row.errors.high <= wanted[i]) least[key][i] = std::min(least[key][i], row.costs.sampled);
    }
    to << "# ns per simulated second sampled at 60 Hz, to be within so many metres in 95 % of the starts\n"
       << "# scene\tmethod\t" << wanted[0] << '\t' << wanted[1] << '\t' << wanted[2] << '\n';
    for (auto const& key : order) {
        to << key.first << '\t' << key.second;
        for (double const cost : least[key]) std::isinf(cost) ? to << "\tnever" : to << '\t' << cost;
        to << '\n';
    }
}

constexpr double rounding_of_closed_forms = 1e-16;  // m: a few roundings of 64 bits at 1000 m

void measure_scenes(Options const& options) {
    std::vector<Row> rows;
    std::ofstream references = table(options, "references.tsv");
    references << "# scene\treference\tuncertainty in m\n";
    double const integrated = bench::uncertainty_of_integration(options.lab);
    std::vector<Case> const cases = bench::cases_in(options.lab);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!options.only.empty() && options.only != cases[i].name) continue;
        std::cerr << "scene " << i + 1 << " of " << cases.size() << ": " << cases[i].name << '\n';
        references << cases[i].name << '\t' << cases[i].reference << '\t'
                   << (cases[i].arcs ? integrated : rounding_of_closed_forms) << '\n';
        for (Row const& row : rows_of(cases[i], options)) rows.push_back(row);
    }
    std::ofstream results = table(options, "results.tsv"), reach = table(options, "reach.tsv");
    write_rows(rows, results);
    write_reach(rows, reach);
}

// At 60 steps a second, everyone as advised.
std::vector<Contestant> at_frame_rate() {
    std::vector<Contestant> contestants;
    for (Contestant const& ours : bench::our_methods({60}))
        if (ours.pieces == 0) contestants.push_back(ours);
    for (Contestant const& peer : bench::peers({60})) contestants.push_back(peer);
    return contestants;
}

void map_stability(Options const& options) {
    std::ofstream walls = table(options, "walls.tsv"), drag = table(options, "drag.tsv");
    bench::map_walls(at_frame_rate(), options.quick ? 20 : 60, options.quick ? 9 : 21, walls);
    bench::map_drag(at_frame_rate(), options.quick ? 24 : 72, options.quick ? 13 : 41, drag);
}

void measure_piles(Options const& options) {
    std::ofstream piles = table(options, "piles.tsv");
    if (options.quick)
        bench::chart_piles({10, 100, 300}, 4, piles);
    else
        bench::chart_piles({10, 30, 100, 300, 1000, 2000, 5000}, 12, piles);
}

void run(Options const& options) {
    bool const all = options.only.empty();
    if (options.only != "stability" && options.only != "piles") measure_scenes(options);
    if (all || options.only == "stability") map_stability(options);
    if (all || options.only == "piles") measure_piles(options);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App program(
        "Speed against accuracy: tables of every method, and of other engines, on the scenes of assets/lab");
    program.add_option("--lab", options.lab, "where the scenes are")->type_name("FOLDER");
    program.add_option("-o,--out", options.out, "where the tables go (default: out/bench)")->type_name("FOLDER");
    program.add_option("--only", options.only, "one scene, or `stability`, or `piles`")->type_name("NAME");
    program.add_flag("--quick", options.quick, "a glance, in less than a minute");
    program.footer("Example: smb2d_bench --quick --out out/bench");
    CLI11_PARSE(program, argc, argv);
    try {
        run(options);
    } catch (std::exception const& error) {
        std::cerr << "smb2d_bench: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
