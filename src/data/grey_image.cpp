// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "data/files.hpp"

namespace balcony::data {

namespace {

using camera::GreyImage;

Diagnostic no_image(const File& file, const std::string& reason) {
    // Some readers say the same again on the next line.
    return error(
        fmt::format("'{}' cannot be read as an image: {}", file.name,
                    reason.empty() ? "its format is unknown" : reason.substr(0, reason.find('\n'))),
        {}, "images are read from PNG, JPEG, TIFF, EXR and other usual formats");
}

/// How the channels of an image become grey.
struct Channels {
    explicit Channels(const OIIO::ImageSpec& spec)
        : count(static_cast<std::size_t>(std::clamp(spec.nchannels, 0, 4))),
          is_color(count >= 3),
          // What is stored multiplied by its alpha needs no more of it.
          alpha(spec.get_int_attribute("oiio:UnassociatedAlpha") != 0 ? spec.alpha_channel : -1) {}

    /// Written so that a NaN becomes 0.
    [[nodiscard]] float grey(const float* pixel) const {
        const float luma =
            is_color ? 0.2126F * pixel[0] + 0.7152F * pixel[1] + 0.0722F * pixel[2] : pixel[0];
        const float value =
            alpha >= 0 && static_cast<std::size_t>(alpha) < count ? luma * pixel[alpha] : luma;
        return value > 0.0F ? std::min(value, 1.0F) : 0.0F;
    }

    std::size_t count;
    bool is_color;
    int alpha;
};

Result<std::shared_ptr<const GreyImage>> read_pixels(OIIO::ImageInput& input, const File& file) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto width = static_cast<std::size_t>(std::max(spec.width, 0));
    const auto height = static_cast<std::size_t>(std::max(spec.height, 0));
    const Channels channels(spec);
    if (width == 0 || height == 0 || channels.count == 0 || spec.depth > 1) {
        return no_image(file, "it has no pixels in a plane");
    }
    if (width > max_pixels / height) {
        return error(
            fmt::format("'{}' has {} x {} pixels, more than 16 million", file.name, width, height),
            {}, "scale it down: a mask needs no more pixels than the picture");
    }
    std::vector<float> values(width * height * channels.count);
    if (!input.read_image(0, 0, 0, static_cast<int>(channels.count), OIIO::TypeDesc::FLOAT,
                          values.data())) {
        return no_image(file, input.geterror());
    }
    GreyImage image{width, height, {}};
    image.values.reserve(width * height);
    for (std::size_t i = 0; i < values.size(); i += channels.count) {
        image.values.push_back(channels.grey(&values[i]));
    }
    return std::make_shared<const GreyImage>(std::move(image));
}

}  // namespace

Result<std::shared_ptr<const GreyImage>> read_grey_image(const File& file) {
    std::unique_ptr<OIIO::Filesystem::IOMemReader> memory;  // Outlives the input that reads it.
    const std::string path = file.path.string();
    // For a file that is not on the disk its name's ending says the format.
    const std::string ending = file.path.extension().string();
    const auto input = OIIO::ImageInput::create(
        file.built_in ? ending.substr(std::min<std::size_t>(1, ending.size())) : path);
    if (!input) {
        (void)OIIO::geterror();  // Says no more, in words for those who build the library.
        return no_image(file, "");
    }
    if (file.built_in) {
        memory = std::make_unique<OIIO::Filesystem::IOMemReader>(file.built_in->data(),
                                                                 file.built_in->size());
        input->set_ioproxy(memory.get());
    }
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageSpec found;
    return input->open(path, found, config) ? read_pixels(*input, file)
                                            : no_image(file, input->geterror());
}

}  // namespace balcony::data
