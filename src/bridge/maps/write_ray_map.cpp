// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <ostream>

#include <fmt/format.h>

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

// The format's version 1: a magic text, the length of the header, and the header, a Python
// dictionary that ends where the numbers begin, at a multiple of 64 bytes
// (https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html).
std::string npy_header(const RayGrid& grid, std::size_t columns, std::string_view type) {
    constexpr std::size_t before = 10;
    constexpr std::size_t alignment = 64;
    std::string text =
        fmt::format("{{'descr': '{}{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}",
                    std::endian::native == std::endian::little ? '<' : '>', type, grid.height(),
                    grid.width(), columns);
    const std::size_t end = (before + text.size() + 1 + alignment - 1) / alignment * alignment;
    text.resize(end - before - 1, ' ');
    text += '\n';
    const auto length = static_cast<unsigned>(text.size());
    return fmt::format("\x93NUMPY\x01{}{}{}{}", '\0', static_cast<char>(length & 0xffU),
                       static_cast<char>(length >> 8U), text);
}

template <class Number>
RaysWritten write_npy(const RayGrid& grid, std::ostream& stream, const std::stop_token& stop) {
    const std::vector<RayColumn> columns = ray_columns(grid);
    stream << npy_header(grid, columns.size(), sizeof(Number) == 4 ? "f4" : "f8");
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
