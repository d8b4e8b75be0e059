// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "balcony/lang.hpp"
#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// A camera that was made with some parameters open.
struct OpenAttempt {
    camera::Camera camera;
    std::vector<OpenParameter> numbers;  ///< Its parameters that are constant numbers.
    std::vector<std::string> others;
};

/// Makes a camera with the parameters of some names open.
using MakeOpen = std::function<Result<OpenAttempt>(const std::vector<std::string>& open)>;

/// The camera with as many of the requested parameters open as can be; all without a request.
[[nodiscard]] Result<OpenCamera> open_camera(
    const MakeOpen& make, const std::optional<std::vector<std::string>>& requested);

/// The parameters of a definition, sorted by what they are.
[[nodiscard]] OpenAttempt open_attempt(camera::Camera camera, const LocatedDefinition& place,
                                       const std::vector<Override>& overrides,
                                       const std::vector<Value>& values);

}  // namespace balcony::lang
