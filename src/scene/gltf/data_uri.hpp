// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// "data:" URIs: bytes in base 64 within the JSON of a glTF file.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace balcony::scene {

/// The bytes of a "data:" URI in base 64. Throws PartError if it is not one.
[[nodiscard]] std::vector<std::uint8_t> decode_data_uri(std::string_view uri);

/// The long data URIs of a JSON text. They are nearly all of it, and a parser of JSON would copy
/// them letter by letter.
class LiftedDataUris {
public:
    /// The text with a short name in the place of each. The text must outlive this.
    [[nodiscard]] std::string lift(std::string_view json);
    /// The URI with a name that lift() gave; any other one unchanged.
    [[nodiscard]] std::string_view original(std::string_view uri) const;

private:
    std::vector<std::string_view> uris_;
};

}  // namespace balcony::scene
