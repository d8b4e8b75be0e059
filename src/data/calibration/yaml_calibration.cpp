// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Calibrations in YAML: what OpenCV's FileStorage writes, ROS's camera_info, Kalibr's camchain, and
// what scripts write under the names of OpenCV's functions.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "data/calibration/calibration.hpp"
#include "data/yaml_places.hpp"

namespace balcony::data {

namespace {

using camera::Calibration;
using camera::CameraPose;

/// An entry and the names by which it is known, the first of which messages use. Case, '_' and '-'
/// do not matter.
using Names = std::vector<std::string_view>;
const Names matrix_names{"camera_matrix", "k", "intrinsic_matrix", "intrinsics", "mtx"};
const Names distortion_names{"distortion_coefficients",
                             "dist_coeffs",
                             "dist_coeff",
                             "distortion_coeffs",
                             "distortion",
                             "dist",
                             "d"};
const Names width_names{"image_width", "width"};
const Names height_names{"image_height", "height"};
const Names size_names{"image_size", "resolution", "img_size"};
const Names xi_names{"xi"};
const Names model_names{"distortion_model", "camera_model", "model"};
const Names fisheye_names{"fisheye_model", "fisheye"};
/// Kalibr has the model beside that of the distortion.
const Names chain_distortion_names{"distortion_model"};
const Names chain_model_names{"camera_model"};
const Names chain_step_names{"T_cn_cnm1"};
const Names rotation_names{"rotation", "rotation_matrix", "r", "rvec"};
const Names translation_names{"translation", "translation_vector", "t", "tvec"};

std::string simplified(std::string_view name) {
    std::string made;
    for (const char c : name) {
        if (c != '_' && c != '-') {
            made += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    return made;
}

class YamlReader {
public:
    explicit YamlReader(std::shared_ptr<const SourceText> source) : source_(std::move(source)) {}

    Result<std::vector<Calibration>> run() {
        try {
            read(YAML::Load(std::string(source_->text())));
        } catch (const YAML::Exception& problem) {
            error(place_of(source_, problem.mark, 1),
                  fmt::format("this is not YAML: {}", problem.msg),
                  "save the calibration with OpenCV's FileStorage, or write it like an example of "
                  "docs/calibrated.md");
        }
        if (has_errors(found_)) {
            return std::move(found_);
        }
        return {std::move(all_), std::move(found_)};
    }

private:
    // ------------------------------------------------------------------------ places and errors
    void error(SourceSpan span, std::string message, std::string remedy) {
        found_.push_back(balcony::error(std::move(message), std::move(span), std::move(remedy)));
    }

    [[nodiscard]] SourceSpan at(const YAML::Node& node) const { return place_of(source_, node); }

    // ---------------------------------------------------------------------------------- entries
    struct Entry {
        std::string name;
        SourceSpan place;
        YAML::Node node;
    };

    /// The entry of the file with one of these names.
    std::optional<Entry> find(const YAML::Node& file, const Names& names) {
        std::optional<Entry> found;
        for (const auto& pair : file) {
            if (!pair.first.IsScalar()) {
                continue;
            }
            const std::string name = pair.first.Scalar();
            if (std::none_of(names.begin(), names.end(), [&](std::string_view one) {
                    return simplified(one) == simplified(name);
                })) {
                continue;
            }
            if (found) {
                error(at(pair.first),
                      fmt::format("'{}' is the same entry as '{}'", name, found->name),
                      "remove one of the two");
                continue;
            }
            found = Entry{name, at(pair.first), pair.second};
        }
        return found;
    }

    /// The numbers of a scalar, a list, a list of lists, or OpenCV's and ROS's matrices.
    std::vector<EntryNumber> numbers(const Entry& entry) {
        std::vector<EntryNumber> made;
        if (entry.node.IsMap()) {
            const YAML::Node data = entry.node["data"];
            if (!data) {
                error(entry.place, fmt::format("the matrix '{}' has no data", entry.name),
                      "write rows, cols and data: [...]");
                return made;
            }
            collect(entry, data, made, 0);
            check_extent(entry, made.size());
        } else {
            collect(entry, entry.node, made, 0);
        }
        return made;
    }

    void collect(const Entry& entry, const YAML::Node& node, std::vector<EntryNumber>& made,
                 int depth) {
        constexpr std::size_t enough = 64;
        if (made.size() > enough || has_errors(found_)) {
            return;
        }
        if (node.IsSequence() && depth < 3) {
            for (const YAML::Node& one : node) {
                collect(entry, one, made, depth + 1);
            }
            return;
        }
        const std::optional<double> value =
            node.IsScalar() ? finite_number(node.Scalar()) : std::nullopt;
        if (!value) {
            error(at(node), fmt::format("'{}' has something else than a finite number", entry.name),
                  "calibrate again if it is .Nan or .Inf: the calibration has failed");
            return;
        }
        made.push_back({*value, at(node)});
    }

    void check_extent(const Entry& entry, std::size_t count) {
        const auto extent = [&entry](const char* name) {
            const YAML::Node node = entry.node[name];
            return node && node.IsScalar() ? finite_number(node.Scalar()) : std::nullopt;
        };
        const auto rows = extent("rows");
        const auto cols = extent("cols");
        if (rows && cols && *rows * *cols != static_cast<double>(count) && !has_errors(found_)) {
            error(entry.place,
                  fmt::format("the matrix '{}' has {:.6g} rows and {:.6g} columns, but {} numbers",
                              entry.name, *rows, *cols, count),
                  "check rows, cols and data");
        }
    }

    std::optional<EntryNumber> number(const YAML::Node& file, const Names& names) {
        const std::optional<Entry> entry = find(file, names);
        if (!entry) {
            return std::nullopt;
        }
        const std::vector<EntryNumber> all = numbers(*entry);
        if (all.size() != 1) {
            if (!has_errors(found_)) {
                error(entry->place, fmt::format("'{}' must be one number", entry->name),
                      fmt::format("write {}: 1920", names.front()));
            }
            return std::nullopt;
        }
        return all.front();
    }

    // --------------------------------------------------------------------------------- the file
    void read(const YAML::Node& file) {
        if (!file.IsMap()) {
            error({source_, 0, 0}, fmt::format("'{}' has no entries", source_->name()),
                  "a calibration has the entries camera_matrix, distortion_coefficients, "
                  "image_width and image_height");
            return;
        }
        if (const std::vector<Entry> chain = cameras_of_chain(file); !chain.empty()) {
            read_chain(chain);
            return;
        }
        made_.origin = "pixel_center";
        model(file, model_names);
        mirror(number(file, xi_names));
        image(file, find(file, matrix_names));
        distortion(file);
        pose(file);
        all_.push_back(std::move(made_));
    }

    /// The model that an entry says.
    void model(const YAML::Node& file, const Names& names) {
        if (const auto entry = find(file, names); entry && entry->node.IsScalar()) {
            const std::string name = simplified(entry->node.Scalar());
            if (name == "plumbbob" || name == "rationalpolynomial" || name == "radtan") {
                made_.model = "opencv_pinhole";
            } else if (name == "equidistant" || name == "fisheye" || name == "kannalabrandt" ||
                       name == "kannalabrandt4") {
                made_.model = "opencv_fisheye";
            } else if (name == "omnidir" || name == "mei") {
                made_.model = "omnidirectional";
            } else if (name != "pinhole" && name != "none") {
                error(at(entry->node),
                      fmt::format("there is no distortion model '{}'", entry->node.Scalar()),
                      "it is plumb_bob, rational_polynomial, equidistant, fisheye or omnidir");
            }
        }
        if (const auto fisheye = find(file, fisheye_names); fisheye && fisheye->node.IsScalar()) {
            const std::string says = simplified(fisheye->node.Scalar());
            if (says == "1" || says == "true") {
                made_.model = "opencv_fisheye";
            }
        }
    }

    /// Of a mirror: xi, which says that it is one.
    void mirror(const std::optional<EntryNumber>& xi) {
        if (xi) {
            made_.model = "omnidirectional";
            if (!(xi->value >= 0.0)) {
                error(xi->span, fmt::format("xi must not be negative, but is {:.6g}", xi->value),
                      "calibrate again: 0 is a pinhole, 1 a parabolic mirror");
            }
            made_.numbers.push_back({"xi", xi->value});
        } else if (made_.model == "omnidirectional" && !has_errors(found_)) {
            missing("xi", "omnidir::calibrate gives it");
        }
    }

    // ----------------------------------------------------------------------------------- Kalibr
    /// The entries cam0, cam1, ... of a camchain; none if the file has a camera of its own.
    std::vector<Entry> cameras_of_chain(const YAML::Node& file) {
        std::vector<Entry> chain;
        for (const auto& pair : file) {
            const std::string name = pair.first.IsScalar() ? pair.first.Scalar() : "";
            if (name == fmt::format("cam{}", chain.size()) && pair.second.IsMap()) {
                chain.push_back({name, at(pair.first), pair.second});
            }
        }
        return chain;
    }

    /// World is the first camera.
    void read_chain(const std::vector<Entry>& chain) {
        CameraPose pose{.rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, .translation = {}};
        for (std::size_t i = 0; i < chain.size() && !has_errors(found_); ++i) {
            made_ = {};
            made_.id = i;
            made_.origin = "pixel_center";
            const YAML::Node& camera = chain[i].node;
            model(camera, chain_distortion_names);
            projection(chain[i]);
            distortion(camera);
            if (i > 0) {
                pose = moved(pose, chain[i]);
            }
            made_.pose = pose;
            all_.push_back(made_);
        }
    }

    /// The entries camera_model and intrinsics of a camchain's camera.
    void projection(const Entry& camera) {
        const auto kind = find(camera.node, chain_model_names);
        const std::string name = kind && kind->node.IsScalar() ? kind->node.Scalar() : "pinhole";
        auto entry = find(camera.node, matrix_names);
        if (name != "pinhole" && name != "omni") {
            error(at(kind->node), fmt::format("Kalibr's camera model '{}' is not read", name),
                  "calibrate with --models pinhole-radtan, pinhole-equi or omni-radtan");
        } else if (name == "omni" && entry) {
            const std::vector<EntryNumber> all = numbers(*entry);
            if (all.size() != 5) {
                error(entry->place,
                      fmt::format("'{}' must have 5 numbers, but has {}", entry->name, all.size()),
                      "they are xi fx fy cx cy");
                return;
            }
            mirror(all.front());
            entry->node = YAML::Clone(entry->node);
            entry->node.remove(0);
        }
        image(camera.node, entry);
    }

    /// The pose of the next camera of a chain, whose T_cn_cnm1 leads from the last one to it.
    CameraPose moved(const CameraPose& last, const Entry& camera) {
        const auto entry = find(camera.node, chain_step_names);
        const std::vector<EntryNumber> m = entry ? numbers(*entry) : std::vector<EntryNumber>();
        if (m.size() != 16) {
            if (!has_errors(found_)) {
                error(camera.place, fmt::format("'{}' has no T_cn_cnm1 of 16 numbers", camera.name),
                      "keep the transformation that Kalibr has written");
            }
            return last;
        }
        CameraPose made{.rotation = {}, .translation = {}};
        for (std::size_t i = 0; i < 3; ++i) {
            made.translation[i] = m[4 * i + 3].value;
            for (std::size_t k = 0; k < 3; ++k) {
                made.translation[i] += m[4 * i + k].value * last.translation[k];
                for (std::size_t j = 0; j < 3; ++j) {
                    made.rotation[i][j] += m[4 * i + k].value * last.rotation[k][j];
                }
            }
        }
        if (!is_rotation(made.rotation)) {
            error(entry->place, fmt::format("'{}' is not a rotation", entry->name),
                  "its rows must be of length 1, at right angles to each other and right-handed");
        }
        return made;
    }

    void missing(std::string_view name, std::string_view remedy) {
        error({source_, 0, 0}, fmt::format("'{}' has no entry {}", source_->name(), name),
              std::string(remedy));
    }

    void image(const YAML::Node& file, const std::optional<Entry>& entry) {
        ImageEntries entries{.width = number(file, width_names),
                             .height = number(file, height_names)};
        if (const auto size = find(file, size_names); size && !entries.width && !entries.height) {
            const std::vector<EntryNumber> both = numbers(*size);
            if (both.size() == 2) {
                entries.width = both[0];
                entries.height = both[1];
            } else if (!has_errors(found_)) {
                error(size->place, fmt::format("'{}' must be two numbers", size->name),
                      "write the width and the height: [1920, 1080]");
            }
        }
        if (!entry) {
            missing("camera_matrix",
                    "write camera_matrix: with the numbers fx 0 cx, 0 fy cy, 0 0 1");
            return;
        }
        const std::vector<EntryNumber> m = numbers(*entry);
        if (m.size() == 4) {
            entries.fx = m[0];
            entries.fy = m[1];
            entries.cx = m[2];
            entries.cy = m[3];
        } else if (m.size() == 9) {
            entries.fx = m[0];
            entries.fy = m[4];
            entries.cx = m[2];
            entries.cy = m[5];
            check_matrix(*entry, m);
            skew(m[1]);
        } else if (!has_errors(found_)) {
            error(entry->place,
                  fmt::format("'{}' must have 9 numbers, but has {}", entry->name, m.size()),
                  "they are fx 0 cx, 0 fy cy, 0 0 1");
        }
        if (!has_errors(found_)) {
            check_image(entries, found_);
            add_image(entries, made_);
        }
    }

    void check_matrix(const Entry& entry, const std::vector<EntryNumber>& m) {
        constexpr std::array<std::pair<std::size_t, double>, 4> fixed{
            {{3, 0.0}, {6, 0.0}, {7, 0.0}, {8, 1.0}}};
        for (const auto& [i, value] : fixed) {
            if (m[i].value != value) {
                error(m[i].span,
                      fmt::format("number {} of '{}' must be {:.6g}, but is {:.6g}", i + 1,
                                  entry.name, value, m[i].value),
                      "its numbers are fx 0 cx, 0 fy cy, 0 0 1, row by row");
                return;
            }
        }
    }

    /// OpenCV's pinhole ignores it.
    void skew(const EntryNumber& skew) {
        if (skew.value == 0.0) {
            return;
        }
        if (made_.model.empty() || made_.model == "opencv_pinhole") {
            found_.push_back(warning("OpenCV's pinhole model ignores the skew of the camera matrix",
                                     skew.span, "write 0, or use opencv_pinhole(skew = ...)"));
        } else {
            made_.numbers.push_back({"skew", skew.value});
        }
    }

    void distortion(const YAML::Node& file) {
        const std::optional<Entry> entry = find(file, distortion_names);
        if (!entry) {
            missing("distortion_coefficients",
                    "write distortion_coefficients: [0, 0, 0, 0] for a lens without distortion");
            return;
        }
        const std::vector<EntryNumber> d = numbers(*entry);
        if (has_errors(found_) || d.empty()) {
            return;
        }
        const bool four = made_.model == "opencv_fisheye" || made_.model == "omnidirectional";
        const std::vector<std::size_t> counts =
            four ? std::vector<std::size_t>{4} : std::vector<std::size_t>{4, 5, 8, 12, 14};
        if (std::find(counts.begin(), counts.end(), d.size()) == counts.end()) {
            error(entry->place,
                  fmt::format("'{}' must have {} numbers, but has {}", entry->name,
                              four ? "4" : "4, 5, 8, 12 or 14", d.size()),
                  "they are in OpenCV's order");
            return;
        }
        for (const EntryNumber& one : d) {
            made_.distortion.push_back(one.value);
        }
    }

    // ------------------------------------------------------------------------------------- pose
    void pose(const YAML::Node& file) {
        const auto rotation = find(file, rotation_names);
        const auto translation = find(file, translation_names);
        if (!rotation || !translation) {
            return;
        }
        const std::vector<EntryNumber> r = numbers(*rotation);
        const std::vector<EntryNumber> t = numbers(*translation);
        if (has_errors(found_)) {
            return;
        }
        if ((r.size() != 3 && r.size() != 9) || t.size() != 3) {
            const Entry& wrong = t.size() != 3 ? *translation : *rotation;
            error(wrong.place, fmt::format("'{}' has a wrong number of numbers", wrong.name),
                  "a rotation has 9 or, as a vector, 3 numbers; a translation has 3");
            return;
        }
        CameraPose made{.rotation = {}, .translation = {t[0].value, t[1].value, t[2].value}};
        if (r.size() == 3) {
            made.rotation = rotation_of({r[0].value, r[1].value, r[2].value});
        } else {
            for (std::size_t i = 0; i < 9; ++i) {
                made.rotation[i / 3][i % 3] = r[i].value;
            }
        }
        if (!is_rotation(made.rotation)) {
            error(rotation->place, fmt::format("'{}' is not a rotation", rotation->name),
                  "its rows must be of length 1, at right angles to each other and right-handed");
            return;
        }
        made_.pose = made;
    }

    std::shared_ptr<const SourceText> source_;
    Calibration made_;  ///< The camera that is being read.
    std::vector<Calibration> all_;
    Diagnostics found_;
};

}  // namespace

Result<std::vector<Calibration>> read_yaml_calibration(
    const std::shared_ptr<const SourceText>& source) {
    return YamlReader(source).run();
}

}  // namespace balcony::data
