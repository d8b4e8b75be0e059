// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/blender_lens.hpp"

#include "bridge/text/middle_of_lens.hpp"

namespace balcony::bridge {

namespace {

using camera::AperturePoint;
using camera::CentralRay;
using camera::Emitter;
using camera::FocusSurface;
using camera::LensPointer;
using camera::Scalar;
using camera::ThinLens;
using expr::Expr;

/// The distance of Blender's camera, or the camera's own surface.
class BlenderFocus final : public FocusSurface {
public:
    explicit BlenderFocus(LensPointer own) : own_(std::move(own)) {}
    Expr vergence(const CentralRay& ray, Emitter& emit) const override {
        const Expr wanted = emit.graph().input(own_focus_input);
        return select(0.0 < wanted, own_->focus().vergence(ray, emit),
                      1.0 / emit.graph().input(focal_distance_input));
    }
    std::optional<std::string> object() const override { return own_->focus().object(); }

private:
    LensPointer own_;
};

/// The aperture of Blender's camera, which has its size already.
class BlenderLens final : public ThinLens {
public:
    explicit BlenderLens(LensPointer own) : focus_(std::move(own)) {}
    Scalar radius() const override { return 1.0; }
    AperturePoint aperture(const AperturePoint&, Emitter& emit) const override {
        return {emit.graph().input(aperture_x_input), emit.graph().input(aperture_y_input)};
    }
    const FocusSurface& focus() const override { return focus_; }

private:
    BlenderFocus focus_;
};

}  // namespace

Result<camera::Camera> with_blender_lens(const camera::Camera& camera) {
    if (!camera.parts().lens) {
        return camera;
    }
    if (std::dynamic_pointer_cast<const ThinLens>(camera.parts().lens) == nullptr) {
        return with_middle_of_lens(camera, "the aperture of Blender's camera lies across each ray",
                                   "use 'balcony render', or lens(radius, focus)");
    }
    camera::Camera::Parts parts = camera.parts();
    parts.lens = std::make_shared<const BlenderLens>(parts.lens);
    return camera::Camera::make(std::move(parts));
}

}  // namespace balcony::bridge
