// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the entries of a YAML file are in its text.

#include <cstddef>
#include <memory>

#include <yaml-cpp/yaml.h>

#include "balcony/base.hpp"

namespace balcony::data {

[[nodiscard]] SourceSpan place_of(const std::shared_ptr<const SourceText>& source,
                                  const YAML::Mark& mark, std::size_t length);
/// The whole of a scalar, or the beginning of another node.
[[nodiscard]] SourceSpan place_of(const std::shared_ptr<const SourceText>& source,
                                  const YAML::Node& node);

}  // namespace balcony::data
