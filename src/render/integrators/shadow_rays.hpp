// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The shadow rays of a bounce. Those of the first bounce, which start near each other, are traced
// in packets.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/integrators/path_state.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// Light that arrives if nothing is in its way.
struct ShadowedLight {
    embree::Ray ray;
    Color3f light;
    std::uint32_t index = 0;      ///< Of the path's result.
    std::uint32_t packet = 0;     ///< Of its camera ray.
    bool direct = false;          ///< The light is scattered once.
    Part part = Part::whole;      ///< Of the path.
    bool softened = false;        ///< Likewise.
    bool indirect = false;        ///< It comes to the first surface that is not clear by another.
    std::uint32_t guided = none;  ///< The path that starts if glass is in the way.

    static constexpr std::uint32_t none = 0xffffffffU;
};

class ShadowRays {
public:
    void clear() { all_.clear(); }
    void add(const ShadowedLight& one) { all_.push_back(one); }

    /// Calls receive(light, transmittance) for all light. The transmittance is 0 if something is in
    /// the way.
    template <class Receive>
    void trace(const SceneTracer& tracer, const Receive& receive) const {
        for (std::size_t begin = 0; begin < all_.size();) {
            const std::size_t count = packet_at(begin);
            if (count == 0) {
                receive(all_[begin], tracer.transmittance(all_[begin].ray));
                ++begin;
                continue;
            }
            std::array<embree::Ray, packet_size> rays;
            std::array<Color3f, packet_size> transmittances;
            for (std::size_t lane = 0; lane < count; ++lane) {
                rays[lane] = all_[begin + lane].ray;
            }
            tracer.transmittance(std::span(rays).first(count), transmittances);
            for (std::size_t lane = 0; lane < count; ++lane, ++begin) {
                receive(all_[begin], transmittances[lane]);
            }
        }
    }

private:
    static constexpr std::size_t packet_size = embree::Packet::size;

    // The number of rays of a packet that begins here; 0 where a ray is by itself.
    [[nodiscard]] std::size_t packet_at(std::size_t begin) const {
        const std::size_t limit = std::min(begin + packet_size, all_.size());
        std::size_t end = begin;
        while (end < limit && all_[end].direct && all_[end].packet == all_[begin].packet) {
            ++end;
        }
        return end - begin;
    }

    std::vector<ShadowedLight> all_;
};

}  // namespace balcony::render
