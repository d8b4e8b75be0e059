// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <dlfcn.h>
#include <fmt/format.h>

#include "images/image_library.hpp"

namespace balcony::images {

namespace {

namespace fs = std::filesystem;

Diagnostic incomplete(std::string_view reason, std::string remedy) {
    return error(Kind::environment, fmt::format("the installation is incomplete: {}", reason),
                 std::move(remedy));
}

/// The module is beside the executable where both were built, and in a folder of the prefix where
/// they are installed. A prefix may have moved, so its place follows from that of the executable.
Result<fs::path> module_file() {
    std::error_code unknown;
    const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    if (unknown) {
        return incomplete("the place of the executable is not known", "mount /proc");
    }
    const fs::path installed = (folder / BALCONY_MODULE_FOLDER / BALCONY_MODULE).lexically_normal();
    for (const fs::path& candidate : {folder / BALCONY_MODULE, installed}) {
        std::error_code ignored;
        if (fs::exists(candidate, ignored)) {
            return candidate;
        }
    }
    return incomplete(
        fmt::format("there is no '{}', which reads and writes images", installed.string()),
        "install Balcony again, and move or copy its folders together");
}

Result<const ImageLibrary*> load() {
    const Result<fs::path> file = module_file();
    if (!file) {
        return file.diagnostics;
    }
    // Never closed, since OpenImageIO has threads of its own.
    void* const module = dlopen(file->c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const entry = module != nullptr ? dlsym(module, "balcony_image_library") : nullptr;
    if (entry == nullptr) {
        const char* const reason = dlerror();
        return incomplete(reason != nullptr ? reason : file->string(),
                          "install the package of OpenImageIO, or build Balcony again for the "
                          "version that is installed");
    }
    return reinterpret_cast<const ImageLibrary* (*)()>(entry)();
}

}  // namespace

const Result<const ImageLibrary*>& image_library() {
    static const Result<const ImageLibrary*> library = load();
    return library;
}

}  // namespace balcony::images
