// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The objects of a scene that a name in another file means.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"

namespace balcony::scene {

/// The objects, by index, that have a name. If none has it, those that match it as a pattern, in
/// which `*` stands for any characters, also none, and `?` for one byte.
[[nodiscard]] std::vector<std::uint32_t> objects_named(const Scene& scene, std::string_view name);

/// The error of a name that no object has: the message, where the name is written, and the nearest
/// name, or how to list them.
[[nodiscard]] Diagnostic no_object(const Scene& scene, std::string message, std::string_view name,
                                   SourceSpan written);

}  // namespace balcony::scene
