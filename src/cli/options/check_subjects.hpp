// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "balcony/inputs.hpp"
#include "balcony/request.hpp"
#include "cli/report/check_report.hpp"

namespace balcony::cli {

/// A camera to analyse, with its size in the picture.
struct CheckSubject {
    camera::Camera camera;
    bool by_itself = false;
    std::vector<CameraCheck::Layer> layers{};  ///< The layers that show it.
    double width = 0.0;                        ///< In pixels, in the largest of these layers.
    double height = 0.0;
};

struct SubjectRequest {
    std::vector<std::string> set{};
    std::string layer{};      ///< If set: only this layer of one picture, with its nested layers.
    app::PictureSize size{};  ///< The size of whole pictures.
    double time = 0.0;
};

/// Makes all pictures of a file, so that its mistakes are found, and returns the cameras in those
/// of FILE, or in the one of FILE:NAME. Cameras with the same parameters occur once.
[[nodiscard]] Result<std::vector<CheckSubject>> check_subjects(const std::string& argument,
                                                               const SubjectRequest& request,
                                                               lang::Workspace& workspace);

}  // namespace balcony::cli
