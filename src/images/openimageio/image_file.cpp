// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "images/openimageio/image_format.hpp"
#include "images/openimageio/library.hpp"

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
    return error(reason.empty() ? "its content is corrupt" : reason.substr(0, reason.find('\n')));
}

std::optional<Diagnostic> check_size(std::size_t width, std::size_t height) {
    if (width == 0 || height == 0) {
        return error("it has no pixels", {}, "copy or export it again");
    }
    if (width > max_image_pixels / height) {
        return error(fmt::format("it has {} x {} pixels, more than {} million", width, height,
                                 max_image_pixels / 1'000'000),
                     {}, "scale it down");
    }
    return std::nullopt;
}

// Checks the header before the reader allocates memory for it.
std::optional<Diagnostic> check_header(const ImageFormat& format, IOProxy& bytes) {
    if (format.declared_size != nullptr) {
        const std::optional<DeclaredSize> size = format.declared_size(bytes);
        if (!size) {
            return error("its header is corrupt");
        }
        if (auto failure = check_size(size->width, size->height)) {
            return failure;
        }
        if (format.max_pixels_per_byte > 0 &&
            size->width * size->height / format.max_pixels_per_byte > bytes.size()) {
            return error(
                fmt::format("it declares {} x {} pixels, more than its {} bytes can contain",
                            size->width, size->height, bytes.size()),
                {}, "copy or export it again");
        }
    }
    if (format.is_whole != nullptr && !format.is_whole(bytes)) {
        return error("it is truncated or corrupt", {}, "copy or export it again");
    }
    return std::nullopt;
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
    if (auto failure = check_size(size(spec.width), size(spec.height))) {
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

// The boundary to readers that throw on unexpected input.
template <class Action>
std::optional<Diagnostic> guarded(const Action& action) {
    try {
        return action();
    } catch (const std::bad_alloc&) {
        return error("it needs more memory than available");
    } catch (const std::exception&) {
        return error("its content is corrupt");
    }
}

// ImageBufAlgo::reorient() of OpenImageIO 2.4 takes 5 and 7 for each other.
OIIO::ImageBuf turned_upright(const OIIO::ImageBuf& stored, int orientation) {
    namespace algorithms = OIIO::ImageBufAlgo;
    switch (orientation) {
        case 2: return algorithms::flop(stored);
        case 3: return algorithms::rotate180(stored);
        case 4: return algorithms::flip(stored);
        case 5: return algorithms::transpose(stored);
        case 6: return algorithms::rotate90(stored);
        case 7: return algorithms::transpose(algorithms::rotate180(stored));
        case 8: return algorithms::rotate270(stored);
        default: return stored;
    }
}

class OpenImageFile final : public ImageFile {
public:
    [[nodiscard]] static Result<std::unique_ptr<ImageFile>> open(std::unique_ptr<IOProxy> bytes,
                                                                 const fs::path& name,
                                                                 ImageChannels channels);

    std::size_t width() const override {
        return static_cast<std::size_t>(rows_are_columns() ? spec_.height : spec_.width);
    }
    std::size_t height() const override {
        return static_cast<std::size_t>(rows_are_columns() ? spec_.width : spec_.height);
    }
    std::size_t channels() const override { return static_cast<std::size_t>(channel_count()); }
    bool is_float() const override { return spec_.format.is_floating_point(); }
    bool has_bytes() const override { return spec_.format == OIIO::TypeDesc::UINT8; }
    std::vector<std::string> channel_names() const override;
    bool is_whole_picture() const override;
    std::optional<std::size_t> unassociated_alpha() const override;

    void turn_upright() override {
        const int stored = spec_.get_int_attribute("Orientation", 1);
        orientation_ = 1 <= stored && stored <= 8 ? stored : 1;
    }

    std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                        std::span<float> values) override {
        return guarded([&] { return read(begin, end, values); });
    }
    std::optional<Diagnostic> read_rows(std::size_t begin, std::size_t end,
                                        std::span<std::uint8_t> values) override {
        return guarded([&] { return read(begin, end, values); });
    }

private:
    [[nodiscard]] bool rows_are_columns() const { return orientation_ >= 5; }
    [[nodiscard]] int channel_count() const {
        return which_ == ImageChannels::all ? spec_.nchannels : std::min(spec_.nchannels, 4);
    }

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
        const auto row =
            static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(channel_count());
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
    [[nodiscard]] std::optional<Diagnostic> read(std::size_t first_row, std::size_t end_row,
                                                 std::span<Value> values) {
        if (first_row > end_row || end_row > height() ||
            values.size() != (end_row - first_row) * width() * channels()) {
            return error(Kind::internal, "rows that it does not have are asked for");
        }
        const int begin = static_cast<int>(first_row);
        const int end = static_cast<int>(end_row);
        return orientation_ == 1 ? read_stored(begin, end, values)
                                 : read_turned(begin, end, values);
    }

    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read_turned(int begin, int end,
                                                        std::span<Value> values) {
        if (!turned_.initialized()) {
            if (auto failure = has_bytes() ? turn<std::uint8_t>() : turn<float>()) {
                return failure;
            }
        }
        const OIIO::ROI rows(0, static_cast<int>(width()), begin, end, 0, 1, 0, channel_count());
        return turned_.get_pixels(rows, OIIO::BaseTypeFromC<Value>::value, values.data())
                   ? std::nullopt
                   : std::optional(reported_by(turned_));
    }

    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> turn() {
        const OIIO::ImageSpec spec(spec_.width, spec_.height, channel_count(),
                                   OIIO::BaseTypeFromC<Value>::value);
        std::vector<Value> stored(width() * height() * channels());
        if (auto failure = read_stored(0, spec_.height, std::span(stored))) {
            return failure;
        }
        turned_ = turned_upright(OIIO::ImageBuf(spec, stored.data()), orientation_);
        return turned_.has_error() ? std::optional(reported_by(turned_)) : std::nullopt;
    }

    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read_stored(int begin, int end,
                                                        std::span<Value> values) {
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
    ImageChannels which_ = ImageChannels::first_four;
    int orientation_ = 1;    // As EXIF and TIFF count it; 1 is as it is stored.
    OIIO::ImageBuf turned_;  // The whole image upright, once it is read and stored otherwise.
};

Result<std::unique_ptr<ImageFile>> OpenImageFile::open(std::unique_ptr<IOProxy> bytes,
                                                       const fs::path& name,
                                                       ImageChannels channels) {
    auto opened = std::make_unique<OpenImageFile>();
    opened->which_ = channels;
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
