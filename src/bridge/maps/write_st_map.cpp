// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/st_maps.hpp"
#include "bridge/maps/map_rows.hpp"

namespace balcony::bridge {

StMapWritten write_st_map(const StMap& map, const std::filesystem::path& file,
                          const std::stop_token& stop) {
    const auto pixel = [](const SourcePlace& place) {
        const float there = place.valid ? 1.0F : 0.0F;
        return std::array<float, 4>{there * static_cast<float>(place.st.x),
                                    there * static_cast<float>(place.st.y), 0.0F, there};
    };
    return write_map_to_exr(map, file, pixel, stop);
}

}  // namespace balcony::bridge
