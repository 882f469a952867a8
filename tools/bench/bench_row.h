// Rows: a contestant on a scene, and the tables that are made of many.
#pragma once

#include <ostream>

#include "bench_measure.h"

namespace bench {

struct Row {
    std::string scene;
    Contestant contestant;
    Errors errors;
    Costs costs;
    bool best = false;  // of its engine on this scene: the least error, then the least cost
};

// The method or the engine, whatever it is run on.
std::string engine_of(Contestant const& contestant);

void mark_the_best(std::vector<Row>& rows);

void write_rows(std::vector<Row> const& rows, std::ostream& to);

// By scene and method, the cheapest way to be within a pixel, a micrometre, a tenth of a nanometre.
void write_reach(std::vector<Row> const& rows, std::ostream& to);

// By scene, what nobody beats in both error and cost: the Pareto front, the most accurate first, as the corners of a
// staircase that begins and ends beyond any chart.
void write_front(std::vector<Row> const& rows, std::ostream& to);

// By scene and who steps, the slope of error against step on logarithmic scales: the order of convergence.
void write_orders(std::vector<Row> const& rows, std::ostream& to);

// How many times cheaper the exact method is than each peer: as its makers advise, and at its least error.
void write_against_peers(std::vector<Row> const& rows, std::ostream& to);

}  // namespace bench
