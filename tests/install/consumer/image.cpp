// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A program of somebody else: encodes an image and reads it. It is linked to OpenImageIO, while the
// command loads it.

#include <cstdint>
#include <cstdio>
#include <vector>

#include "balcony/images.hpp"

int main() {
    namespace images = balcony::images;
    const std::vector<std::uint8_t> samples{10, 20, 30, 40, 50, 60};
    const auto bytes = images::encode({2, 1, 3, std::span(samples)}, "png");
    if (!bytes) {
        std::fputs(balcony::to_text(bytes.diagnostics).c_str(), stdout);
        return 1;
    }
    const auto image = images::ImageFile::open("image.png", *bytes);
    std::vector<std::uint8_t> read(samples.size());
    if (!image || (*image)->read_rows(0, 1, read) || read != samples) {
        std::puts("the image is read otherwise than it is written");
        return 1;
    }
    return 0;
}
