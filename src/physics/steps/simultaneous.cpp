#include "physics/steps/simultaneous.h"

#include <algorithm>
#include <cmath>

namespace physics {

namespace {

constexpr double rounding = 1e-9;    // share of what is wanted most: lacking less is rounding, at mass ratios to 1e6
constexpr double dependent = 1e-13;  // share of a contact's own yield: with less left it says what others say
constexpr int most_changes = 8;      // of the set of contacts that push, for each contact

// A square matrix, row by row.
struct Matrix {
    std::size_t size = 0;
    std::vector<double> entries;
    explicit Matrix(std::size_t n) : size(n), entries(n * n, 0.0) {}
    double& at(std::size_t i, std::size_t j) { return entries[i * size + j]; }
    double at(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

// What a unit push at `b` makes of `a`.
double response(ContactPush const& a, ContactPush const& b) {
    double const cosine = geometry::dot(a.normal, b.normal);
    double sum = 0;
    if (a.second == b.second) sum += a.second_yield * cosine;
    if (a.second == b.first) sum -= a.second_yield * cosine;
    if (a.first < 0) return sum;
    if (a.first == b.first) sum += a.first_yield * cosine;
    if (a.first == b.second) sum -= a.first_yield * cosine;
    return sum;
}

Matrix responses(std::vector<ContactPush> const& pushes) {
    Matrix matrix(pushes.size());
    for (std::size_t i = 0; i < pushes.size(); ++i)
        for (std::size_t j = 0; j < pushes.size(); ++j) matrix.at(i, j) = response(pushes[i], pushes[j]);
    return matrix;
}

// The pushes with which just the chosen contacts get what they want, by Cholesky's factors; nothing where the last of
// them depends on the others.
std::vector<double> solved(Matrix const& a, std::vector<ContactPush> const& pushes,
                           std::vector<std::size_t> const& chosen) {
    std::size_t const n = chosen.size();
    Matrix factor(n);
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double left = a.at(chosen[i], chosen[j]);
            for (std::size_t k = 0; k < j; ++k) left -= factor.at(i, k) * factor.at(j, k);
            if (i == j && left <= dependent * a.at(chosen[i], chosen[i])) return {};
            factor.at(i, j) = i == j ? std::sqrt(left) : left / factor.at(j, j);
        }
        x[i] = pushes[chosen[i]].wanted;
        for (std::size_t k = 0; k < i; ++k) x[i] -= factor.at(i, k) * x[k];
        x[i] /= factor.at(i, i);
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) x[i] -= factor.at(k, i) * x[k];
        x[i] /= factor.at(i, i);
    }
    return x;
}

// The contacts that push, as they become known (Lawson and Hanson, Solving Least Squares Problems, chapter 23).
struct PushSearch {
    Matrix matrix;
    std::vector<double> push;
    std::vector<std::size_t> chosen;
    std::vector<char> barred;  // they depend on those chosen
};

// The contact that lacks most of what it wants, or none.
std::size_t most_lacking(PushSearch const& search, std::vector<ContactPush> const& pushes, double least) {
    std::size_t const n = pushes.size();
    std::size_t found = n;
    for (std::size_t i = 0; i < n; ++i) {
        if (search.barred[i] || std::count(search.chosen.begin(), search.chosen.end(), i) > 0) continue;
        double lacking = pushes[i].wanted;
        for (std::size_t const j : search.chosen) lacking -= search.matrix.at(i, j) * search.push[j];
        if (lacking <= least) continue;
        least = lacking;
        found = i;
    }
    return found;
}

// Goes towards the solution of the chosen contacts as far as none pulls; answers whether it got there.
bool approach(PushSearch& search, std::vector<double> const& goal) {
    double share = 1;
    for (std::size_t k = 0; k < goal.size(); ++k) {
        double const now = search.push[search.chosen[k]];
        if (goal[k] <= 0 && now > goal[k]) share = std::min(share, now / (now - goal[k]));
    }
    bool const there = share == 1 && *std::min_element(goal.begin(), goal.end()) > 0;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < goal.size(); ++k) {
        std::size_t const i = search.chosen[k];
        double const now = search.push[i], next = there ? goal[k] : now + share * (goal[k] - now);
        bool const stays = there || goal[k] > 0 || next > rounding * now;
        search.push[i] = stays ? next : 0;
        if (stays) kept.push_back(i);
        if (!stays && now > 0) std::fill(search.barred.begin(), search.barred.end(), char{0});
        if (!stays && now == 0) search.barred[i] = 1;
    }
    search.chosen = kept;
    return there;
}

}  // namespace

std::vector<double> least_pushes(std::vector<ContactPush> const& pushes) {
    std::size_t const n = pushes.size();
    double most = 0;
    for (ContactPush const& push : pushes) most = std::max(most, push.wanted);
    PushSearch search{responses(pushes), std::vector<double>(n, 0.0), {}, std::vector<char>(n, 0)};
    for (std::size_t change = 0; change < most_changes * n; ++change) {
        std::size_t const next = most_lacking(search, pushes, rounding * most);
        if (next == n) break;
        search.chosen.push_back(next);
        while (!search.chosen.empty()) {
            std::vector<double> const goal = solved(search.matrix, pushes, search.chosen);
            if (goal.empty()) {
                search.barred[search.chosen.back()] = 1;
                search.push[search.chosen.back()] = 0;
                search.chosen.pop_back();
                continue;
            }
            std::size_t const before = search.chosen.size();
            if (approach(search, goal) || search.chosen.size() == before) break;
        }
    }
    return search.push;
}

}  // namespace physics
