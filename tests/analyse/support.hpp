// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "balcony/diagnose.hpp"
#include "balcony/lang.hpp"

namespace balcony::analyse::test {

/// The last camera of a text in the camera language; the text must be good.
camera::Camera camera_of(const std::string& text);

/// A built-in camera.
camera::Camera standard(const std::string& name, const std::vector<lang::Override>& overrides = {});

/// On a picture of a size in pixels, measured at a distance if one is given.
CameraReport report_on(const camera::Camera& camera, double width, double height,
                       std::optional<double> distance = {});

std::vector<Finding> findings(const CameraReport& report, FindingKind kind);

/// The messages of all findings, a line each.
std::string words(const CameraReport& report);

}  // namespace balcony::analyse::test
