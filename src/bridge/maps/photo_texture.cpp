// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/maps/photo_texture.hpp"

#include <algorithm>
#include <cassert>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include "bridge/maps/photo.hpp"

namespace balcony::bridge {

namespace {

constexpr const char* photo_attribute = "balcony:photo";

/// The side of the square that a photo is put into.
std::size_t side_of_square(const Photo::Pixels& photo) {
    return std::max(photo.width, photo.height);
}

/// Gives the pixels of a photo to OpenImageIO, which makes tiles and smaller levels of them. Its
/// filter takes every image for a square, so the photo is at the top left of one, and its last
/// column and row are repeated beyond its borders.
class PhotoInput final : public OIIO::ImageInput {
public:
    const char* format_name() const override { return "balcony photo"; }

    bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
        const Photo::Pixels* photo = nullptr;
        if (!config.getattribute(photo_attribute, OIIO::TypePointer, &photo)) {
            return false;
        }
        photo_ = photo;
        const auto side = static_cast<int>(side_of_square(*photo));
        m_spec = OIIO::ImageSpec(side, side, 4, OIIO::TypeDesc::FLOAT);
        spec = m_spec;
        return true;
    }
    bool open(const std::string&, OIIO::ImageSpec&) override { return false; }
    bool close() override { return true; }

    bool read_native_scanline(int, int, int y, int, void* data) override {
        const std::size_t row = std::min(static_cast<std::size_t>(y), photo_->height - 1);
        const float* const from = photo_->values.data() + 4 * row * photo_->width;
        auto* to = std::copy_n(from, 4 * photo_->width, static_cast<float*>(data));
        for (std::size_t x = photo_->width; x < side_of_square(*photo_); ++x) {
            to = std::copy_n(from + 4 * (photo_->width - 1), 4, to);
        }
        return true;
    }

    static OIIO::ImageInput* create() { return new PhotoInput; }

private:
    const Photo::Pixels* photo_ = nullptr;
};

}  // namespace

struct PhotoTexture::State {
    struct Destroy {
        void operator()(OIIO::TextureSystem* destroyed) const {
            OIIO::TextureSystem::destroy(destroyed, true);
        }
    };
    std::unique_ptr<OIIO::TextureSystem, Destroy> system;
    OIIO::TextureSystem::TextureHandle* handle = nullptr;
    OIIO::TextureOpt options;
    V2d scale{1.0};  ///< From the photo to the square.
};

PhotoTexture::PhotoTexture(const Photo& photo, bool closes) : state_(std::make_unique<State>()) {
    constexpr bool shared = false;
    state_->system.reset(OIIO::TextureSystem::create(shared));
    OIIO::TextureSystem& system = *state_->system;
    system.attribute("automip", 1);
    system.attribute("autotile", 64);
    // The tiles of the photo and of its smaller levels.
    const double bytes = static_cast<double>(photo.pixels().values.size() * sizeof(float));
    system.attribute("max_memory_MB", static_cast<float>(std::max(64.0, 1.5 * bytes / 1e6)));
    const OIIO::ustring name("photo");
    OIIO::ImageSpec config;
    const Photo::Pixels* pixels = &photo.pixels();
    config.attribute(photo_attribute, OIIO::TypePointer, &pixels);
    [[maybe_unused]] const bool added =
        system.imagecache()->add_file(name, PhotoInput::create, &config);
    assert(added);
    state_->handle = system.get_texture_handle(name);
    const auto side = static_cast<double>(side_of_square(*pixels));
    state_->scale =
        V2d(static_cast<double>(pixels->width), static_cast<double>(pixels->height)) / side;
    state_->options.swrap = closes ? OIIO::TextureOpt::WrapPeriodic : OIIO::TextureOpt::WrapClamp;
    state_->options.twrap = OIIO::TextureOpt::WrapClamp;
    // Passes through the pixels, so that a photo at its own size stays the same.
    state_->options.interpmode = OIIO::TextureOpt::InterpBilinear;
}

PhotoTexture::~PhotoTexture() = default;

std::array<float, 4> PhotoTexture::operator()(const SourcePlace& place) const {
    OIIO::TextureOpt options = state_->options;
    std::array<float, 4> color{};
    // OpenImageIO counts t from the top.
    const Imath::V2f at(V2d(place.st.x, 1.0 - place.st.y) * state_->scale);
    const Imath::V2f by_x(V2d(place.st_by_x.x, -place.st_by_x.y) * state_->scale);
    const Imath::V2f by_y(V2d(place.st_by_y.x, -place.st_by_y.y) * state_->scale);
    state_->system->texture(state_->handle, nullptr, options, at.x, at.y, by_x.x, by_x.y, by_y.x,
                            by_y.y, 4, color.data());
    return color;
}

}  // namespace balcony::bridge
