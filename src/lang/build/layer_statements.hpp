// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/picture.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// Reads the statements in a layer's block. Returns false after an error, which is reported.
[[nodiscard]] bool read_layer(const Module& module, const Statement& layer, Scope& names,
                              Session& session, camera::Layer& made);

}  // namespace balcony::lang
