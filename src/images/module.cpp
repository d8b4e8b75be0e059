// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The module that loaded_library.cpp loads: one function.

#include "images/openimageio/library.hpp"

extern "C" const balcony::images::ImageLibrary* balcony_image_library() {
    static const balcony::images::OpenImageIo library;
    return &library;
}
