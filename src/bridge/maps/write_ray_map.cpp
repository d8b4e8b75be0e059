// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <ostream>

#include <fmt/format.h>

#include "balcony/npy.hpp"
#include "balcony/output_file.hpp"
#include "bridge/maps/exr_rows.hpp"
#include "bridge/maps/ray_rows.hpp"

namespace balcony::bridge {

namespace {

namespace fs = std::filesystem;

RaysWritten write_exr(const RayGrid& grid, std::ostream& stream, const std::stop_token& stop) {
    const std::vector<RayColumn> columns = ray_columns(grid);
    std::vector<std::string> names;
    for (const RayColumn& column : columns) {
        names.emplace_back(column.name);
    }
    ExrRows output(
        stream, grid.width(), grid.height(), names,
        {{"axes", grid.axes() == Axes::y_up ? "y_up" : "z_up"}, {"camera", grid.name()}});
    const RaysWritten written =
        RowRun<float>(grid, columns)([](RayRows<float>&) {},
                                     [&output](const RayRows<float>& rows) {
                                         return output.write(rows.span, rows.values.data());
                                     },
                                     stop);
    (void)output.finish();
    return written;
}

template <class Number>
RaysWritten write_npy(const RayGrid& grid, std::ostream& stream, const std::stop_token& stop) {
    const std::vector<RayColumn> columns = ray_columns(grid);
    stream << npy_header(std::array{grid.height(), grid.width(), columns.size()}, sizeof(Number));
    return RowRun<Number>(grid, columns)(
        [](RayRows<Number>&) {},
        [&stream](const RayRows<Number>& rows) {
            return static_cast<bool>(
                stream.write(reinterpret_cast<const char*>(rows.values.data()),
                             static_cast<std::streamsize>(rows.values.size() * sizeof(Number))));
        },
        stop);
}

}  // namespace

RaysWritten write_ray_map(const RayGrid& grid, const fs::path& file, NumberFormat format,
                          const std::stop_token& stop) {
    const std::string ending = ending_of(file);
    if ((ending != ".exr" && ending != ".npy") || format == NumberFormat::text) {
        return {.problems = {error(Kind::usage, fmt::format("'{}' is no ray map", file.string()),
                                   "use a file name that ends in .exr or .npy")}};
    }
    OutputFile output(file);
    if (!output.stream()) {
        return {.problems = {output.failure()}};
    }
    RaysWritten written = ending == ".exr" ? write_exr(grid, output.stream(), stop)
                          : format == NumberFormat::single_precision
                              ? write_npy<float>(grid, output.stream(), stop)
                              : write_npy<double>(grid, output.stream(), stop);
    if (!output.stream()) {
        written.problems = {output.failure()};
    } else if (written.complete) {
        written.problems = output.commit();
    }
    return written;
}

}  // namespace balcony::bridge
