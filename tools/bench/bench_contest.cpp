#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>

#include "bench_part.h"
#include "bench_row.h"

namespace bench {

namespace {

constexpr double rounding_of_closed_forms = 1e-16;  // m: a few roundings of 64 bits at 1000 m

// A scene with what is known of it so far.
struct Heat {
    Case scene;
    Effort effort;
    std::vector<Start> starts;  // made when first needed
    std::vector<Row> rows;

    std::map<std::string, double> errors_in(std::size_t row) {
        for (int i = static_cast<int>(starts.size()); i < effort.starts; ++i) starts.push_back(scene.start(i));
        rows[row].errors = errors_of(rows[row].contestant, starts);
        return {{"median_m", rows[row].errors.median}, {"p95_m", rows[row].errors.high}};
    }
};

bool is_on_chords(Contestant const& contestant) { return contestant.method.find(" on ") != std::string::npos; }

// What it costs to be asked once is worth measuring where it is less, and for who is compared with that.
bool is_asked_once(Contestant const& contestant) {
    return contestant.method == "exact" || (contestant.recommended && !is_on_chords(contestant));
}

std::shared_ptr<Heat> heat_of(Case const& scene, Contest const& contest) {
    auto heat = std::make_shared<Heat>(Heat{scene, contest.effort, {}, {}});
    for (Contestant const& contestant : contest.contestants)
        if (scene.arcs || !is_on_chords(contestant)) heat->rows.push_back({scene.name, contestant, {}, {}});
    return heat;
}

void add_benchmarks(std::shared_ptr<Heat> const& heat, std::vector<Timed>& to) {
    Task const task = heat->scene.start(0).task;
    for (std::size_t i = 0; i < heat->rows.size(); ++i) {
        Contestant const& contestant = heat->rows[i].contestant;
        Timed sampled = sampled_run(heat->scene.name, contestant, task, heat->effort);
        // The starts for the errors are runs, too; on pieces all take much longer.
        sampled.work *= (1 + heat->effort.starts / double(sampled.repeats)) * (is_on_chords(contestant) ? 4 : 1);
        sampled.counters = [heat, i] { return heat->errors_in(i); };
        to.push_back(sampled);
        if (is_asked_once(contestant)) to.push_back(unsampled_run(heat->scene.name, contestant, task, heat->effort));
    }
}

// The rows that have been measured.
std::vector<Row> rows_of(Heat const& heat, Times const& times) {
    std::vector<Row> rows;
    for (Row row : heat.rows) {
        std::string const name = row.scene + '/' + row.contestant.method + '/' + row.contestant.setting;
        row.costs = {time_in(times, name), time_in(times, name + "/asked once")};
        if (!std::isnan(row.costs.sampled)) rows.push_back(row);
    }
    return rows;
}

}  // namespace

double time_in(Times const& times, std::string const& name) {
    auto const found = times.find(name);
    return found == times.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

std::ofstream Tables::open(std::string const& name) const {
    std::filesystem::create_directories(folder);
    std::ofstream file(std::filesystem::path(folder) / name);
    if (!file) throw std::runtime_error(folder + "/" + name + ": cannot be written");
    return file;
}

Part contest_part(Contest const& contest) {
    Part part;
    std::vector<std::shared_ptr<Heat>> heats;
    for (Case const& scene : contest.cases) {
        heats.push_back(heat_of(scene, contest));
        add_benchmarks(heats.back(), part.benchmarks);
    }
    part.write = [heats, uncertainty = contest.uncertainty](Times const& times, Tables const& tables) {
        std::ofstream references = tables.open("references.tsv");
        references << "# scene\treference\tuncertainty in m\n";
        std::vector<Row> rows;
        for (auto const& heat : heats) {
            references << heat->scene.name << '\t' << heat->scene.reference << '\t'
                       << (heat->scene.arcs ? uncertainty : rounding_of_closed_forms) << '\n';
            for (Row const& row : rows_of(*heat, times)) rows.push_back(row);
        }
        mark_the_best(rows);
        std::ofstream results = tables.open("results.tsv"), reach = tables.open("reach.tsv"),
                      front = tables.open("front.tsv"), orders = tables.open("orders.tsv"),
                      against = tables.open("against_peers.tsv");
        write_rows(rows, results);
        write_reach(rows, reach);
        write_front(rows, front);
        write_orders(rows, orders);
        write_against_peers(rows, against);
    };
    return part;
}

}  // namespace bench
