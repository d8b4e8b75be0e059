// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// mrcal's .cameramodel: a dictionary of Python with numbers, lists and texts, which is also YAML
// but for the bytes of what the calibration was made from.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "data/calibration/calibration.hpp"
#include "data/yaml_places.hpp"

namespace balcony::data {

namespace {

using camera::Calibration;

constexpr std::string_view splined = "LENSMODEL_SPLINED_STEREOGRAPHIC_";
constexpr std::size_t core = 4;  // fx fy cx cy, before all others.

/// With bytes, such as b'...', in blanks; the places stay as they are.
std::string without_bytes(std::string text) {
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        const char quote = text[i + 1];
        const bool begins = text[i] == 'b' && (quote == '\'' || quote == '"') &&
                            (text[i - 1] == ' ' || text[i - 1] == ':');
        if (!begins) {
            continue;
        }
        std::size_t end = i + 2;
        while (end < text.size() && text[end] != quote) {
            end += text[end] == '\\' ? 2 : 1;
        }
        end = std::min(end + 1, text.size());
        std::fill(text.begin() + static_cast<std::ptrdiff_t>(i),
                  text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        i = end;
    }
    return text;
}

class MrcalReader {
public:
    explicit MrcalReader(std::shared_ptr<const SourceText> source) : source_(std::move(source)) {}

    Result<std::vector<Calibration>> run() {
        try {
            read(YAML::Load(without_bytes(std::string(source_->text()))));
        } catch (const YAML::Exception& problem) {
            error(place_of(source_, problem.mark, 1),
                  fmt::format("this is no dictionary of mrcal: {}", problem.msg),
                  "write the model again with mrcal's cameramodel.write()");
        }
        if (has_errors(found_)) {
            return std::move(found_);
        }
        return {std::vector{std::move(made_)}, std::move(found_)};
    }

private:
    void error(SourceSpan span, std::string message, std::string remedy) {
        found_.push_back(balcony::error(std::move(message), std::move(span), std::move(remedy)));
    }

    void read(const YAML::Node& file) {
        if (!file.IsMap()) {
            error({source_, 0, 0}, fmt::format("'{}' is no dictionary of mrcal", source_->name()),
                  "write the model again with mrcal's cameramodel.write()");
            return;
        }
        made_.origin = "pixel_center";
        const YAML::Node model = file["lensmodel"];
        const std::vector<EntryNumber> size = numbers(file, "imagersize", 2);
        const std::vector<EntryNumber> intrinsics = numbers(file, "intrinsics", 0);
        const bool has_reference = file["rt_cam_ref"].IsDefined();
        const std::vector<EntryNumber> pose =
            numbers(file, has_reference ? "rt_cam_ref" : "extrinsics", 6);
        if (has_errors(found_)) {
            return;
        }
        if (!lens(model, intrinsics)) {
            return;
        }
        const ImageEntries image{.width = size[0],
                                 .height = size[1],
                                 .fx = intrinsics[0],
                                 .fy = intrinsics[1],
                                 .cx = intrinsics[2],
                                 .cy = intrinsics[3]};
        check_image(image, found_);
        add_image(image, made_);
        made_.pose = {.rotation = rotation_of({pose[0].value, pose[1].value, pose[2].value}),
                      .translation = {pose[3].value, pose[4].value, pose[5].value}};
    }

    /// So many numbers, or any.
    std::vector<EntryNumber> numbers(const YAML::Node& file, const char* name, std::size_t count) {
        const YAML::Node list = file[name];
        std::vector<EntryNumber> made;
        if (!list || !list.IsSequence()) {
            error({source_, 0, 0}, fmt::format("'{}' has no list '{}'", source_->name(), name),
                  "write the model again with mrcal's cameramodel.write()");
            return made;
        }
        for (const YAML::Node& one : list) {
            const auto value = one.IsScalar() ? finite_number(one.Scalar()) : std::nullopt;
            if (!value) {
                error(place_of(source_, one),
                      fmt::format("'{}' has something else than a finite number", name),
                      "calibrate again if it is nan or inf: the calibration has failed");
                return {};
            }
            made.push_back({*value, place_of(source_, one)});
        }
        if (count > 0 && made.size() != count) {
            error(place_of(source_, list),
                  fmt::format("'{}' must have {} numbers, but has {}", name, count, made.size()),
                  "write the model again with mrcal's cameramodel.write()");
        }
        return made;
    }

