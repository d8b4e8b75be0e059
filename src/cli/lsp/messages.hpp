// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Messages of the Language Server Protocol on streams: a header with the length, an empty line, and
// a JSON document.

#include <cstdint>
#include <istream>
#include <mutex>
#include <string>
#include <variant>

#include <nlohmann/json_fwd.hpp>

#include "lsp/rpc.hpp"

namespace balcony::cli {

/// What a stream has instead of a message that can be used.
enum class NoMessage : std::uint8_t {
    end,         ///< The stream has ended.
    bad_header,  ///< Where the next message begins is not known.
    too_long,    ///< It was skipped.
};

/// Reads the next message: its JSON text, of at most lsp::longest_message bytes.
[[nodiscard]] std::variant<std::string, NoMessage> read_message(std::istream& stream);

/// The answer to a message that was not read.
[[nodiscard]] nlohmann::json refusal_of(NoMessage why);

/// Writes messages to standard output, from any thread.
class MessageWriter {
public:
    void write(const nlohmann::json& message);

private:
    std::mutex mutex_;
};

}  // namespace balcony::cli
