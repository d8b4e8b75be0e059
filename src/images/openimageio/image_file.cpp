// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "images/image_checks.hpp"
#include "images/openimageio/image_format.hpp"
#include "images/openimageio/library.hpp"
#include "images/stored_image.hpp"

namespace balcony::images {

namespace fs = std::filesystem;

using OIIO::Filesystem::IOProxy;

namespace {

Diagnostic unknown_format() {
    return error("its format is not supported", {},
                 "the supported formats are PNG, JPEG, WebP, TIFF, OpenEXR, HDR, TGA and BMP");
}

// Some readers repeat themselves on the next line, or have nothing to report.
template <class Source>
Diagnostic reported_by(const Source& source) {
    const std::string reason = source.geterror();
    return reason.empty() ? corrupt() : error(reason.substr(0, reason.find('\n')));
}

// Checks the header before the reader allocates memory for it.
std::optional<Diagnostic> check_header(const ImageFormat& format, IOProxy& bytes) {
    if (format.declared_size != nullptr) {
        if (auto failure = check_declared(format.declared_size(bytes), bytes.size(),
                                          format.max_pixels_per_byte)) {
            return failure;
        }
    }
    return format.is_whole == nullptr || format.is_whole(bytes) ? std::nullopt
                                                                : std::optional(truncated());
}

// Checks the header as parsed by the reader.
std::optional<Diagnostic> check_spec(const OIIO::ImageSpec& spec) {
    if (spec.depth > 1) {
        return error("it is a volume");
    }
    if (spec.deep) {
        return error("its pixels contain several samples each");
    }
    const auto size = [](int value) { return static_cast<std::size_t>(std::max(value, 0)); };
    if (auto failure = check_size({size(spec.width), size(spec.height)})) {
        return failure;
    }
    if (spec.nchannels <= 0) {
        return error("it has no channels");
    }
    if (size(spec.nchannels) > max_image_values / (size(spec.width) * size(spec.height))) {
        return error(fmt::format("it has {} channels, too many for {} x {} pixels", spec.nchannels,
                                 spec.width, spec.height),
                     {}, "keep only its colour and alpha channels");
    }
    const std::size_t columns = std::max(size(spec.width), size(spec.tile_width));
    if (spec.tile_width < 0 || spec.tile_height < 0 ||
        size(spec.tile_height) > max_tile_row_pixels / columns) {
        return error(fmt::format("its tiles of {} x {} pixels are too large", spec.tile_width,
                                 spec.tile_height),
                     {}, "export it with tiles of 64 x 64 pixels, or without tiles");
    }
    return std::nullopt;
}

class OpenImageFile final : public StoredImage {
public:
    [[nodiscard]] static Result<std::unique_ptr<ImageFile>> open(std::unique_ptr<IOProxy> bytes,
                                                                 const fs::path& name,
                                                                 ImageChannels channels);

    bool is_float() const override { return spec_.format.is_floating_point(); }
    bool has_bytes() const override { return spec_.format == OIIO::TypeDesc::UINT8; }
    std::vector<std::string> channel_names() const override;
    bool is_whole_picture() const override;
    std::optional<std::size_t> unassociated_alpha() const override;

protected:
    std::optional<Diagnostic> read_stored(std::size_t begin, std::size_t end,
                                          const Values& values) override {
        return std::visit(
            [&](auto rows) { return read(static_cast<int>(begin), static_cast<int>(end), rows); },
            values);
    }

private:
    [[nodiscard]] int channel_count() const { return static_cast<int>(stored_.channels); }

    [[nodiscard]] std::optional<Diagnostic> open_input() {
        next_row_ = 0;
        input_ = OIIO::ImageInput::create(format_->reader);
        if (!input_) {
            (void)OIIO::geterror();  // Clears a message that is of no use to users.
            return unknown_format();
        }
        bytes_->seek(0);
        input_->set_ioproxy(bytes_.get());
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        return input_->open("image", spec_, config) ? std::nullopt
                                                    : std::optional(reported_by(*input_));
    }

