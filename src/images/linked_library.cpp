// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "images/openimageio/library.hpp"

namespace balcony::images {

const Result<const ImageLibrary*>& image_library() {
    static const OpenImageIo linked;
    static const Result<const ImageLibrary*> library(&linked);
    return library;
}

}  // namespace balcony::images
