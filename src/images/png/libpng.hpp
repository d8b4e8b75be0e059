// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// libpng leaves its functions with a jump when it fails. A caller calls setjmp() and has nothing
// with a destructor between that and its calls.

#include <array>
#include <cstring>

#include <png.h>

namespace balcony::images {

/// The reason of a failure, which libpng's error pointer points to.
struct PngFailure {
    std::array<char, 128> reason{};
};

/// libpng leaves by it: with a jump to where setjmp() was called.
[[noreturn]] inline void fail(png_structp png, png_const_charp why) {
    auto& reason = static_cast<PngFailure*>(png_get_error_ptr(png))->reason;
    std::strncpy(reason.data(), why, reason.size() - 1);
    png_longjmp(png, 1);
}

/// What libpng warns of.
inline void ignore(png_structp, png_const_charp) {}

/// libpng has limits of its own.
inline void allow_any_side(png_structp png) {
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
}

}  // namespace balcony::images
