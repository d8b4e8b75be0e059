// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "balcony/lang.hpp"

namespace balcony::analyse::test {

/// The last camera of a text in the camera language; the text must be good.
camera::Camera camera_of(const std::string& text);

/// A camera that comes along.
camera::Camera standard(const std::string& name, const std::vector<lang::Override>& overrides = {});

}  // namespace balcony::analyse::test
