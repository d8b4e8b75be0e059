// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/installed_file.hpp"

namespace balcony {

/// A function of a module of Balcony's own, which is found as installed_file() says and stays
/// loaded to the end. `library` names what the module needs.
[[nodiscard]] Result<void*> function_of_module(const std::filesystem::path& folder,
                                               const std::filesystem::path& name,
                                               const char* function, std::string_view purpose,
                                               std::string_view library);

/// What a function of a module returns; otherwise as function_of_module().
template <class T>
[[nodiscard]] Result<const T*> loaded_from_module(const std::filesystem::path& folder,
                                                  const std::filesystem::path& name,
                                                  const char* function, std::string_view purpose,
                                                  std::string_view library) {
    const Result<void*> entry = function_of_module(folder, name, function, purpose, library);
    return entry ? Result<const T*>(reinterpret_cast<const T* (*)()>(*entry)())
                 : Result<const T*>(entry.diagnostics);
}

}  // namespace balcony
