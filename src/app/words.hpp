// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::app {

/// The whole text as a number without a sign, or nothing.
[[nodiscard]] std::optional<std::size_t> whole_number_of(std::string_view text);

/// Adds diagnostics; true if there are errors among them.
bool add(Diagnostics& diagnostics, const Diagnostics& more);

/// Does a work, and adds an error if the memory does not suffice for it.
template <class Work>
void within_memory(Diagnostics& diagnostics, const Work& work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        diagnostics.push_back(error(Kind::environment, "there is not enough memory",
                                    "make the picture smaller, or free some memory"));
    }
}

}  // namespace balcony::app
