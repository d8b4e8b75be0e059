// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/parameter_derivatives.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "balcony/studies.hpp"

namespace balcony::app {

namespace {

using Imath::V2d;
using Imath::V3d;

// The rays of a layer with its open parameters, which have these values.
struct Opened {
    std::vector<std::string> names;
    std::vector<double> values;
    solve::Solver solver;
};

Result<Opened> opened_of(const lang::OpenPicture& picture, const DerivativeRequest& request,
                         const std::stop_token& stop) {
    std::vector<lang::OpenParameter> open = picture.open;
    auto next = open.begin();
    for (const std::string& name : request.by.value_or(std::vector<std::string>())) {
        const auto is_it = [&](const lang::OpenParameter& one) { return one.name == name; };
        if (std::any_of(open.begin(), next, is_it)) {
            return error(Kind::usage, fmt::format("'{}' is named twice", name));
        }
        const auto found = std::find_if(next, open.end(), is_it);
        if (found == open.end()) {
            return error(Kind::usage, fmt::format("there are no derivatives by '{}'", name),
                         "it is no number, or determines the structure of the camera");
        }
        std::rotate(next, found, found + 1);
        ++next;
    }
    std::vector<std::string> names;
    std::vector<std::string> inputs;
    std::vector<double> values;
    for (const lang::OpenParameter& one : open) {
        names.push_back(one.name);
        inputs.push_back(lang::parameter_input(one.name));
        values.push_back(one.value);
    }
    auto solver =
        solve::Solver::make(picture.picture, request.layer, static_cast<double>(request.size[0]),
                            static_cast<double>(request.size[1]), inputs, request.time, stop);
    return solver ? Result<Opened>(Opened{std::move(names), std::move(values), std::move(*solver)})
                  : Result<Opened>(std::move(solver.diagnostics));
}

// Turns the vectors of rays, of which each has two.
void turn(solve::Derivatives& derivatives, std::size_t inputs, Axes from, Axes to) {
    std::vector<double>& values = derivatives.values;
    for (std::size_t first = 0; first < values.size(); first += 3 * inputs) {
        for (std::size_t i = first; i < first + inputs; ++i) {
            const V3d made =
                turned(V3d(values[i], values[i + inputs], values[i + 2 * inputs]), from, to);
            values[i] = made.x;
            values[i + inputs] = made.y;
            values[i + 2 * inputs] = made.z;
        }
    }
}

}  // namespace

Result<ParameterDerivatives> ray_derivatives(const lang::OpenPicture& picture,
                                             const DerivativeRequest& request,
                                             std::span<const V2d> points,
                                             const std::stop_token& stop) {
    auto opened = opened_of(picture, request, stop);
    if (!opened) {
        return std::move(opened.diagnostics);
    }
    ParameterDerivatives made{std::move(opened->names),
                              opened->solver.ray_derivatives(points, opened->values)};
    const Axes own = opened->solver.axes();
    turn(made.derivatives, opened->values.size(), own, request.axes.value_or(own));
    return made;
}

Result<ParameterDerivatives> position_derivatives(const lang::OpenPicture& picture,
                                                  const DerivativeRequest& request,
                                                  const analyse::Locator& locator,
                                                  std::span<const V3d> points,
                                                  const std::stop_token& stop) {
    auto opened = opened_of(picture, request, stop);
    if (!opened) {
        return std::move(opened.diagnostics);
    }
    std::vector<std::size_t> in_part;
    auto sightings = locator.locate(points, in_part, {}, stop);
    if (!sightings) {
        return std::move(sightings.diagnostics);
    }
    std::erase_if(*sightings, [&](const auto& one) { return one.layer != request.layer; });
    const auto seen = analyse::foremost(*sightings, points.size());
    std::vector<V3d> places;
    std::vector<V2d> positions;
    for (std::size_t i = 0; i < points.size(); ++i) {
        places.push_back(turned(points[i], locator.axes(), opened->solver.axes()));
        positions.push_back(seen[i] != nullptr ? seen[i]->position
                                               : V2d(std::numeric_limits<double>::quiet_NaN()));
    }
    Diagnostics found = std::move(sightings.diagnostics);
    if (!in_part.empty()) {
        found.push_back(searched_in_part(in_part.size()));
    }
    return {{std::move(opened->names),
             opened->solver.position_derivatives(places, positions, opened->values)},
            std::move(found)};
}

}  // namespace balcony::app
