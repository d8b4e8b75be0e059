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
    Result<camera::Camera> made = lang::load_camera(name, "", overrides);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

}  // namespace balcony::analyse::test
