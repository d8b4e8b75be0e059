// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Calls of stages as texts to begin with.

#include <string>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"
#include "balcony/language_service.hpp"

namespace balcony::lang {

struct StageCall {
    std::string text;
    std::vector<Completion::Blank> blanks;
};

/// A whole call: the parameters with defaults have these, and those that must be given what the
/// row's example gives them, or else the simplest value that they take.
[[nodiscard]] StageCall whole_call(const camera::StageEntry& row,
                                   const camera::Catalogue& catalogue);

/// A parameter as an argument with its default, or the simplest value: "radius = 1".
[[nodiscard]] std::string argument_of(const camera::StageParameter& parameter,
                                      const camera::Catalogue& catalogue);

}  // namespace balcony::lang
