// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <type_traits>

#include "balcony/film.hpp"

namespace balcony::render {

/// The largest width and height of a picture in pixels.
inline constexpr std::size_t max_film_side = std::size_t{1} << 20;

/// Whether a window has pixels and is a part of a picture of a size.
[[nodiscard]] bool is_part(const Region& window, std::size_t width, std::size_t height);

/// The error of a film whose vectors do not have the size of its window.
[[nodiscard]] Diagnostics check_sizes(const Film& film);

/// 0, also for vectors, whose default is undefined.
template <class Value>
[[nodiscard]] Value zero() {
    if constexpr (std::is_constructible_v<Value, int>) {
        return Value(0);
    } else {
        return Value{};
    }
}

/// Calls visit(array) with all that jobs add to a film, in a fixed order. Jobs derive the other
/// members from the settings and the scene.
template <class AnyFilm, class Visit>
void for_each_array(AnyFilm& film, const Visit& visit) {
    const auto each = [&visit](auto&... arrays) { (visit(arrays), ...); };
    // All members are named here, so that a new one does not compile until it is visited, too, or
    // known to be derived.
    auto& [width, height, window, sum, sum_of_squares, display, mirrored, background, ambient,
           layer_set, layers, means, noisy, first_pass, passes, pixel_passes, first_half, white,
           objects, materials, picture_layers] = film;
    const std::span white_alone(&white, 1);
    each(sum, sum_of_squares, display, mirrored, passes, pixel_passes, first_half, white_alone);
    auto& [emission, direct, mean_albedo, mean_normal, mean_position, object_mattes,
           material_mattes, direct_half, indirect_half] = means;
    each(emission, direct, mean_albedo, mean_normal, mean_position, object_mattes, material_mattes);
    if (layers) {
        auto& [ray_length, position, normal, albedo, object, origin, direction, parameters, valid,
               layer, magnification, motion] = *layers;
        each(ray_length, position, normal, albedo, object, origin, direction, parameters, valid,
             layer, magnification, motion);
    }
    each(direct_half, indirect_half);
}

/// Empties a film, and makes it one of another window of the picture with the same contents.
void begin_anew(Film& film, const Region& window);

}  // namespace balcony::render
