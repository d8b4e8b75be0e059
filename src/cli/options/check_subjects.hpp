// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/options/camera_argument.hpp"
#include "cli/options/render_options.hpp"
#include "cli/report/check_report.hpp"

namespace balcony::cli {

/// A camera that is to be looked at, in the size in which it is seen.
struct CheckSubject {
    camera::Camera camera;
    bool by_itself = false;
    std::vector<CameraCheck::Layer> layers{};  ///< That show it.
    double width = 0.0;                        ///< In pixels, where it is seen largest.
    double height = 0.0;
};

struct SubjectRequest {
    std::vector<std::string> set;
    std::string layer{};  ///< If said: of one picture this layer, or those of the picture in it.
    PictureSize size;     ///< Of whole pictures.
    double time = 0.0;
};

/// The cameras of FILE, or that or those of FILE:NAME, each once for the same parameters.
[[nodiscard]] Result<std::vector<CheckSubject>> check_subjects(const std::string& argument,
                                                               const SubjectRequest& request);

}  // namespace balcony::cli
