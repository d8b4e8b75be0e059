// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/text_export.hpp"

#include <fmt/format.h>

namespace balcony::bridge {

TextExport::TextExport(const ExportSource& source, CameraFormulas formulas,
                       const std::set<std::string_view>& reserved, std::string_view reserved_prefix,
                       bool named_as_camera)
    : source_(source),
      formulas_(std::move(formulas)),
      names_(reserved, reserved_prefix),
      name_(named_as_camera ? names_.unique(source.camera.name())
                            : Names({}, reserved_prefix).unique(source.camera.name())),
      parameters_(source.parameters, names_) {}

std::string TextExport::input_name(std::string_view input) const {
    const auto parameter = parameters_.of_input(input);
    return parameter ? parameters_[*parameter] : std::string(input);
}

Listing TextExport::listing(const Dialect& dialect, const InputText& input_text) {
    return listing_of(formulas_, dialect, names_, name_ + "_", input_text);
}

Listing TextExport::listing(const Dialect& dialect) {
    return listing(dialect, [this](std::string_view input) { return input_name(input); });
}

std::string TextExport::comment(const std::vector<std::string>& meaning) const {
    std::vector<std::string> lines = opening_lines(source_);
    lines.insert(
        lines.end(),
        {"", fmt::format("{}_ray() gives the ray of a point (x, y) of a picture of width x "
                         "height pixels at time t:",
                         name_)});
    lines.insert(lines.end(), meaning.begin(), meaning.end());
    lines.push_back(world(formulas_.axes));
    if (formulas_.lens) {
        lines.insert(lines.end(), {"The ray passes a point of the lens: lens_x and lens_y are from "
                                   "-1 to 1, (0, 0) is the centre,",
                                   "and even steps of them spread evenly over the lens."});
    }
    return commented(lines);
}

}  // namespace balcony::bridge
