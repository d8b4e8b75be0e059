// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "support.hpp"

#include <gtest/gtest.h>

namespace balcony::analyse::test {

camera::Camera camera_of(const std::string& text) {
    Result<camera::Camera> made =
        lang::make_camera(std::make_shared<const SourceText>("test.cam", text), "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

camera::Camera standard(const std::string& name, const std::vector<lang::Override>& overrides) {
    Result<camera::Camera> made = lang::make_camera(name, "", overrides);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

CameraReport report_on(const camera::Camera& camera, double width, double height,
                       std::optional<double> distance) {
    DiagnoseSettings settings;
    settings.width = width;
    settings.height = height;
    settings.distance = distance;
    return *diagnose(camera, settings);
}

std::vector<Finding> findings(const CameraReport& report, FindingKind kind) {
    std::vector<Finding> found;
    for (const Finding& finding : report.findings) {
        if (finding.kind == kind) {
            found.push_back(finding);
        }
    }
    return found;
}

std::string words(const CameraReport& report) {
    std::string text;
    for (const Finding& finding : report.findings) {
        text += finding.message + "\n";
    }
    return text;
}

}  // namespace balcony::analyse::test
