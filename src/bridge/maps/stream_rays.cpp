// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Streams of rays as Radiance's rtrace reads them, with -fa, -ff or -fd.

#include <charconv>

#include "bridge/maps/ray_rows.hpp"

namespace balcony::bridge {

namespace {

constexpr std::size_t numbers_of_ray = 6;

// The longest shortest text is -1.2345678901234567e-308.
constexpr std::size_t longest_number = 24;

void write_lines(RayRows<double>& rows) {
    rows.text.resize(rows.values.size() * (longest_number + 1));
    char* to = rows.text.data();
    char* const end = to + rows.text.size();
    for (std::size_t i = 0; i < rows.values.size(); ++i) {
        to = std::to_chars(to, end, rows.values[i]).ptr;
        *to++ = i % numbers_of_ray == numbers_of_ray - 1 ? '\n' : ' ';
    }
    rows.text.resize(static_cast<std::size_t>(to - rows.text.data()));
}

template <class Number>
RaysWritten stream_numbers(const RayGrid& grid, std::vector<RayColumn> columns,
                           const ByteSink& sink, const std::stop_token& stop) {
    return RowRun<Number>(grid, std::move(columns))(
        [](RayRows<Number>&) {},
        [&sink](const RayRows<Number>& rows) {
            return sink({reinterpret_cast<const char*>(rows.values.data()),
                         rows.values.size() * sizeof(Number)});
        },
        stop);
}

}  // namespace

RaysWritten stream_rays(const RayGrid& grid, NumberFormat format, const ByteSink& sink,
                        const std::stop_token& stop) {
    std::vector<RayColumn> columns = ray_columns(grid);
    columns.resize(numbers_of_ray);
    switch (format) {
        case NumberFormat::single_precision:
            return stream_numbers<float>(grid, std::move(columns), sink, stop);
        case NumberFormat::double_precision:
            return stream_numbers<double>(grid, std::move(columns), sink, stop);
        case NumberFormat::text: break;
    }
    return RowRun<double>(grid, std::move(columns))(
        write_lines, [&sink](const RayRows<double>& rows) { return sink(rows.text); }, stop);
}

}  // namespace balcony::bridge
