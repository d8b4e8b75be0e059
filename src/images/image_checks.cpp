// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "images/image_checks.hpp"

#include <fmt/format.h>

#include "balcony/images.hpp"

namespace balcony::images {

std::optional<Diagnostic> check_size(DeclaredSize size) {
    if (size.width == 0 || size.height == 0) {
        return error("it has no pixels", {}, "copy or export it again");
    }
    if (size.width > max_image_pixels / size.height) {
        return error(fmt::format("it has {} x {} pixels, more than {} million", size.width,
                                 size.height, max_image_pixels / 1'000'000),
                     {}, "scale it down");
    }
    return std::nullopt;
}

std::optional<Diagnostic> check_declared(std::optional<DeclaredSize> size, std::size_t byte_count,
                                         std::size_t max_pixels_per_byte) {
    if (!size) {
        return error("its header is corrupt");
    }
    if (auto failure = check_size(*size)) {
        return failure;
    }
    if (max_pixels_per_byte > 0 && size->width * size->height / max_pixels_per_byte > byte_count) {
        return error(fmt::format("it declares {} x {} pixels, more than its {} bytes can contain",
                                 size->width, size->height, byte_count),
                     {}, "copy or export it again");
    }
    return std::nullopt;
}

Diagnostic truncated() {
    return error("it is truncated or corrupt", {}, "copy or export it again");
}

Diagnostic corrupt(std::string_view reason) {
    return error(reason.empty() ? "its content is corrupt"
                                : fmt::format("its content is corrupt: {}", reason),
                 {}, "copy or export it again");
}

}  // namespace balcony::images
