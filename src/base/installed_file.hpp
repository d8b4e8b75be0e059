// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony {

/// The error of an installation that lacks something.
[[nodiscard]] Diagnostic incomplete_installation(std::string_view reason, std::string remedy);

/// A file that belongs to the running program: beside the executable, or the module of another
/// program, where both were built, and in `folder` where they are installed. The folder is relative
/// to that of the executable, since an installation may have moved as a whole. `purpose` says what
/// the file does, as "reads images".
[[nodiscard]] Result<std::filesystem::path> installed_file(const std::filesystem::path& folder,
                                                           const std::filesystem::path& name,
                                                           std::string_view purpose);

}  // namespace balcony
