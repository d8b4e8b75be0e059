// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What all readers check, and how they say what they find. Messages are reasons, as those of
// ImageFile::open().

#include <cstddef>
#include <exception>
#include <new>
#include <optional>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::images {

/// The size in the header of an image.
struct DeclaredSize {
    std::size_t width = 0;
    std::size_t height = 0;
};

/// Whether an image may have that size.
[[nodiscard]] std::optional<Diagnostic> check_size(DeclaredSize size);
/// The same of one whose header says so, or says nothing that can be understood. A byte holds at
/// most so many pixels; 0 is no limit.
[[nodiscard]] std::optional<Diagnostic> check_declared(std::optional<DeclaredSize> size,
                                                       std::size_t byte_count,
                                                       std::size_t max_pixels_per_byte);

/// That a part of the file is missing.
[[nodiscard]] Diagnostic truncated();
/// That the content is not what the format allows; the decoder's reason may be empty.
[[nodiscard]] Diagnostic corrupt(std::string_view reason = {});

/// The boundary to decoders that throw at unexpected content. Action returns a
/// std::optional<Diagnostic>.
template <class Action>
std::optional<Diagnostic> guarded(const Action& action) {
    try {
        return action();
    } catch (const std::bad_alloc&) {
        return error("it needs more memory than available");
    } catch (const std::exception&) {
        return corrupt();
    }
}

}  // namespace balcony::images
