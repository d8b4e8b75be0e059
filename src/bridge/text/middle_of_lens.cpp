// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/middle_of_lens.hpp"

#include <fmt/format.h>

namespace balcony::bridge {

namespace {

class MiddleOfLens final : public camera::Lens {
public:
    explicit MiddleOfLens(camera::LensPointer own) : own_(std::move(own)) {}
    camera::LensRays rays(const camera::CentralRay& central, const camera::AperturePoint& square,
                          camera::Emitter& emit) const override {
        return own_->rays(central, square, emit);
    }
    const camera::FocusSurface& focus() const override { return own_->focus(); }
    bool is_pinhole() const override { return true; }

private:
    camera::LensPointer own_;
};

}  // namespace

Result<camera::Camera> with_middle_of_lens(const camera::Camera& camera, const std::string& why,
                                           const std::string& remedy) {
    camera::Camera::Parts parts = camera.parts();
    if (parts.lens == nullptr) {
        return camera;
    }
    const Diagnostic left_out = warning(
        fmt::format("the blur of the lens of the camera '{}' is left out: {}", camera.name(), why),
        parts.lens_span, remedy);
    parts.lens = std::make_shared<const MiddleOfLens>(parts.lens);
    return {*camera::Camera::make(std::move(parts)).value, {left_out}};
}

}  // namespace balcony::bridge
