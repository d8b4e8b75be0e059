// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "balcony/picture.hpp"
#include "lang/names/definition_scope.hpp"

namespace balcony::lang {

/// Makes a camera from its syntax and reports mistakes; nothing if there is an error.
/// Optionally warns about unused names, and stores the values of its parameters in their order.
[[nodiscard]] std::optional<camera::Camera> build_camera(const LocatedDefinition& place,
                                                         const GivenParameters& given,
                                                         Session& session, bool warn_of_unused,
                                                         std::vector<Value>* values = nullptr);

/// The same for a picture; a camera becomes a picture with one layer.
[[nodiscard]] std::optional<camera::Picture> build_picture(const LocatedDefinition& place,
                                                           const GivenParameters& given,
                                                           Session& session,
                                                           std::vector<Value>* values = nullptr);

}  // namespace balcony::lang
