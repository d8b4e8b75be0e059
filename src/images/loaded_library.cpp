// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/loaded_module.hpp"
#include "images/image_library.hpp"

namespace balcony::images {

const Result<const ImageLibrary*>& image_library() {
    static const auto library = loaded_from_module<ImageLibrary>(
        BALCONY_MODULE_FOLDER, BALCONY_MODULE, "balcony_image_library", "reads and writes images",
        "OpenImageIO");
    return library;
}

}  // namespace balcony::images
