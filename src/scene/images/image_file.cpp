// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/image_file.hpp"

#include <algorithm>
#include <cassert>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "scene/images/image_format.hpp"

namespace balcony::scene {

namespace fs = std::filesystem;

using OIIO::Filesystem::IOProxy;

namespace {

Diagnostic unknown_format() {
    return error("its format is not supported", {},
                 "the supported formats are PNG, JPEG, WebP, TIFF, OpenEXR, HDR, TGA and BMP");
}

// Some readers repeat themselves on the next line, or have nothing to report.
Diagnostic reported_by(OIIO::ImageInput& input) {
    const std::string reason = input.geterror();
    return error(reason.empty() ? "its content is corrupt" : reason.substr(0, reason.find('\n')));
}

std::optional<Diagnostic> check_size(std::size_t width, std::size_t height) {
    if (width == 0 || height == 0) {
        return error("it has no pixels");
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

}  // namespace

struct ImageFile::State {
    std::unique_ptr<IOProxy> bytes;  // Outlives the input that reads it.
    const ImageFormat* format = nullptr;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    int next_row = 0;  // After the last row that was read.
    ImageChannels which = ImageChannels::first_four;

    [[nodiscard]] static Result<ImageFile> open(std::unique_ptr<IOProxy> bytes,
                                                const fs::path& name, ImageChannels channels);

    [[nodiscard]] int channels() const {
        return which == ImageChannels::all ? spec.nchannels : std::min(spec.nchannels, 4);
    }

    [[nodiscard]] std::optional<Diagnostic> open_input() {
        next_row = 0;
        input = OIIO::ImageInput::create(format->reader);
        if (!input) {
            (void)OIIO::geterror();  // Clears a message that is of no use to users.
            return unknown_format();
        }
        bytes->seek(0);
        input->set_ioproxy(bytes.get());
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        return input->open("image", spec, config) ? std::nullopt
                                                  : std::optional(reported_by(*input));
    }

    // Reads the rows of tiles that contain the rows [begin, end), and copies the latter.
    template <class Value>
    [[nodiscard]] bool read_tiles(int begin, int end, std::span<Value> values) const {
        const int top = begin - begin % spec.tile_height;
        const int tile_rows = (end - top + spec.tile_height - 1) / spec.tile_height;
        const int bottom = std::min(top + tile_rows * spec.tile_height, spec.height);
        const auto row =
            static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels());
        std::vector<Value> tiles(row * static_cast<std::size_t>(bottom - top));
        if (!input->read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + top, spec.y + bottom,
                               spec.z, spec.z + 1, 0, channels(), OIIO::BaseTypeFromC<Value>::value,
                               tiles.data())) {
            return false;
        }
        std::copy_n(tiles.begin() + static_cast<std::ptrdiff_t>(row) * (begin - top),
                    row * static_cast<std::size_t>(end - begin), values.begin());
        return true;
    }

    template <class Value>
    [[nodiscard]] bool read_scanlines(int begin, int end, std::span<Value> values) const {
        return input->read_scanlines(0, 0, spec.y + begin, spec.y + end, spec.z, 0, channels(),
                                     OIIO::BaseTypeFromC<Value>::value, values.data());
    }

    template <class Value>
    [[nodiscard]] std::optional<Diagnostic> read(std::size_t first_row, std::size_t end_row,
                                                 std::span<Value> values) {
        assert(first_row <= end_row && end_row <= static_cast<std::size_t>(spec.height) &&
               values.size() == (end_row - first_row) * static_cast<std::size_t>(spec.width) *
                                    static_cast<std::size_t>(channels()));
        const int begin = static_cast<int>(first_row);
        const int end = static_cast<int>(end_row);
        const bool tiled = spec.tile_width > 0;
        // Readers that rewind by themselves open a file on disk.
        if (begin < next_row && !tiled) {
            if (auto failure = open_input()) {
                return failure;
            }
        }
        next_row = end;
        const bool done =
            tiled ? read_tiles(begin, end, values) : read_scanlines(begin, end, values);
        return done ? std::nullopt : std::optional(reported_by(*input));
    }
};

Result<ImageFile> ImageFile::State::open(std::unique_ptr<IOProxy> bytes, const fs::path& name,
                                         ImageChannels channels) {
    auto state = std::make_unique<State>();
    state->which = channels;
    state->bytes = std::move(bytes);
    state->format = image_format(*state->bytes, name);
    if (state->format == nullptr) {
        return unknown_format();
    }
    auto failure = guarded([&] {
        auto found = check_header(*state->format, *state->bytes);
        found = found ? found : state->open_input();
        return found ? found : check_spec(state->spec);
    });
    if (failure) {
        return *std::move(failure);
    }
    return ImageFile(std::move(state));
}

Result<ImageFile> ImageFile::open(const fs::path& file, ImageChannels channels) {
    std::error_code code;
    if (!fs::is_regular_file(file, code)) {
        return error("there is no such file");
    }
    auto bytes = std::make_unique<OIIO::Filesystem::IOFile>(file.string(), IOProxy::Read);
    if (!bytes->opened()) {
        return error("it cannot be opened", {}, "check its read permission");
    }
    return State::open(std::move(bytes), file, channels);
}

Result<ImageFile> ImageFile::open(const fs::path& name, std::span<const std::uint8_t> bytes,
                                  ImageChannels channels) {
    return State::open(std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size()),
                       name, channels);
}

ImageFile::ImageFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
ImageFile::ImageFile(ImageFile&&) noexcept = default;
ImageFile& ImageFile::operator=(ImageFile&&) noexcept = default;
ImageFile::~ImageFile() = default;

std::size_t ImageFile::width() const { return static_cast<std::size_t>(state_->spec.width); }

std::size_t ImageFile::height() const { return static_cast<std::size_t>(state_->spec.height); }

std::size_t ImageFile::channels() const { return static_cast<std::size_t>(state_->channels()); }

std::vector<std::string> ImageFile::channel_names() const {
    const std::vector<std::string>& all = state_->spec.channelnames;
    return {all.begin(),
            all.begin() + std::min<std::ptrdiff_t>(std::ssize(all), state_->channels())};
}

bool ImageFile::is_whole_picture() const {
    const OIIO::ImageSpec& spec = state_->spec;
    return spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
           spec.height == spec.full_height;
}

bool ImageFile::is_float() const { return state_->spec.format.is_floating_point(); }

std::optional<std::size_t> ImageFile::unassociated_alpha() const {
    const OIIO::ImageSpec& spec = state_->spec;
    const bool apart = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    return apart && spec.alpha_channel >= 0 && spec.alpha_channel < state_->channels()
               ? std::optional(static_cast<std::size_t>(spec.alpha_channel))
               : std::nullopt;
}

bool ImageFile::has_bytes() const { return state_->spec.format == OIIO::TypeDesc::UINT8; }

std::optional<Diagnostic> ImageFile::read_rows(std::size_t begin, std::size_t end,
                                               std::span<float> values) {
    return guarded([&] { return state_->read(begin, end, values); });
}

std::optional<Diagnostic> ImageFile::read_rows(std::size_t begin, std::size_t end,
                                               std::span<std::uint8_t> values) {
    return guarded([&] { return state_->read(begin, end, values); });
}

}  // namespace balcony::scene
