// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "lang/service/hand_number.hpp"

namespace balcony::lang {

/// A handle with what moves its numbers.
struct KnownHandle {
    Handle handle;
    std::vector<HandNumber> numbers;
};

/// The handles of a camera or a picture that is visible in a text, with its base; none after
/// errors.
[[nodiscard]] std::vector<KnownHandle> known_handles(const KnownText& text,
                                                     const LocatedDefinition& written);

}  // namespace balcony::lang
