// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <exception>
#include <ostream>
#include <stdexcept>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "bridge/maps/ray_rows.hpp"

namespace balcony::bridge {

namespace {

namespace fs = std::filesystem;

// ------------------------------------------------------------------------------------------ EXR

/// An EXR file that OpenEXR writes through a stream; a failure to write throws.
class ExrStream final : public Imf::OStream {
public:
    explicit ExrStream(std::ostream& stream) : Imf::OStream("ray map"), stream_(stream) {}

    void write(const char* bytes, int count) override { check(stream_.write(bytes, count)); }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(stream_.tellp()); }
    void seekp(std::uint64_t position) override {
        check(stream_.seekp(static_cast<std::streamoff>(position)));
    }

private:
    static void check(const std::ostream& stream) {
        if (!stream) {
            throw std::runtime_error("the file cannot be written");
        }
    }

    std::ostream& stream_;
};

Imf::Header header_of(const RayGrid& grid, const std::vector<RayColumn>& columns) {
    Imf::Header header(static_cast<int>(grid.width()), static_cast<int>(grid.height()));
    header.compression() = Imf::NO_COMPRESSION;
    for (const RayColumn& column : columns) {
        header.channels().insert(std::string(column.name), Imf::Channel(Imf::FLOAT));
    }
    header.insert("axes", Imf::StringAttribute(grid.axes() == Axes::y_up ? "y_up" : "z_up"));
    header.insert("camera", Imf::StringAttribute(grid.name()));
    return header;
}

// Rows of all channels; OpenEXR counts from the first row of the picture.
Imf::FrameBuffer buffer_of(const RayGrid& grid, const std::vector<RayColumn>& columns,
                           const Rows<float>& rows) {
    const std::size_t pixel = columns.size() * sizeof(float);
    const std::size_t row = grid.width() * pixel;
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        // OpenEXR wants to be able to write to it.
        auto* first = const_cast<float*>(rows.values.data() + i);
        buffer.insert(
            std::string(columns[i].name),
            Imf::Slice::Make(Imf::FLOAT, first, Imath::V2i(0, static_cast<int>(rows.first)),
                             static_cast<std::int64_t>(grid.width()),
                             static_cast<std::int64_t>(rows.count), pixel, row));
    }
    return buffer;
}

RaysWritten write_exr(const RayGrid& grid, std::ostream& stream, const std::stop_token& stop) {
    const std::vector<RayColumn> columns = ray_columns(grid);
    ExrStream to(stream);
    try {
        constexpr int no_threads = 0;
        Imf::OutputFile output(to, header_of(grid, columns), no_threads);
        return RowRun<float>(grid, columns)(
            [](Rows<float>&) {},
            [&](const Rows<float>& rows) {
                output.setFrameBuffer(buffer_of(grid, columns, rows));
                output.writePixels(static_cast<int>(rows.count));
                return true;
            },
            stop);
    } catch (const std::exception&) {
        stream.setstate(std::ios::failbit);
        return {};
    }
}

// ------------------------------------------------------------------------------------------ npy

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
        [](Rows<Number>&) {},
        [&stream](const Rows<Number>& rows) {
            return static_cast<bool>(
                stream.write(reinterpret_cast<const char*>(rows.values.data()),
                             static_cast<std::streamsize>(rows.values.size() * sizeof(Number))));
        },
        stop);
}

}  // namespace

RaysWritten write_ray_map(const RayGrid& grid, const fs::path& file, NumberFormat format,
                          const std::stop_token& stop) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if ((ending != ".exr" && ending != ".npy") || format == NumberFormat::text) {
        return {.problems = {error(fmt::format("'{}' is no ray map", file.string()), {},
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