    /// False with an error.
    bool lens(const YAML::Node& entry, const std::vector<EntryNumber>& intrinsics) {
        const std::string name = entry && entry.IsScalar() ? entry.Scalar() : "";
        std::size_t further = 0;
        made_.model = "opencv_pinhole";
        if (name.starts_with(splined)) {
            if (!splines(entry, name.substr(splined.size()), further)) {
                return false;
            }
        } else if (name.starts_with("LENSMODEL_OPENCV")) {
            const auto count = finite_number(name.substr(16));
            further = count && (*count == 4 || *count == 5 || *count == 8 || *count == 12)
                          ? static_cast<std::size_t>(*count)
                          : 0;
        }
        if (further == 0 && name != "LENSMODEL_PINHOLE") {
            error(entry ? place_of(source_, entry) : SourceSpan{source_, 0, 0},
                  fmt::format("the lens model '{}' is not read", name),
                  "convert it: mrcal-convert-lensmodel LENSMODEL_OPENCV8 x.cameramodel");
            return false;
        }
        if (intrinsics.size() != core + further) {
            error(intrinsics.empty() ? SourceSpan{source_, 0, 0} : intrinsics.back().span,
                  fmt::format("the lens model {} has {} intrinsics, but this file has {}", name,
                              core + further, intrinsics.size()),
                  "write the model again with mrcal's cameramodel.write()");
            return false;
        }
        for (std::size_t i = core; i < intrinsics.size(); ++i) {
            if (made_.model == "opencv_pinhole") {
                made_.distortion.push_back(intrinsics[i].value);
            } else if (i % 2 == 0) {
                made_.points.push_back({intrinsics[i].value, intrinsics[i + 1].value});
            }
        }
        return true;
    }

    /// What the name of a splined model says: order=3_Nx=30_Ny=20_fov_x_deg=150.
    bool splines(const YAML::Node& entry, std::string_view rest, std::size_t& further) {
        std::array<double, 4> values{};
        constexpr std::array<std::string_view, 4> names{"order=", "_Nx=", "_Ny=", "_fov_x_deg="};
        bool good = true;
        for (std::size_t i = 0; i < names.size() && good; ++i) {
            good = rest.starts_with(names[i]);
            rest.remove_prefix(good ? names[i].size() : 0);
            const std::size_t end = std::min(rest.find('_'), rest.size());
            const auto value = finite_number(rest.substr(0, end));
            const bool is_count = i + 1 < names.size();
            good = good && value && *value >= 2.0 && *value <= 1000.0 &&
                   (!is_count || *value == std::floor(*value));
            values[i] = value.value_or(0.0);
            rest.remove_prefix(end);
        }
        const auto [order, columns, rows, degrees] = values;
        if (!good || !rest.empty()) {
            error(place_of(source_, entry), "this is no splined model of mrcal",
                  fmt::format("such as {}order=3_Nx=30_Ny=20_fov_x_deg=150", splined));
            return false;
        }
        made_.model = "splined_stereographic";
        made_.numbers = {
            {"order", order}, {"columns", columns}, {"fov", degrees * std::numbers::pi / 180.0}};
        further = 2 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
        return true;
    }

    std::shared_ptr<const SourceText> source_;
    Calibration made_;
    Diagnostics found_;
};

}  // namespace

Result<std::vector<Calibration>> read_mrcal_model(const std::shared_ptr<const SourceText>& source) {
    return MrcalReader(source).run();
}

}  // namespace balcony::data
