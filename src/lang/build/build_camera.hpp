// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "balcony/picture.hpp"
#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// Makes a camera from its syntax and reports what is wrong with it; nothing if there is an error.
/// What is not used is warned of if asked for.
[[nodiscard]] std::optional<camera::Camera> build_camera(const LocatedDefinition& place,
                                                         const GivenParameters& given,
                                                         Session& session, bool warn_of_unused);

/// The same of a picture; of a camera the picture that shows it alone.
[[nodiscard]] std::optional<camera::Picture> build_picture(const LocatedDefinition& place,
                                                           const GivenParameters& given,
                                                           Session& session);

}  // namespace balcony::lang
