// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "balcony/diagnose.hpp"

namespace balcony::analyse {

SampleGrid SampleGrid::over(double picture_width, double picture_height, double step) {
    const auto count = [step](double length) {
        return static_cast<std::size_t>(std::max(std::floor(length / step + 1e-9), 1.0));
    };
    return {picture_width, picture_height, step, count(picture_width), count(picture_height)};
}

V2d SampleGrid::first() const {
    return {0.5 * (picture_width - step * static_cast<double>(columns - 1)),
            0.5 * (picture_height - step * static_cast<double>(rows - 1))};
}

V2d SampleGrid::at(std::size_t index) const {
    return first() +
           step * V2d(static_cast<double>(index % columns), static_cast<double>(index / columns));
}

std::vector<Imath::Box2d> SampleGrid::cells_of(const std::vector<std::size_t>& samples) const {
    const auto side = [](double from, double cell, std::size_t number, std::size_t count,
                         double whole) {
        return number == 0       ? 0.0
               : number == count ? whole
                                 : from + cell * (static_cast<double>(number) - 0.5);
    };
    const auto left = [&](std::size_t c) {
        return side(first().x, step, c, columns, picture_width);
    };
    const auto top = [&](std::size_t r) { return side(first().y, step, r, rows, picture_height); };
    std::vector<Imath::Box2d> boxes;
    // Of the last row and the one before: the box that ends there, by its columns.
    using Columns = std::pair<std::size_t, std::size_t>;
    std::map<Columns, std::size_t> above;
    std::map<Columns, std::size_t> here;
    std::size_t row = 0;
    for (std::size_t i = 0; i < samples.size();) {
        if (const std::size_t next = samples[i] / columns; next != row) {
            above = next == row + 1 ? std::move(here) : std::map<Columns, std::size_t>();
            here.clear();
            row = next;
        }
        const std::size_t begin = samples[i] % columns;
        std::size_t end = begin + 1;
        for (++i; i < samples.size() && samples[i] == row * columns + end && end < columns; ++i) {
            ++end;
        }
        const auto known = above.find({begin, end});
        const std::size_t box = known == above.end() ? boxes.size() : known->second;
        if (box == boxes.size()) {
            boxes.push_back({{left(begin), top(row)}, {left(end), 0.0}});
        }
        boxes[box].max.y = top(row + 1);
        here[{begin, end}] = box;
    }
    return boxes;
}

}  // namespace balcony::analyse
