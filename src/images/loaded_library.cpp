// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>

#include <dlfcn.h>

#include "base/installed_file.hpp"
#include "images/image_library.hpp"

namespace balcony::images {

namespace {

Result<const ImageLibrary*> load() {
    const Result<std::filesystem::path> file =
        installed_file(BALCONY_MODULE_FOLDER, BALCONY_MODULE, "reads and writes images");
    if (!file) {
        return file.diagnostics;
    }
    // Never closed, since OpenImageIO has threads of its own.
    void* const module = dlopen(file->c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const entry = module != nullptr ? dlsym(module, "balcony_image_library") : nullptr;
    if (entry == nullptr) {
        const char* const reason = dlerror();
        return incomplete_installation(
            reason != nullptr ? reason : file->string(),
            "install the package of OpenImageIO, or build Balcony again for the version that is "
            "installed");
    }
    return reinterpret_cast<const ImageLibrary* (*)()>(entry)();
}

}  // namespace

const Result<const ImageLibrary*>& image_library() {
    static const Result<const ImageLibrary*> library = load();
    return library;
}

}  // namespace balcony::images
