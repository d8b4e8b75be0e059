// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/c_like.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace balcony::bridge {

namespace {

using expr::Table;

std::size_t coefficients_in_cell(const Table& table) {
    std::size_t count = 1;
    for (const Table::Axis& axis : table.axes) {
        count *= axis.degree + 1;
    }
    return count;
}

// Along an axis: the number of the cell as k, and the position in it as s.
std::string find_cell(const CLike& language, const Table::Axis& axis, std::size_t i) {
    const auto cells = static_cast<double>(axis.cells);
    std::string text =
        fmt::format("    {0}{1} p{2} = (a{2} - {3}) * {4};\n", language.constant, language.real, i,
                    language.number(axis.first), language.number(cells / (axis.last - axis.first)));
    text += fmt::format("    {0}{1} f{2} = {3}(p{2});\n", language.constant, language.real, i,
                        language.floor);
    text += fmt::format("    {0}{1} k{2} = f{2} > {3} ? (f{2} < {4} ? f{2} : {4}) : {3};\n",
                        language.constant, language.real, i, language.number(0.0),
                        language.number(cells - 1.0));
    if (axis.degree > 0) {
        text +=
            fmt::format("    {0}{1} s{2} = p{2} - k{2};\n", language.constant, language.real, i);
    }
    return text;
}

// A polynomial of a variable, with its coefficients by rising powers.
std::string horner(const std::vector<std::string>& coefficients, const std::string& variable) {
    std::string text = coefficients.back();
    for (std::size_t i = coefficients.size() - 1; i-- > 0;) {
        text = fmt::format("{} * {} + {}", i + 2 == coefficients.size() ? text : "(" + text + ")",
                           variable, coefficients[i]);
    }
    return text;
}

/// The value in a cell of a table: a polynomial in the last variable, and loops over the powers of
/// the ones before it, which shaders compile sooner than the sum of all terms.
class CellValue {
public:
    /// `number` is a pattern: the number of the table at an index.
    CellValue(const CLike& language, const Table& table, std::string number)
        : language_(language), table_(table), number_(std::move(number)) {}

    std::string run() {
        const std::string value = along(0, "at", "    ");
        return text_ + fmt::format("    return {};\n", value);
    }

private:
    // Along an axis and those behind it; `begin` is where their coefficients begin.
    std::string along(std::size_t axis, const std::string& begin, const std::string& margin) {
        const std::size_t degree = table_.axes[axis].degree;
        if (axis + 1 == table_.axes.size()) {
            std::vector<std::string> coefficients;
            for (std::size_t power = 0; power <= degree; ++power) {
                coefficients.push_back(
                    filled(number_, {power == 0 ? begin : fmt::format("{} + {}", begin, power)}));
            }
            return horner(coefficients, fmt::format("s{}", axis));
        }
        if (degree == 0) {
            return along(axis + 1, begin, margin);
        }
        std::size_t run = 1;
        for (std::size_t i = axis + 1; i < table_.axes.size(); ++i) {
            run *= table_.axes[i].degree + 1;
        }
        text_ +=
            fmt::format("{}{} v{} = {};\n", margin, language_.real, axis, language_.number(0.0));
        text_ +=
            fmt::format("{0}for (int i{1} = {2}; i{1} >= 0; i{1} -= 1) {{\n", margin, axis, degree);
        const std::string inner = margin + "    ";
        text_ += fmt::format("{}int at{} = {} + i{} * {};\n", inner, axis, begin, axis, run);
        const std::string term = along(axis + 1, fmt::format("at{}", axis), inner);
        text_ += fmt::format("{0}{1}{2} r{3} = {4};\n", inner, language_.constant, language_.real,
                             axis, term);
        text_ += fmt::format("{0}v{1} = i{1} == {2} ? r{1} : v{1} * s{1} + r{1};\n{3}}}\n", inner,
                             axis, degree, margin);
        return fmt::format("v{}", axis);
    }

    const CLike& language_;
    const Table& table_;
    const std::string number_;
    std::string text_;
};

// A function of the variables of a table that returns its value; `first` is where its numbers begin
// among those of all tables.
std::string table_function(const CLike& language, const ListedTable& listed, std::size_t first) {
    const Table& table = *listed.table;
    std::string parameters;
    for (std::size_t i = 0; i < table.axes.size(); ++i) {
        parameters += fmt::format("{}{} a{}", i == 0 ? "" : ", ", language.real, i);
    }
    std::string text =
        fmt::format("{}{} {}({}) {{\n", language.local, language.real, listed.name, parameters);
    std::string number = fmt::format("{}({} + {{0}})", language.table_numbers, first);
    if (language.table_numbers.empty()) {
        std::vector<std::string> values;
        for (const double value : table.coefficients) {
            values.push_back(language.number(value));
        }
        text += "    " + language.array("c", values) + "\n";
        number = "c[{0}]";
    }
    std::string cell;
    for (std::size_t i = 0; i < table.axes.size(); ++i) {
        text += find_cell(language, table.axes[i], i);
        const std::string k = filled(language.truncate, {fmt::format("k{}", i)});
        cell = i == 0 ? k : fmt::format("({}) * {} + {}", cell, table.axes[i].cells, k);
    }
    text += fmt::format("    int at = ({}) * {};\n", cell, coefficients_in_cell(table));
    return text + CellValue(language, table, number).run() + "}\n";
}

}  // namespace

std::string definitions(const CLike& language, const Listing& listing) {
    std::string text;
    bool above = true;  // There are lines above.
    for (const ListedSection& section : listing.sections) {
        text += fmt::format("{}    // {}\n", above ? "\n" : "", comment_line(section.comment));
        above = !section.lines.empty();
        for (const ListedLine& line : section.lines) {
            text += fmt::format("    {}{} {} = {};\n", language.constant,
                                line.condition ? language.condition : language.real, line.name,
                                line.text);
        }
    }
    return text;
}

std::string functions(const CLike& language, const Listing& listing) {
    std::string text;
    for (const std::string& helper : listing.helpers) {
        text += helper + "\n";
    }
    std::size_t first = 0;
    for (const ListedTable& listed : listing.tables) {
        text += table_function(language, listed, first) + "\n";
        first += listed.table->coefficients.size();
    }
    return text;
}

ParameterNames::ParameterNames(const std::vector<ExportParameter>& parameters, Names& names) {
    for (const ExportParameter& parameter : parameters) {
        names_.push_back(names.unique(parameter.name));
        inputs_.push_back(parameter.input);
    }
}

std::optional<std::size_t> ParameterNames::of_input(std::string_view input) const {
    const auto found = std::find(inputs_.begin(), inputs_.end(), input);
    return found == inputs_.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - inputs_.begin()));
}

std::vector<std::string> opening_lines(const ExportSource& source) {
    std::vector<std::string> lines{
        source.title.empty()
            ? fmt::format("{}: an extended camera, exported by Balcony.", source.camera.name())
            : fmt::format("{}: an extended camera, exported by Balcony from {}.",
                          source.camera.name(), source.title)};
    if (!source.comment.empty()) {
        lines.emplace_back();
        for (std::string& line : lines_of(source.comment)) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

std::string world(Axes axes) {
    return fmt::format("The world is right-handed, with {} up.", axes == Axes::z_up ? "z" : "y");
}

std::string commented(const std::vector<std::string>& lines, std::string_view mark) {
    std::string text;
    for (const std::string& line : lines) {
        text += fmt::format("{}{}{}\n", mark, line.empty() ? "" : " ", comment_line(line));
    }
    return text;
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    return lines;
}

}  // namespace balcony::bridge
