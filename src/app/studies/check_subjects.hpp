// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "balcony/studies.hpp"

namespace balcony::app {

/// A camera to check, with its size in the picture.
struct CheckSubject {
    camera::Camera camera;
    bool by_itself = false;
    std::vector<CameraCheck::Layer> layers{};  ///< The layers that show it.
    double width = 0.0;                        ///< In pixels, in the largest of these layers.
    double height = 0.0;
    /// What its layer shows; all objects if several layers show it.
    camera::ObjectFilter objects{};
};

/// Makes all pictures of a file, so that its mistakes are found, and returns the cameras in those
/// of FILE, or in the one of FILE:NAME. Cameras with the same parameters occur once.
[[nodiscard]] Result<std::vector<CheckSubject>> check_subjects(const std::string& argument,
                                                               const CheckRequest& request,
                                                               lang::Workspace& workspace);
/// The cameras in a picture, each once.
[[nodiscard]] std::vector<CheckSubject> check_subjects(const camera::Picture& picture,
                                                       const CheckRequest& request);

}  // namespace balcony::app
