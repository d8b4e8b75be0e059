// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "data/calibration/calibration.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "data/files.hpp"

namespace balcony::data {

namespace {

using camera::Calibration;
using camera::CalibrationFile;

constexpr double largest_image = 1e6;  // pixels along a side

bool is_size(double value) {
    return value >= 1.0 && value <= largest_image && value == std::floor(value);
}

void check_size(const std::optional<EntryNumber>& size, std::string_view name, Diagnostics& found) {
    if (size && !is_size(size->value)) {
        found.push_back(
            error(fmt::format("the {} of the image cannot be {:.6g} pixels", name, size->value),
                  size->span, "write a whole number above 0"));
    }
}

void check_focal_length(const EntryNumber& f, std::string_view name, Diagnostics& found) {
    if (!(f.value > 0.0)) {
        found.push_back(
            error(fmt::format("the focal length {} must be above 0, but is {:.6g}", name, f.value),
                  f.span,
                  "check the order of the entries: the camera matrix is fx 0 cx, 0 fy cy, 0 0 1"));
    }
}

void check_center(const EntryNumber& center, std::string_view name,
                  const std::optional<EntryNumber>& size, std::string_view extent,
                  Diagnostics& found) {
    if (!size || !is_size(size->value)) {
        return;
    }
    const double part = center.value / size->value;
    if (!(part >= 0.0 && part <= 1.0)) {
        found.push_back(error(
            fmt::format("the centre {} = {:.6g} is outside of the image, whose {} is {:.6g}", name,
                        center.value, extent, size->value),
            center.span,
            "check that it is not swapped with a focal length, nor width with height, and that the "
            "calibration is for this size"));
    } else if (std::abs(part - 0.5) > 0.25) {
        found.push_back(warning(
            fmt::format("the centre {} = {:.6g} is far from the middle of the image, whose {} is "
                        "{:.6g}",
                        name, center.value, extent, size->value),
            center.span, "check that width and height are not swapped"));
    }
}

void check_ratio(const EntryNumber& fx, const EntryNumber& fy, Diagnostics& found) {
    const double ratio = fx.value / fy.value;
    if (fx.value > 0.0 && fy.value > 0.0 && !(ratio > 0.5 && ratio < 2.0)) {
        found.push_back(
            warning(fmt::format("the focal lengths fx = {:.6g} and fy = {:.6g} are very different",
                                fx.value, fy.value),
                    fy.span, "check that neither is swapped with a coordinate of the centre"));
    }
}

bool is_yaml(std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first != std::string_view::npos && line[first] != '#') {
            return line[first] == '%' || line.find(':') != std::string_view::npos ||
                   line.starts_with("---");
        }
        begin = end + 1;
    }
    return false;
}

}  // namespace

std::optional<double> finite_number(std::string_view text) {
    double value = 0.0;
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = status == std::errc() && stop == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void check_image(const ImageEntries& entries, Diagnostics& found) {
    check_size(entries.width, "width", found);
    check_size(entries.height, "height", found);
    check_focal_length(entries.fx, "fx", found);
    check_focal_length(entries.fy, "fy", found);
    check_ratio(entries.fx, entries.fy, found);
    check_center(entries.cx, "cx", entries.width, "width", found);
    check_center(entries.cy, "cy", entries.height, "height", found);
}

void add_image(const ImageEntries& entries, Calibration& calibration) {
    const auto add = [&calibration](std::string_view name, const EntryNumber& number) {
        calibration.numbers.push_back({std::string(name), number.value});
    };
    if (entries.width) {
        add("width", *entries.width);
    }
    if (entries.height) {
        add("height", *entries.height);
    }
    add("fx", entries.fx);
    add("fy", entries.fy);
    add("cx", entries.cx);
    add("cy", entries.cy);
}

Matrix rotation_of(const std::array<double, 3>& axis) {
    const double angle = std::hypot(axis[0], axis[1], axis[2]);
    const double s = angle > 0.0 ? std::sin(angle) / angle : 1.0;
    const double c = angle > 0.0 ? (1.0 - std::cos(angle)) / (angle * angle) : 0.5;
    Matrix made{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            made[i][j] = c * axis[i] * axis[j] + (i == j ? std::cos(angle) : 0.0);
        }
        const std::size_t next = (i + 1) % 3;
        const std::size_t last = (i + 2) % 3;
        made[i][next] -= s * axis[last];
        made[i][last] += s * axis[next];
    }
    return made;
}

bool is_rotation(const Matrix& r) {
    constexpr double rounding = 1e-4;  // of files with five digits
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = r[i];
        const auto& b = r[(i + 1) % 3];
        const auto& c = r[(i + 2) % 3];
        // c = a x b
        for (std::size_t k = 0; k < 3; ++k) {
            const double product =
                a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
            if (!(std::abs(product - c[k]) < rounding)) {
                return false;
            }
        }
        if (!(std::abs(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1.0) < rounding)) {
            return false;
        }
    }
    return true;
}

Result<std::shared_ptr<const CalibrationFile>> read_calibration(const File& file) {
    const auto source = read_text(file, max_calibration,
                                  "export the calibration as YAML, or COLMAP's model as text");
    if (!source) {
        return source.diagnostics;
    }
    const std::string_view all = (*source)->text();
    if (all.substr(std::min(all.find_first_not_of(" \t\r\n"), all.size())).starts_with('<')) {
        return error(fmt::format("'{}' is XML, which is not read", file.name), {*source, 0, 1},
                     "save the calibration as YAML: OpenCV's FileStorage does it for a file name "
                     "that ends in .yml");
    }
    Result<std::vector<Calibration>> cameras = all.find("'lensmodel'") != all.npos
                                                   ? read_mrcal_model(*source)
                                               : is_yaml(all) ? read_yaml_calibration(*source)
                                                              : read_colmap_cameras(*source);
    if (!cameras) {
        return std::move(cameras.diagnostics);
    }
    return {
        std::make_shared<const CalibrationFile>(CalibrationFile{file.name, std::move(*cameras)}),
        std::move(cameras.diagnostics)};
}

}  // namespace balcony::data
