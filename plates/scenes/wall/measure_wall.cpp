// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/wall/measure_wall.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace balcony::plates {

namespace {

// The unit that an object's name begins with, "unit R C"; rows and columns have one digit.
std::optional<std::array<std::size_t, 2>> unit_of(const std::string& object) {
    if (!object.starts_with("unit ") || object.size() < 8) {
        return std::nullopt;
    }
    return std::array{std::size_t(object[5] - '1'), std::size_t(object[7] - '1')};
}

void add_pixel(UnitView& unit, std::size_t x, std::size_t y) {
    unit.min_x = unit.pixels == 0 ? x : std::min(unit.min_x, x);
    unit.max_x = unit.pixels == 0 ? x : std::max(unit.max_x, x);
    unit.min_y = unit.pixels == 0 ? y : std::min(unit.min_y, y);
    unit.max_y = unit.pixels == 0 ? y : std::max(unit.max_y, y);
    ++unit.pixels;
}

}  // namespace

std::size_t WallView::units_seen() const {
    std::size_t seen = 0;
    for (const auto& row : units) {
        seen += std::size_t(std::count_if(row.begin(), row.end(),
                                          [](const UnitView& unit) { return unit.pixels > 0; }));
    }
    return seen;
}

std::size_t WallView::unit_pixels() const {
    std::size_t pixels = 0;
    for (const auto& row : units) {
        for (const UnitView& unit : row) {
            pixels += unit.pixels;
        }
    }
    return pixels;
}

WallView view_wall(Studio& studio, const std::string& camera, std::size_t size,
                   const Overrides& overrides, bool pictures_and_walls) {
    const render::Film film = studio.look({.scene = "wall",
                                           .camera = camera,
                                           .width = size,
                                           .height = size,
                                           .pictures_and_walls = pictures_and_walls},
                                          overrides);
    WallView view;
    std::set<std::string> boxes;
    const std::vector<std::uint32_t>& ids = film.layers.value().object;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const std::string object = ids[i] == 0 ? "nothing" : film.objects.at(ids[i] - 1);
        if (const auto unit = unit_of(object)) {
            add_pixel(view.units.at((*unit)[0]).at((*unit)[1]), i % size, i / size);
        } else if (object.starts_with("box ")) {
            boxes.insert(object);
        } else if (!object.starts_with("cylinder ") && object != "backdrop") {
            ++view.others;
        }
    }
    view.boxes = boxes.size();
    return view;
}

}  // namespace balcony::plates
