// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/loaded_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

namespace balcony {

Result<void*> function_of_module(const std::filesystem::path& folder,
                                 const std::filesystem::path& name, const char* function,
                                 std::string_view purpose, std::string_view library) {
    const Result<std::filesystem::path> file = installed_file(folder, name, purpose);
    if (!file) {
        return file.diagnostics;
    }
    // Never closed: OpenImageIO, for one, has threads of its own.
    void* const module = dlopen(file->c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const found = module != nullptr ? dlsym(module, function) : nullptr;
    if (found == nullptr) {
        const char* const reason = dlerror();
        return incomplete_installation(
            reason != nullptr ? reason : file->string(),
            fmt::format("install the package of {}, or build Balcony again for the version that "
                        "is installed",
                        library));
    }
    return found;
}

}  // namespace balcony
