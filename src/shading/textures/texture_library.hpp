// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The textures of a scene within a memory limit. Each is decoded once: into memory if it fits,
// otherwise into a temporary file, whose parts in use are in memory.

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include <Imath/ImathColor.h>

#include "balcony/base.hpp"
#include "balcony/progress.hpp"
#include "balcony/scene.hpp"
#include "shading/textures/held_texture.hpp"
#include "shading/textures/spill_file.hpp"
#include "shading/textures/texture_footprint.hpp"
#include "shading/textures/texture_lanes.hpp"

namespace balcony::render {

/// Look-ups may come from any number of threads.
class TextureLibrary {
public:
    /// Opens the textures of the scene's materials. One that cannot be opened is a warning.
    /// `memory` is the limit for all texels, in bytes. If all textures fit, they are held in
    /// memory; otherwise, the smaller ones are, in three quarters of it, and the rest is for the
    /// parts of the others. What a look-up gives does not depend on it. After a stop, it is of no
    /// use.
    TextureLibrary(const scene::Scene& scene, std::size_t memory, Diagnostics& warnings,
                   const std::stop_token& stop = {});
    TextureLibrary(const TextureLibrary&) = delete;
    TextureLibrary& operator=(const TextureLibrary&) = delete;

    /// Decodes the textures that fit, on all threads of the machine. Otherwise, or after a stop,
    /// the first look-up decodes a texture.
    void read_all(const std::stop_token& stop = {}, const PartDone& progress = {}) const;
    /// Decodes the textures of some materials, whether they fit or not, on all threads.
    void read(std::span<const scene::Material* const> materials, const std::stop_token& stop) const;
    [[nodiscard]] bool all_fit() const { return all_fit_; }

    /// The mean over the footprint: red, green, blue, alpha. White where there is no texture, it
    /// cannot be read, or the point is out of range; without a filter if the footprint is out of
    /// range.
    [[nodiscard]] Imath::Color4f look_up(scene::TextureIndex texture, TextureEncoding encoding,
                                         const TextureFootprint& footprint) const;
    /// The same colours for the rays of a packet together, bit for bit.
    void look_up(scene::TextureIndex texture, TextureEncoding encoding,
                 const texture_lanes::Footprints& footprints, LaneVectors& colors) const;

    /// Warnings about textures that were read since: each is returned once.
    [[nodiscard]] Diagnostics warnings() const;

    /// The memory that the textures held in memory take once they are decoded, in bytes.
    [[nodiscard]] std::size_t held_bytes() const { return held_bytes_; }
    /// The memory that the parts of the other textures take now.
    [[nodiscard]] std::size_t file_bytes_in_memory() const { return file_->resident_bytes(); }

private:
    struct Entry {
        std::unique_ptr<const HeldTexture> held;
        mutable std::atomic<bool> reported = false;
    };

    /// Null if there is no texture, or it cannot be read.
    [[nodiscard]] const MipPyramid* pyramid(scene::TextureIndex texture,
                                            TextureEncoding encoding) const;

    std::unique_ptr<SpillFile> file_;
    mutable std::atomic<bool> file_reported_ = false;  // That it failed.
    // Two entries per texture, one for each encoding; null if it is not used or cannot be opened.
    std::vector<std::array<Entry, 2>> entries_;
    std::size_t held_bytes_ = 0;
    bool all_fit_ = true;
};

}  // namespace balcony::render
