// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A listing for a language whose functions have no local variables: values are computed in steps,
// and each step is a function that passes what it was given, and what it computes, to the next one.

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "bridge/text/listing.hpp"

namespace balcony::bridge {

/// The names of the point of the picture in the lines of a listing: not x and y, because POV-Ray
/// takes x and u, or y and v, for the same if they are parameters of one function.
inline constexpr std::string_view point_x = "column";
inline constexpr std::string_view point_y = "row";

/// The parameters of a function, and the lines whose values it computes from them.
struct ChainStep {
    std::vector<std::string> parameters;
    std::vector<const ListedLine*> lines;
};

/// Computes each line that the results need exactly once.
struct FunctionChain {
    std::vector<ChainStep> steps;
    std::vector<std::string> result_parameters;

    /// The largest number of parameters of a function of the chain.
    [[nodiscard]] std::size_t max_parameters() const;
};

/// The lines of a listing, which must outlive it, with what they depend on.
class LineDependence {
public:
    explicit LineDependence(const Listing& listing);

    /// The lines that do not depend on the point of the picture, in their order.
    [[nodiscard]] std::vector<const ListedLine*> uniform() const;
    /// Those of some names that depend on the point of the picture: first its own, then those of
    /// lines in their order.
    [[nodiscard]] std::vector<std::string> varying(const std::set<std::string>& names) const;

    [[nodiscard]] FunctionChain chain(std::span<const ListedLine> results) const;

private:
    struct Placed {
        const ListedLine* line = nullptr;
        std::size_t section = 0;
        std::size_t depth = 0;  ///< How many lines of its section it needs one after the other.
        bool uniform = true;
    };

    void place(const ListedLine& line, std::size_t section);

    std::vector<Placed> lines_;
    std::map<std::string, std::size_t> index_;
};

}  // namespace balcony::bridge
