// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Who may talk to the server: pages that it has sent itself, with its token.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::studio {

/// 128 random bits as 32 hexadecimal digits.
[[nodiscard]] std::string random_token();

/// The token in a file, which is made, for its owner alone, if it is not there.
[[nodiscard]] Result<std::string> token_of(const std::filesystem::path& file);

/// Whether two texts are equal. How long that takes does not depend on where they differ.
[[nodiscard]] bool is_same_secret(std::string_view one, std::string_view other);

/// The value of a name in the query of an address: b of ?a=b. Empty if there is none.
[[nodiscard]] std::string_view query_value(std::string_view target, std::string_view name);

/// The names under which a server on this machine is reached.
class OwnNames {
public:
    explicit OwnNames(std::uint16_t port);

    /// The header Host: another one comes from a name that someone else has given this machine.
    [[nodiscard]] bool has_host(std::string_view host) const;
    /// The header Origin: another one comes from the page of another server.
    [[nodiscard]] bool has_origin(std::string_view origin) const;

private:
    std::string port_;
};

}  // namespace balcony::studio