    // Reads the rows of tiles that contain the rows [begin, end), and copies the latter.
    template <class Value>
    [[nodiscard]] bool read_tiles(int begin, int end, std::span<Value> values) const {
        const int top = begin - begin % spec_.tile_height;
        const int tile_rows = (end - top + spec_.tile_height - 1) / spec_.tile_height;
        const int bottom = std::min(top + tile_rows * spec_.tile_height, spec_.height);
        const auto row = stored_.width * stored_.channels;
        std::vector<Value> tiles(row * static_cast<std::size_t>(bottom - top));
        if (!input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, spec_.y + top,
                                spec_.y + bottom, spec_.z, spec_.z + 1, 0, channel_count(),
                                OIIO::BaseTypeFromC<Value>::value, tiles.data())) {
            return false;
        }
        std::copy_n(tiles.begin() + static_cast<std::ptrdiff_t>(row) * (begin - top),
                    row * static_cast<std::size_t>(end - begin), values.begin());
        return true;
    }

    template <class Value>
    [[nodiscard]] bool read_scanlines(int begin, int end, std::span<Value> values) const {
        return input_->read_scanlines(0, 0, spec_.y + begin, spec_.y + end, spec_.z, 0,
                                      channel_count(), OIIO::BaseTypeFromC<Value>::value,
                                      values.data());
    }

    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read(int begin, int end, std::span<Value> values) {
        const bool tiled = spec_.tile_width > 0;
        // Readers that rewind by themselves open a file on disk.
        if (begin < next_row_ && !tiled) {
            if (auto failure = open_input()) {
                return failure;
            }
        }
        next_row_ = end;
        const bool done =
            tiled ? read_tiles(begin, end, values) : read_scanlines(begin, end, values);
        return done ? std::nullopt : std::optional(reported_by(*input_));
    }

    std::unique_ptr<IOProxy> bytes_;  // Outlives the input that reads it.
    const ImageFormat* format_ = nullptr;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    int next_row_ = 0;  // After the last row that was read.
};

Result<std::unique_ptr<ImageFile>> OpenImageFile::open(std::unique_ptr<IOProxy> bytes,
                                                       const fs::path& name,
                                                       ImageChannels channels) {
    auto opened = std::make_unique<OpenImageFile>();
    opened->bytes_ = std::move(bytes);
    opened->format_ = image_format(*opened->bytes_, name);
    if (opened->format_ == nullptr) {
        return unknown_format();
    }
    auto failure = guarded([&] {
        auto found = check_header(*opened->format_, *opened->bytes_);
        found = found ? found : opened->open_input();
        return found ? found : check_spec(opened->spec_);
    });
    if (failure) {
        return *std::move(failure);
    }
    const OIIO::ImageSpec& spec = opened->spec_;
    const int count = channels == ImageChannels::all ? spec.nchannels : std::min(spec.nchannels, 4);
    opened->stored_ = {static_cast<std::size_t>(spec.width), static_cast<std::size_t>(spec.height),
                       static_cast<std::size_t>(count), spec.get_int_attribute("Orientation", 1)};
    return std::unique_ptr<ImageFile>(std::move(opened));
}

std::vector<std::string> OpenImageFile::channel_names() const {
    const std::vector<std::string>& all = spec_.channelnames;
    return {all.begin(), all.begin() + std::min<std::ptrdiff_t>(std::ssize(all), channel_count())};
}

bool OpenImageFile::is_whole_picture() const {
    return spec_.x == spec_.full_x && spec_.y == spec_.full_y && spec_.width == spec_.full_width &&
           spec_.height == spec_.full_height;
}

std::optional<std::size_t> OpenImageFile::unassociated_alpha() const {
    const bool apart = spec_.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    return apart && spec_.alpha_channel >= 0 && spec_.alpha_channel < channel_count()
               ? std::optional(static_cast<std::size_t>(spec_.alpha_channel))
               : std::nullopt;
}

}  // namespace

Result<std::unique_ptr<ImageFile>> OpenImageIo::open(const fs::path& file,
                                                     ImageChannels channels) const {
    if (const auto fault = not_a_file(file, fmt::format("'{}'", file.string()))) {
        return *fault;
    }
    auto bytes = std::make_unique<OIIO::Filesystem::IOFile>(file.string(), IOProxy::Read);
    if (!bytes->opened()) {
        return error("it cannot be opened", {}, "check its read permission");
    }
    return OpenImageFile::open(std::move(bytes), file, channels);
}

Result<std::unique_ptr<ImageFile>> OpenImageIo::open(const fs::path& name,
                                                     std::span<const std::uint8_t> bytes,
                                                     ImageChannels channels) const {
    return OpenImageFile::open(
        std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size()), name,
        channels);
}

}  // namespace balcony::images
