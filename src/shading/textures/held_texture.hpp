// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "shading/textures/mip_pyramid.hpp"

namespace balcony::render {

/// A texture that is decoded as a whole, once: when it is first used; in memory, or in a file if
/// one is given. Any number of threads may use it.
class HeldTexture {
public:
    /// The file must outlive this.
    HeldTexture(scene::Texture texture, TextureEncoding encoding, SpillFile* file = nullptr)
        : texture_(std::move(texture)), encoding_(encoding), file_(file) {}

    /// Null if the image cannot be read, or the file cannot be any more.
    [[nodiscard]] const MipPyramid* pyramid() const {
        if (!read_.load(std::memory_order_acquire)) {
            decode({});
        }
        const bool is_lost = file_ != nullptr && file_->has_failed();
        return pyramid_ && !is_lost ? &*pyramid_ : nullptr;
    }

    /// Decodes the texture if it is not yet, unless a stop ends that.
    void decode(const std::stop_token& stop) const;

    [[nodiscard]] bool in_memory() const { return file_ == nullptr; }
    [[nodiscard]] const scene::Texture& texture() const { return texture_; }
    /// What is known once it was read: the reason if that failed, and whether some value was not
    /// finite.
    [[nodiscard]] bool was_read() const { return read_.load(std::memory_order_acquire); }
    [[nodiscard]] const std::optional<Diagnostic>& failure() const { return failure_; }
    [[nodiscard]] bool repaired() const { return repaired_; }

private:
    void read(const std::stop_token& stop) const;

    scene::Texture texture_;
    TextureEncoding encoding_;
    SpillFile* file_;
    mutable std::once_flag once_;
    mutable std::atomic<bool> read_ = false;  // The following members are set.
    mutable std::optional<MipPyramid> pyramid_;
    mutable std::optional<Diagnostic> failure_;
    mutable bool repaired_ = false;
};

}  // namespace balcony::render
