// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: the calibrated cameras of files. A file has the numbers of one of
// the other calibrated cameras.

#include <algorithm>

#include <fmt/format.h>

#include "balcony/make_stage.hpp"
#include "balcony/names.hpp"
#include "camera/calibrated/image_model.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// A camera where its file has it in the world.
class PosedCamera final : public ObjectGenerator {
public:
    PosedCamera(ObjectGeneratorPointer camera, const CameraPose& pose)
        : camera_(std::move(camera)), pose_(pose) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectPoint at = camera_->generate(p, emit);
        const auto& t = pose_.translation;
        const ObjectVector from = in_world({-at.y - t[0], -at.z - t[1], at.x - t[2]});
        return {from.x, from.y, from.z};
    }
    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectVector n = *camera_->normal(p, emit);
        return in_world({-n.y, -n.z, n.x});
    }
    std::optional<ParameterRectangle> own_picture() const override {
        return camera_->own_picture();
    }

private:
    /// By the transposed rotation, from the axes x right, y down, z forward.
    ObjectVector in_world(const ObjectVector& a) const {
        const auto& r = pose_.rotation;
        return {r[0][0] * a.x + r[1][0] * a.y + r[2][0] * a.z,
                r[0][1] * a.x + r[1][1] * a.y + r[2][1] * a.z,
                r[0][2] * a.x + r[1][2] * a.y + r[2][2] * a.z};
    }

    ObjectGeneratorPointer camera_;
    CameraPose pose_;
};

bool has_number(const Calibration& calibration, std::string_view name) {
    return std::any_of(calibration.numbers.begin(), calibration.numbers.end(),
                       [name](const Calibration::Number& one) { return one.name == name; });
}

/// OpenCV's distortion coefficients in its order, by the parameters of the model's row.
std::vector<std::string_view> coefficient_names(std::string_view model) {
    if (model == "opencv_fisheye") {
        return {"k1", "k2", "k3", "k4"};
    }
    if (model == "omnidirectional") {
        return {"k1", "k2", "p1", "p2"};
    }
    return {"k1", "k2", "p1", "p2", "k3", "k4",    "k5",
            "k6", "s1", "s2", "s3", "s4", "tau_x", "tau_y"};
}

/// The camera of a file by the row of its model, with width and height from the arguments if they
/// are given there.
StageResult make_from_file(const Arguments& a, const std::string& file, Calibration calibration,
                           std::string_view model) {
    for (const std::string_view size : {"width", "height"}) {
        if (a.has(size)) {
            std::erase_if(calibration.numbers,
                          [size](const auto& one) { return one.name == size; });
            calibration.numbers.push_back({std::string(size), a.constant(size)});
        } else if (!has_number(calibration, size)) {
            return error(fmt::format("'{}' has no entry image_{}", file, size), {},
                         "write it: opencv(\"calibration.yml\", width = 1920, height = 1080)");
        }
    }
    const StageEntry* row = catalogue().find(StageKind::object_generator, model);
    assert(row != nullptr && "the readers know the models");
    std::vector<NamedValue> values{{"radius", a.number("radius")}, {"origin", calibration.origin}};
    for (const Calibration::Number& number : calibration.numbers) {
        values.push_back({number.name, Scalar(number.value, Unit::either)});
    }
    if (!calibration.points.empty()) {
        Points points;
        for (const auto& [x, y] : calibration.points) {
            points.push_back({x, y});
        }
        values.push_back({"points", std::move(points)});
    }
    const std::vector<std::string_view> names = coefficient_names(model);
    if (calibration.distortion.size() > names.size()) {
        return error(fmt::format("'{}' has {} distortion coefficients, but this model has {}", file,
                                 calibration.distortion.size(), names.size()),
                     {}, "check that it is the calibration of a fisheye lens");
    }
    for (std::size_t i = 0; i < calibration.distortion.size(); ++i) {
        values.push_back({names[i], Scalar(calibration.distortion[i], Unit::either)});
    }
    StageResult made = make_stage(*row, values);
    if (!made || a.choice("pose") == "standard") {
        return made;
    }
    if (!calibration.pose) {
        return error(fmt::format("'{}' has no position and orientation of the camera", file), {},
                     "remove pose = file, and move the camera with move");
    }
    return {std::make_shared<const PosedCamera>(
                std::static_pointer_cast<const ObjectGenerator>(*made), *calibration.pose),
            std::move(made.diagnostics)};
}

