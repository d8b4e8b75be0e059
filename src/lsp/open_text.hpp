// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A text that a client has open, with positions as the protocol counts them: lines from 0, and in a
// line code units of UTF-16.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "balcony/base.hpp"
#include "balcony/language_service.hpp"

namespace balcony::lsp {

/// The file that an address names; empty if it is none.
[[nodiscard]] std::filesystem::path file_of(std::string_view uri);
[[nodiscard]] std::string uri_of(const std::filesystem::path& file);

/// The position of a byte offset, and the range between two.
[[nodiscard]] nlohmann::json position_in(const SourceText& text, std::size_t offset);
[[nodiscard]] nlohmann::json range_in(const SourceText& text, std::size_t begin, std::size_t end);

/// Questions about longer texts are not answered.
inline constexpr std::size_t longest_text = 1'000'000;  ///< In bytes.
inline constexpr std::string_view too_long = "a camera file is at most 1 MB";

class OpenText {
public:
    OpenText(std::string uri, std::string text, int version);

    [[nodiscard]] const std::string& uri() const { return uri_; }
    [[nodiscard]] int version() const { return version_; }
    [[nodiscard]] const std::shared_ptr<const SourceText>& source() const { return source_; }
    [[nodiscard]] std::filesystem::path folder() const { return file_of(uri_).parent_path(); }
    /// Read when it is asked for.
    [[nodiscard]] const lang::EditedText& known();

    /// The byte offset of a position; one that does not exist is the nearest before it.
    [[nodiscard]] std::size_t offset_of(const nlohmann::json& position) const;

    /// Makes the changes of a didChange.
    void change(const nlohmann::json& changes, int version);

    Diagnostics found{};  ///< What has last been told about it.

private:
    void set(std::string text);

    std::string uri_;
    int version_;
    std::shared_ptr<const SourceText> source_;
    std::optional<lang::EditedText> known_;
};

}  // namespace balcony::lsp
