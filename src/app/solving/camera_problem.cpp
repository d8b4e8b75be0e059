// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/camera_problem.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "camera/catalogue/parameter_text.hpp"

namespace balcony::app {

namespace {

using lang::OpenParameter;

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> names_of(const std::vector<OpenParameter>& parameters) {
    std::vector<std::string> names;
    for (const OpenParameter& one : parameters) {
        names.push_back(one.name);
    }
    return names;
}

void check_names(const std::vector<Marks::Parameter>& named, const lang::OpenCamera& camera,
                 bool to_be_found, Diagnostics& found) {
    std::vector<std::string> numbers = names_of(camera.open);
    std::vector<std::string> all = numbers;
    all.insert(all.end(), camera.closed.begin(), camera.closed.end());
    const std::vector<std::string> closed = names_of(camera.numbers);
    numbers.insert(numbers.end(), closed.begin(), closed.end());
    for (const Marks::Parameter& one : named) {
        if (!has(all, one.name)) {
            found.push_back(error(fmt::format("the camera '{}' has no parameter '{}'",
                                              camera.camera.name(), one.name),
                                  one.written,
                                  all.empty() ? "it has no parameters"
                                              : suggestion(one.name, all, "its parameters are")));
        } else if (to_be_found && !has(numbers, one.name)) {
            found.push_back(
                error(fmt::format("the parameter '{}' cannot be found, since it is not one number",
                                  one.name),
                      one.written,
                      numbers.empty() ? "no parameter of this camera is"
                                      : fmt::format("those that can are {}", all_of(numbers))));
        }
    }
}

const Marks::Parameter* find(const Marks& marks, std::string_view name) {
    if (marks.unknowns) {
        for (const Marks::Parameter& one : *marks.unknowns) {
            if (one.name == name) {
                return &one;
            }
        }
    }
    return nullptr;
}

// What a file says of a parameter, in the unit that the parameter has.
class Details {
public:
    Details(const OpenParameter& parameter, Diagnostics& found)
        : parameter_(parameter), found_(found) {}

    [[nodiscard]] double in_unit(const Marks::Number& number) {
        if (number.value != 0.0 && number.is_angle != parameter_.is_angle) {
            has_its_unit_ = false;
            found_.push_back(error(
                fmt::format("'{}' is {}, but this is {}", parameter_.name,
                            parameter_.is_angle ? "an angle" : "a plain number",
                            number.is_angle ? "an angle" : "a plain number"),
                number.written,
                parameter_.is_angle ? "append deg or rad: 30deg, 0.5rad" : "remove deg or rad"));
        }
        return number.value;
    }

    [[nodiscard]] solve::Unknown unknown(const Marks::Parameter* described, bool is_open) {
        solve::Unknown made{is_open ? lang::parameter_input(parameter_.name) : "",
                            parameter_.value,
                            parameter_.limits,
                            {},
                            parameter_.name};
        if (described == nullptr) {
            return made;
        }
        if (described->start) {
            made.value = in_unit(*described->start);
        }
        if (described->deviation) {
            made.deviation = in_unit(*described->deviation);
        }
        if (described->range) {
            narrow(made.range, *described->range);
        }
        if (has_its_unit_ && !camera::contains(made.range, made.value)) {
            found_.push_back(error(
                fmt::format("the search for '{}' begins at {}, outside its range", parameter_.name,
                            lang::literal(made.value, parameter_.is_angle, parameter_.written)),
                described->start ? described->start->written : described->written,
                "add a start within the range"));
        }
        return made;
    }

private:
    void narrow(camera::Range& range, const std::array<Marks::Number, 2>& ends) {
        const double minimum = in_unit(ends[0]);
        const double maximum = in_unit(ends[1]);
        if (minimum > range.minimum) {
            range.minimum = minimum;
            range.excludes_minimum = false;
        }
        range.maximum = std::min(range.maximum, maximum);
    }

    const OpenParameter& parameter_;
    Diagnostics& found_;
    bool has_its_unit_ = true;  ///< Every number so far.
};

}  // namespace

std::vector<OpenParameter> WantedParameters::all() const {
    std::vector<OpenParameter> made = open;
    made.insert(made.end(), closed.begin(), closed.end());
    return made;
}

Result<WantedParameters> wanted_parameters(const Marks& marks, const lang::OpenCamera& camera) {
    Diagnostics found;
    std::vector<std::string> named;
    if (marks.unknowns) {
        check_names(*marks.unknowns, camera, true, found);
        for (const Marks::Parameter& one : *marks.unknowns) {
            named.push_back(one.name);
        }
    }
    std::vector<std::string> fixed;
    if (marks.fixed) {
        check_names(*marks.fixed, camera, false, found);
        for (const Marks::Parameter& one : *marks.fixed) {
            fixed.push_back(one.name);
            if (has(named, one.name)) {
                found.push_back(error(fmt::format("'{}' is both unknown and fixed", one.name),
                                      one.written, "remove it from one of the two lists"));
            }
        }
    }
    if (has_errors(found)) {
        return found;
    }
    const bool all = marks.fixed || !marks.unknowns;
    if (all && camera.open.empty() && named.empty() && !camera.numbers.empty()) {
        return error(fmt::format("no parameter of the camera '{}' can be an input of its formulas",
                                 camera.camera.name()),
                     {},
                     fmt::format("name those for which it is to be made anew: unknowns: [{}]",
                                 camera.numbers.front().name));
    }
    WantedParameters wanted;
    for (const OpenParameter& one : camera.open) {
        if (!has(fixed, one.name) && (all || has(named, one.name))) {
            wanted.open.push_back(one);
        }
    }
    for (const OpenParameter& one : camera.numbers) {
        if (has(named, one.name)) {
            wanted.closed.push_back(one);
        }
    }
    return wanted;
}

Result<solve::Problem> problem_of(const Marks& marks, const WantedParameters& wanted, Axes axes) {
    solve::Problem made = marks.problem;
    Diagnostics found;
    for (const bool is_open : {true, false}) {
        for (const OpenParameter& one : is_open ? wanted.open : wanted.closed) {
            made.unknowns.push_back(Details(one, found).unknown(find(marks, one.name), is_open));
        }
    }
    for (solve::Mark& mark : made.marks) {
        if (!mark.target) {
            mark.place = turned(mark.place, marks.axes.value_or(axes), axes);
        }
    }
    for (solve::Outline& outline : made.outlines) {
        for (solve::V3d& point : outline.points) {
            point = turned(point, marks.axes.value_or(axes), axes);
        }
    }
    return has_errors(found) ? Result<solve::Problem>(found) : Result<solve::Problem>(made);
}

}  // namespace balcony::app
