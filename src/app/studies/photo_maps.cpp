// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/photo_maps.hpp"

#include <memory>
#include <utility>

#include "app/request_check.hpp"
#include "app/words.hpp"
#include "balcony/inverse.hpp"

namespace balcony::app {

namespace {

using Size = std::array<std::size_t, 2>;

Result<bridge::RayGrid> grid_of(const camera::Picture& picture, const Size& size,
                                const std::string& layer, double time) {
    return bridge::RayGrid::make(picture, {.width = size[0],
                                           .height = size[1],
                                           .layer = layer,
                                           .axes = Axes::z_up,
                                           .time = time,
                                           .footprints = true});
}

Result<bridge::SourceCamera> with_inverse(const camera::Picture& picture, const Size& size,
                                          double time, const std::stop_token& stop) {
    auto grid = grid_of(picture, size, {}, time);
    Diagnostics found = grid.diagnostics;
    if (!grid) {
        return found;
    }
    auto locator = analyse::Locator::make(picture, static_cast<double>(size[0]),
                                          static_cast<double>(size[1]), time, Axes::z_up, {}, stop);
    add(found, locator.diagnostics);
    if (!locator) {
        return found;
    }
    return {bridge::SourceCamera{std::move(*grid),
                                 std::make_shared<const analyse::Locator>(std::move(*locator))},
            std::move(found)};
}

Size size_of(const SizeRequest& request, const camera::Picture& picture) {
    const auto [width, height] = request.resolve(picture.aspect(), picture.parts().size);
    return {width, height};
}

}  // namespace

Result<bridge::SourceCamera> wanted_camera(const camera::Picture& picture, const SizeRequest& size,
                                           double time, const std::stop_token& stop) {
    return with_inverse(picture.with_fit(size.fit), size_of(size, picture), time, stop);
}

Result<bridge::SourceCamera> camera_of_photo(const camera::Picture& picture,
                                             const std::optional<Size>& size, double time,
                                             const std::stop_token& stop) {
    return with_inverse(picture.with_fit(camera::Fit::stretch), size.value_or(size_of({}, picture)),
                        time, stop);
}

Result<bridge::StMap> photo_map(const camera::Picture& wanted, const camera::Picture& photo,
                                const PhotoMapRequest& request, const std::stop_token& stop) {
    Diagnostics found = check_size(request.size);
    if (request.photo_size) {
        const auto [width, height] = *request.photo_size;
        add(found, check_size({.width = width, .height = height}));
    }
    if (has_errors(found)) {
        return found;
    }
    const auto grid = grid_of(wanted.with_fit(request.size.fit), size_of(request.size, wanted),
                              request.layer, request.time);
    add(found, grid.diagnostics);
    if (!grid) {
        return found;
    }
    const auto source = camera_of_photo(photo, request.photo_size, request.time, stop);
    add(found, source.diagnostics);
    if (!source) {
        return found;
    }
    auto map = bridge::StMap::make(*grid, *source, request.parallax);
    map.diagnostics.insert(map.diagnostics.begin(), found.begin(), found.end());
    return map;
}

}  // namespace balcony::app
