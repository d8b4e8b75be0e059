// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/data.hpp"
#include "balcony/input_file.hpp"
#include "data/table_rows.hpp"

namespace balcony::data {

using Imath::V3d;

namespace {

// Lines of three numbers in so many bytes have at most max_numbers.
constexpr std::size_t text_block = max_numbers / 3 * 6;
constexpr std::size_t array_rows = 65'536;
constexpr std::string_view line_ends = "\n\r";

}  // namespace

Result<PointReader> PointReader::open(const std::filesystem::path& file) {
    if (auto fault = not_a_file(file, fmt::format("'{}'", file.string()))) {
        return *std::move(fault);
    }
    auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
    if (!*stream) {
        return error(fmt::format("'{}' cannot be read", file.string()), {},
                     "check its read permission");
    }
    return PointReader(std::move(stream), file.string());
}

PointReader::PointReader(std::istream& stream, std::string name)
    : stream_(&stream), name_(std::move(name)) {}

PointReader::PointReader(std::unique_ptr<std::istream> stream, std::string name)
    : own_(std::move(stream)), stream_(own_.get()), name_(std::move(name)) {}

Result<std::vector<V3d>> PointReader::next() {
    if (!begun_) {
        begun_ = true;
        if (Diagnostics found = begin(); !found.empty()) {
            return found;
        }
    }
    Result<std::vector<V3d>> made = header_ ? next_of_array() : next_rows();
    points_ += made ? made->size() : 0;
    return made && points_ == 0 ? Result<std::vector<V3d>>(no_numbers(name_)) : std::move(made);
}

Diagnostics PointReader::begin() {
    fill(text_block);
    if (!is_npy(buffer_)) {
        std::string_view text = buffer_;
        const auto fault = begin_text(text, fmt::format("'{}'", name_));
        buffer_.erase(0, buffer_.size() - text.size());
        return fault ? Diagnostics{*fault} : Diagnostics{};
    }
    Result<NpyHeader> header = NpyHeader::read(buffer_, name_);
    if (!header) {
        return header.diagnostics;
    }
    if (header->shape.size() != 2 || header->shape[1] != 3) {
        return {error(fmt::format("the array in '{}' has the shape ({})", name_,
                                  fmt::join(header->shape, ", ")),
                      {}, "give it the shape (points, 3)")};
    }
    header_ = std::move(*header);
    buffer_.erase(0, header_->size);
    return {};
}

void PointReader::fill(std::size_t size) {
    const std::size_t had = buffer_.size();
    if (had < size) {
        buffer_.resize(size);
        stream_->read(buffer_.data() + had, static_cast<std::streamsize>(size - had));
        buffer_.resize(had + static_cast<std::size_t>(stream_->gcount()));
    }
}

// ------------------------------------------------------------------------------------------ text

// As many whole lines as a block has; one that is longer is cut, and then no row of three numbers.
std::string PointReader::next_lines() {
    fill(text_block);
    const std::size_t last = buffer_.find_last_of(line_ends);
    const bool whole = buffer_.size() < text_block || last == buffer_.npos;
    const std::size_t size = whole ? buffer_.size() : last + 1;
    std::string lines = buffer_.substr(0, size);
    buffer_.erase(0, size);
    return lines;
}

Result<std::vector<V3d>> PointReader::next_rows() {
    std::vector<V3d> points;
    while (points.empty()) {
        std::string lines = next_lines();
        if (lines.empty()) {
            break;
        }
        if (lines.find('\0') != lines.npos) {
            return error(fmt::format("'{}' is neither a text nor an array of NumPy", name_), {},
                         "export the points as CSV, plain text in UTF-8, or with numpy.save");
        }
        const auto count = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
        // What is read once more for its errors has its number of lines.
        Result<NumberTable> table =
            read_rows(std::make_shared<const SourceText>(name_, lines), lines_ == 0);
        const auto is_point = [](const std::vector<NumberTable::Number>& row) {
            return row.size() == 3 && !row[0].angle && !row[1].angle && !row[2].angle;
        };
        if (!table || !std::all_of(table->rows.begin(), table->rows.end(), is_point)) {
            table = read_rows(
                std::make_shared<const SourceText>(name_, std::string(lines_, '\n') + lines),
                lines_ == 0);
        }
        if (!table) {
            return table.diagnostics;
        }
        for (const auto& row : table->rows) {
            if (!is_point(row)) {
                return error("this row is not a point",
                             join(table->at(row.front()), table->at(row.back())),
                             "write three lengths per line: x,y,z");
            }
            points.emplace_back(row[0].value, row[1].value, row[2].value);
        }
        lines_ += count;
    }
    return points;
}

// ----------------------------------------------------------------------------------------- array

// The next numbers of the stream; nothing if it ends before.
std::optional<std::string> PointReader::numbers(std::size_t count) {
    const std::size_t size = count * header_->number_size;
    fill(size);
    if (buffer_.size() < size) {
        return std::nullopt;
    }
    std::string bytes = buffer_.substr(0, size);
    buffer_.erase(0, size);
    return bytes;
}

Result<std::vector<V3d>> PointReader::next_of_array() {
    const std::size_t all = header_->shape[0];
    std::vector<V3d> points(std::min(all - points_, array_rows));
    // Row by row it is one column of triples.
    const std::size_t columns = header_->by_columns ? 3 : 1;
    const std::size_t each = 3 / columns;
    for (std::size_t column = 0; column < columns; ++column) {
        if (columns > 1) {
            buffer_.clear();
            stream_->clear();
            stream_->seekg(static_cast<std::streamoff>(header_->size + (column * all + points_) *
                                                                           header_->number_size));
            if (!*stream_) {
                return error(fmt::format("the array in '{}' is written column by column, which a "
                                         "stream cannot be read by",
                                         name_),
                             {}, "name a file, or save numpy.ascontiguousarray(points)");
            }
        }
        const std::optional<std::string> bytes = numbers(points.size() * each);
        if (!bytes) {
            return error(fmt::format("'{}' ends before its {} points do", name_, all), {},
                         "write it again with numpy.save");
        }
        for (std::size_t i = 0; i < points.size() * each; ++i) {
            points[i / each][static_cast<int>(column + i % each)] =
                header_->number_at(bytes->data() + i * header_->number_size);
        }
    }
    return points;
}

}  // namespace balcony::data
