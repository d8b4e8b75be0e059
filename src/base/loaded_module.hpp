// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/installed_file.hpp"

namespace balcony {

/// A function of a module of Balcony's own, which is found as installed_file() says and stays
/// loaded to the end. `remedy` is for a module whose libraries are missing.
[[nodiscard]] Result<void*> function_of_module(const std::filesystem::path& folder,
                                               const std::filesystem::path& name,
                                               const char* function, std::string_view purpose,
                                               std::string remedy);

}  // namespace balcony
