#pragma once

namespace geometry {

// One function for each alternative of a variant, for std::visit.
template <typename... Cases>
struct Match : Cases... {
    using Cases::operator()...;
};
template <typename... Cases>
Match(Cases...) -> Match<Cases...>;

}  // namespace geometry
