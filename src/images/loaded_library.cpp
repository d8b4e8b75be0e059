// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/loaded_module.hpp"
#include "images/image_library.hpp"

namespace balcony::images {

namespace {

Result<const ImageLibrary*> load() {
    const Result<void*> entry = function_of_module(
        BALCONY_MODULE_FOLDER, BALCONY_MODULE, "balcony_image_library", "reads and writes images",
        "install the package of OpenImageIO, or build Balcony again for the version that is "
        "installed");
    if (!entry) {
        return entry.diagnostics;
    }
    return reinterpret_cast<const ImageLibrary* (*)()>(*entry)();
}

}  // namespace

const Result<const ImageLibrary*>& image_library() {
    static const Result<const ImageLibrary*> library = load();
    return library;
}

}  // namespace balcony::images
