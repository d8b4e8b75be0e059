// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/pov_functions/spline_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::bridge {

namespace {

using expr::Table;

// The coefficients of a cell are in as many splines as vectors of four numbers are needed.
constexpr std::array members{"x", "y", "z", "t"};

class SplineTable {
public:
    SplineTable(const ListedTable& listed, std::string (*number)(double))
        : table_(*listed.table), name_(listed.name), number_(number) {
        for (const Table::Axis& axis : table_.axes) {
            cells_ *= axis.cells;
            coefficients_ *= axis.degree + 1;
        }
    }

    [[nodiscard]] std::string text() const {
        std::string made = "\n";
        for (std::size_t first = 0; first < coefficients_; first += members.size()) {
            made += spline(first);
        }
        return made + lookup();
    }

private:
    [[nodiscard]] std::string spline_name(std::size_t coefficient) const {
        return fmt::format("{}_numbers_{}", name_, coefficient / members.size() + 1);
    }

    [[nodiscard]] std::string spline(std::size_t first) const {
        std::vector<std::string> entries;
        // A spline has two entries or more.
        for (std::size_t key = 0; key < std::max<std::size_t>(cells_, 2); ++key) {
            const std::size_t cell = std::min(key, cells_ - 1);
            std::vector<std::string> vector;
            for (std::size_t i = first; i < first + members.size(); ++i) {
                vector.push_back(i < coefficients_
                                     ? number_(table_.coefficients[cell * coefficients_ + i])
                                     : "0");
            }
            entries.push_back(fmt::format("{}, <{}>", key, fmt::join(vector, ", ")));
        }
        return fmt::format("#declare {} = function {{ spline {{ linear_spline{} }} }}\n",
                           spline_name(first), wrapped(entries, 4));
    }

    // The number of the cell along each axis is k, and the position in it s = p - k.
    [[nodiscard]] std::string lookup() const {
        std::string cell;
        std::string places;
        for (std::size_t i = 0; i < table_.axes.size(); ++i) {
            const Table::Axis& axis = table_.axes[i];
            cell = i == 0 ? "k0" : fmt::format("({}) * {} + k{}", cell, axis.cells, i);
            places +=
                fmt::format("{}(a{} - {}) * {}", i == 0 ? "" : ", ", i, enclosed(axis.first),
                            number_(static_cast<double>(axis.cells) / (axis.last - axis.first)));
        }
        return fmt::format(
            "#declare {0}_in_cell = function(cell, {1}) {{ {2} }}\n"
            "#declare {0}_of_cell = function({3}, {4}) {{ {0}_in_cell({5}, {6}) }}\n"
            "#declare {0}_at = function({4}) {{ {0}_of_cell({7}, {4}) }}\n"
            "#declare {0} = function({8}) {{ {0}_at({9}) }}\n",
            name_, each("s{0}"), polynomial(0, 0), each("k{0}"), each("p{0}"), cell,
            each("p{0} - k{0}"), each("max(min(floor(p{0}), {1}), 0)"), each("a{0}"), places);
    }

    [[nodiscard]] std::string enclosed(double value) const {
        return value < 0.0 ? fmt::format("({})", number_(value)) : number_(value);
    }

    /// A text for every axis, with commas between them: {0} is its number, {1} its last cell.
    [[nodiscard]] std::string each(std::string_view pattern) const {
        std::string made;
        for (std::size_t i = 0; i < table_.axes.size(); ++i) {
            made += i == 0 ? "" : ", ";
            made += filled(pattern, {std::to_string(i), std::to_string(table_.axes[i].cells - 1)});
        }
        return made;
    }

    // By Horner's rule along an axis, with coefficients that are polynomials along the later ones.
    [[nodiscard]] std::string polynomial(std::size_t axis, std::size_t first) const {
        if (axis == table_.axes.size()) {
            return fmt::format("{}(cell).{}", spline_name(first), members[first % members.size()]);
        }
        std::size_t step = 1;
        for (std::size_t later = axis + 1; later < table_.axes.size(); ++later) {
            step *= table_.axes[later].degree + 1;
        }
        const std::size_t degree = table_.axes[axis].degree;
        std::string text = polynomial(axis + 1, first + degree * step);
        for (std::size_t power = degree; power-- > 0;) {
            text = fmt::format("({}) * s{} + {}", text, axis,
                               polynomial(axis + 1, first + power * step));
        }
        return axis == 0 ? text : fmt::format("({})", text);
    }

    const Table& table_;
    const std::string& name_;
    std::string (*const number_)(double);
    std::size_t cells_ = 1;
    std::size_t coefficients_ = 1;  ///< Of each cell.
};

}  // namespace

std::string spline_table(const ListedTable& table, std::string (*number)(double value)) {
    return SplineTable(table, number).text();
}

}  // namespace balcony::bridge
