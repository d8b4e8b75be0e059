// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cassert>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include "images/openimageio/library.hpp"

namespace balcony::images {

namespace {

using Imath::V2d;

constexpr const char* image_attribute = "balcony:image";

/// The side of the square that an image is put into.
std::size_t side_of_square(const LinearImage& image) { return std::max(image.width, image.height); }

/// Gives the pixels of an image to OpenImageIO, which makes tiles and smaller levels of them. Its
/// filter takes every image for a square, so the image is at the top left of one, and its last
/// column and row are repeated beyond its borders.
class PixelInput final : public OIIO::ImageInput {
public:
    const char* format_name() const override { return "balcony image"; }

    bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
        const LinearImage* image = nullptr;
        if (!config.getattribute(image_attribute, OIIO::TypePointer, &image)) {
            return false;
        }
        image_ = image;
        const auto side = static_cast<int>(side_of_square(*image));
        m_spec = OIIO::ImageSpec(side, side, 4, OIIO::TypeDesc::FLOAT);
        spec = m_spec;
        return true;
    }
    bool open(const std::string&, OIIO::ImageSpec&) override { return false; }
    bool close() override { return true; }

    bool read_native_scanline(int, int, int y, int, void* data) override {
        const std::size_t row = std::min(static_cast<std::size_t>(y), image_->height - 1);
        const float* const from = image_->values.data() + 4 * row * image_->width;
        auto* to = std::copy_n(from, 4 * image_->width, static_cast<float*>(data));
        for (std::size_t x = image_->width; x < side_of_square(*image_); ++x) {
            to = std::copy_n(from + 4 * (image_->width - 1), 4, to);
        }
        return true;
    }

    static OIIO::ImageInput* create() { return new PixelInput; }

private:
    const LinearImage* image_ = nullptr;
};

/// A texture system with a cache of its own. Before version 3, its owner destroys it.
std::shared_ptr<OIIO::TextureSystem> make_texture_system() {
    constexpr bool shared = false;
#if OIIO_VERSION_MAJOR < 3
    return {OIIO::TextureSystem::create(shared), [](OIIO::TextureSystem* destroyed) {
                constexpr bool with_its_cache = true;
                OIIO::TextureSystem::destroy(destroyed, with_its_cache);
            }};
#else
    return OIIO::TextureSystem::create(shared);
#endif
}

class TexturedImage final : public FilteredImage {
public:
    TexturedImage(const LinearImage& image, bool closes) : image_(image) {
        system_->attribute("automip", 1);
        system_->attribute("autotile", 64);
        // The tiles of the image and of its smaller levels.
        const double bytes = static_cast<double>(image.values.size() * sizeof(float));
        system_->attribute("max_memory_MB", static_cast<float>(std::max(64.0, 1.5 * bytes / 1e6)));
        const OIIO::ustring name("image");
        OIIO::ImageSpec config;
        const LinearImage* const pixels = &image_;
        config.attribute(image_attribute, OIIO::TypePointer, &pixels);
        [[maybe_unused]] const bool added =
            system_->imagecache()->add_file(name, PixelInput::create, &config);
        assert(added);
        handle_ = system_->get_texture_handle(name);
        const auto side = static_cast<double>(side_of_square(image));
        scale_ = V2d(static_cast<double>(image.width), static_cast<double>(image.height)) / side;
        options_.swrap = closes ? OIIO::TextureOpt::WrapPeriodic : OIIO::TextureOpt::WrapClamp;
        options_.twrap = OIIO::TextureOpt::WrapClamp;
        // Passes through the pixels, so that an image at its own size stays the same.
        options_.interpmode = OIIO::TextureOpt::InterpBilinear;
    }

    std::array<float, 4> mean(const V2d& st, const V2d& side,
                              const V2d& other_side) const override {
        OIIO::TextureOpt options = options_;
        std::array<float, 4> color{};
        // OpenImageIO counts t from the top.
        const Imath::V2f at(V2d(st.x, 1.0 - st.y) * scale_);
        const Imath::V2f by_x(V2d(side.x, -side.y) * scale_);
        const Imath::V2f by_y(V2d(other_side.x, -other_side.y) * scale_);
        system_->texture(handle_, nullptr, options, at.x, at.y, by_x.x, by_x.y, by_y.x, by_y.y, 4,
                         color.data());
        return color;
    }

private:
    LinearImage image_;
    std::shared_ptr<OIIO::TextureSystem> system_ = make_texture_system();
    OIIO::TextureSystem::TextureHandle* handle_ = nullptr;
    OIIO::TextureOpt options_;
    V2d scale_{1.0};  ///< From the image to the square.
};

}  // namespace

std::unique_ptr<FilteredImage> OpenImageIo::filter(const LinearImage& image, bool closes) const {
    return std::make_unique<TexturedImage>(image, closes);
}

}  // namespace balcony::images
