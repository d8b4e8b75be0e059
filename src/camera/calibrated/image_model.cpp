// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/calibrated/image_model.hpp"

#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Its points are the viewpoint, or at a distance from it on the rays; its normals are the rays.
class CalibratedCamera final : public ObjectGenerator {
public:
    CalibratedCamera(const ImageFrame& frame, std::shared_ptr<const ImageModel> model,
                     Scalar radius)
        : frame_(frame), model_(std::move(model)), radius_(std::move(radius)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectVector along = ray(p, emit);
        const Expr d = emit(radius_);
        return {d * along.x, d * along.y, d * along.z};
    }
    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        return ray(p, emit);
    }
    std::optional<ParameterRectangle> own_picture() const override {
        return ParameterRectangle{0.0, frame_.width, frame_.height, 0.0};
    }

private:
    /// In the camera's axes: forward is x, left is y and up is z.
    ObjectVector ray(const ParameterPoint& p, Emitter& emit) const {
        const auto [x, y] = frame_.normalized(p.u, p.v);
        const ObjectVector d = to_unit_length(model_->direction(x, y, emit));
        return {d.z, -d.x, -d.y};
    }

    ImageFrame frame_;
    std::shared_ptr<const ImageModel> model_;
    Scalar radius_;
};

StageParameter size_number(std::string_view name, std::string_view meaning) {
    constexpr double largest_image = 1e6;
    return {.name = name,
            .type =
                NumberParameter{
                    .range = {.minimum = 0.0, .maximum = largest_image, .excludes_minimum = true},
                    .constant = true},
            .meaning = meaning};
}

StageParameter focal_length(std::string_view name, bool optional, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true},
                                    .constant = true},
            .optional = optional,
            .meaning = meaning};
}

StageParameter center_number(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.constant = true},
            .optional = true,
            .meaning = meaning};
}

}  // namespace

std::vector<StageParameter> frame_parameters() {
    return {
        size_number("width", "the width of the calibrated image in pixels"),
        size_number("height", "its height in pixels"),
        focal_length("fx", false, "the focal length in pixels along x"),
        focal_length("fy", true, "the focal length in pixels along y; without it, fx"),
        center_number("cx", "x of the centre of the lens in pixels; without it, of the image"),
        center_number("cy",
                      "y of the centre of the lens in pixels, from the top; without it, of the "
                      "image"),
        {.name = "skew",
         .type = NumberParameter{.default_value = 0.0, .constant = true},
         .meaning = "how much x in pixels grows with y in focal lengths"},
        choice_parameter(
            "origin", {"pixel_center", "pixel_corner"},
            "where cx = cy = 0 is: in the centre of the top left pixel, as in OpenCV, or in "
            "its outer corner, as in COLMAP"),
    };
}

ImageFrame frame_of(const Arguments& a) {
    const auto given = [&a](std::string_view name, double otherwise) {
        return a.has(name) ? a.constant(name) : otherwise;
    };
    const double corner = a.choice("origin") == "pixel_center" ? 0.5 : 0.0;
    ImageFrame frame{.width = a.constant("width"),
                     .height = a.constant("height"),
                     .fx = a.constant("fx"),
                     .skew = a.constant("skew")};
    frame.fy = given("fy", frame.fx);
    frame.cx = given("cx", 0.5 * frame.width - corner) + corner;
    frame.cy = given("cy", 0.5 * frame.height - corner) + corner;
    return frame;
}

StageParameter sphere_parameter() {
    return number_parameter("radius", 0.0,
                            "the radius of the sphere of its points: 0 for an eye object, whose "
                            "rays are its normals; 1 for a direction object");
}

StageParameter coefficient_parameter(std::string_view name, double value,
                                     std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.default_value = value, .constant = true},
            .meaning = meaning};
}

std::shared_ptr<const Stage> calibrated_camera(const Arguments& a, const ImageFrame& frame,
                                               std::shared_ptr<const ImageModel> model) {
    return std::make_shared<const CalibratedCamera>(frame, std::move(model), a.number("radius"));
}

StageEntry calibrated_row(StageEntry row) {
    row.parameters = frame_parameters() + row.parameters + std::vector{sphere_parameter()};
    row.dimension = 2;
    return row;
}

}  // namespace balcony::camera
