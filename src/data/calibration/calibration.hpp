// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/data.hpp"

namespace balcony::data {

/// The readers of the formats.
[[nodiscard]] Result<std::vector<camera::Calibration>> read_yaml_calibration(
    const std::shared_ptr<const SourceText>& source);
[[nodiscard]] Result<std::vector<camera::Calibration>> read_colmap_cameras(
    const std::shared_ptr<const SourceText>& source);
[[nodiscard]] Result<std::vector<camera::Calibration>> read_mrcal_model(
    const std::shared_ptr<const SourceText>& source);

/// A number of an entry, and where it is.
struct EntryNumber {
    double value = 0.0;
    SourceSpan span{};
};

/// A finite number that is the whole of a text.
[[nodiscard]] std::optional<double> finite_number(std::string_view text);

/// What the numbers of an image and a lens must be, whatever file has them; without one of the
/// sizes, the centre is not judged.
struct ImageEntries {
    std::optional<EntryNumber> width{}, height{};
    EntryNumber fx{}, fy{}, cx{}, cy{};
};
void check_image(const ImageEntries& entries, Diagnostics& found);

using Matrix = std::array<std::array<double, 3>, 3>;

/// Rodrigues' formula for an axis whose length is the angle.
[[nodiscard]] Matrix rotation_of(const std::array<double, 3>& axis);
/// Whether the rows of a matrix are of length 1, at right angles to each other and right-handed.
[[nodiscard]] bool is_rotation(const Matrix& r);

/// The numbers of the image's parameters.
void add_image(const ImageEntries& entries, camera::Calibration& calibration);

}  // namespace balcony::data
