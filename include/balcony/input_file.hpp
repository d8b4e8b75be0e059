// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"

namespace balcony {

/// Why a path cannot be read as a file: nothing is there, a link leads nowhere, or it is a folder,
/// a pipe, a device or an address of the web. Opening a pipe waits for a writer, perhaps forever,
/// and a device may have no end. Nothing if it is a regular file. `name` is what messages call it,
/// in quotes.
[[nodiscard]] std::optional<Diagnostic> not_a_file(const std::filesystem::path& file,
                                                   std::string_view name);

/// Begins a text of a file: removes the byte order mark of UTF-8. A text in UTF-16 is an error, for
/// which `name` is what messages call the file, in quotes.
[[nodiscard]] std::optional<Diagnostic> begin_text(std::string_view& text, std::string_view name);

/// ".glb": the extension of a file in small letters.
[[nodiscard]] std::string extension_of(const std::filesystem::path& file);

/// The sorted names in a folder, which is the current one if its name is empty; none if it cannot
/// be read.
[[nodiscard]] std::vector<std::string> names_in(const std::filesystem::path& folder);

}  // namespace balcony
