// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The parts of the print gallery.

#include "common/scene_builder.hpp"

namespace balcony::plates::print_gallery {

/// A town on a hillside, the sea and boats, beyond the arcade.
void add_harbour(SceneBuilder& builder);

/// A man in a bowler hat and an overcoat, seen from behind.
void add_visitor(SceneBuilder& builder, const M44d& placed);

}  // namespace balcony::plates::print_gallery