/// The camera of a file that has the number in the arguments, or its only camera; `stage` is for
/// messages.
Result<const Calibration*> chosen(const CalibrationFile& file, const Arguments& a,
                                  std::string_view stage) {
    const bool is_named = a.has("camera");
    const std::size_t number = is_named ? a.count("camera") : 0;
    std::vector<std::string> known;
    for (const Calibration& one : file.cameras) {
        if (is_named ? one.id == number : file.cameras.size() == 1) {
            return &one;
        }
        known.push_back(fmt::format("{}", one.id.value_or(0)));
    }
    if (!is_named) {
        return error(fmt::format("'{}' has {} cameras", file.name, file.cameras.size()), {},
                     fmt::format("name one by its number: {}(\"{}\", camera = {})", stage,
                                 file.name, known.front()));
    }
    return error(fmt::format("'{}' has no camera {}", file.name, number), {},
                 suggestion("", known, "its cameras are"));
}

StageResult make_opencv(const Arguments& a) {
    const CalibrationFile& file = *a.file<CalibrationFile>("file");
    const Result<const Calibration*> calibration = chosen(file, a, "opencv");
    if (!calibration) {
        return calibration.diagnostics;
    }
    const std::string& stated = (*calibration)->model;
    const std::string& model = a.choice("model");
    const std::string given = model == "pinhole"   ? "opencv_pinhole"
                              : model == "fisheye" ? "opencv_fisheye"
                                                   : stated;
    if (!stated.empty() && given != stated) {
        return error(fmt::format("'{}' says that its model is {}", file.name, stated), {},
                     "remove model");
    }
    return make_from_file(a, file.name, **calibration, given.empty() ? "opencv_pinhole" : given);
}

StageResult make_stated(const Arguments& a, std::string_view stage) {
    const CalibrationFile& file = *a.file<CalibrationFile>("file");
    const Result<const Calibration*> calibration = chosen(file, a, stage);
    if (!calibration) {
        return calibration.diagnostics;
    }
    const std::string& stated = (*calibration)->model;
    return make_from_file(a, file.name, **calibration, stated.empty() ? "opencv_pinhole" : stated);
}

StageResult make_colmap(const Arguments& a) { return make_stated(a, "colmap"); }
StageResult make_mrcal(const Arguments& a) { return make_stated(a, "mrcal"); }

StageParameter file_parameter(std::string_view meaning) {
    return {.name = "file", .type = CalibrationParameter{}, .meaning = meaning};
}

StageParameter camera_parameter() {
    return {.name = "camera",
            .type = CountParameter{.range = {.minimum = 0.0, .maximum = 1e6}},
            .optional = true,
            .meaning = "the number of the camera in the file; without it, the only one"};
}

StageParameter size_parameter(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true},
                                    .constant = true},
            .optional = true,
            .meaning = meaning};
}

std::vector<StageParameter> placing_parameters() {
    return {
        size_parameter("width",
                       "the width of the calibrated image in pixels; without it, that "
                       "of the file"),
        size_parameter("height", "its height in pixels"),
        choice_parameter("pose", {"standard", "file"},
                         "where the camera is: at the origin, looking along x with z up; or where "
                         "the file has it in its world"),
        sphere_parameter()};
}

}  // namespace

std::vector<StageEntry> calibration_files() {
    return {
        {.name = "opencv",
         .meaning = "a calibrated camera of a YAML file of OpenCV, ROS or Kalibr",
         .formula = R"(
that of opencv_pinhole, opencv_fisheye or omnidirectional
with the numbers of the file
)",
         .parameters =
             std::vector{file_parameter("the file: camera_matrix, "
                                        "distortion_coefficients, image_width, "
                                        "image_height, or their usual other names"),
                         choice_parameter("model", {"file", "pinhole", "fisheye", "omnidir"},
                                          "OpenCV's model: what the file says, or pinhole "
                                          "if it says nothing")} +
             placing_parameters() + std::vector{camera_parameter()},
         .make = make_opencv,
         .dimension = 2,
         .example = R"(
camera webcam {
    eye opencv("webcam.yml")
}
)"},
        {.name = "colmap",
         .meaning = "a calibrated camera of COLMAP's cameras.txt, of any of its models",
         .formula = R"(
that of the model's own object with the file's numbers
)",
         .parameters =
             std::vector{file_parameter("the file cameras.txt of a model exported as text"),
                         camera_parameter()} +
             placing_parameters(),
         .make = make_colmap,
         .dimension = 2,
         .example = R"(
camera survey {
    eye colmap("cameras.txt", camera = 2)
}
)"},
        {.name = "mrcal",
         .meaning = "a calibrated camera of a file that mrcal writes",
         .formula = R"(
that of opencv_pinhole or splined_stereographic with the numbers of the file
)",
         .parameters = std::vector{file_parameter("the file: a .cameramodel of LENSMODEL_PINHOLE, "
                                                  "LENSMODEL_OPENCV4, 5, 8 or 12, or "
                                                  "LENSMODEL_SPLINED_STEREOGRAPHIC")} +
                       placing_parameters() + std::vector{camera_parameter()},
         .make = make_mrcal,
         .dimension = 2,
         .example = R"(
camera drone {
    eye mrcal("drone.cameramodel")
}
)"},
    };
}

}  // namespace balcony::camera
