// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Maps of rays and of picture positions, from EXR files and other images and from arrays.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/images.hpp"
#include "data/files.hpp"
#include "data/npy_array.hpp"

namespace balcony::data {

namespace {

using camera::PixelMap;
using images::ImageFile;
using MapResult = Result<std::shared_ptr<const PixelMap>>;

/// What a map is made of.
struct MapForm {
    std::string_view what;  ///< "ray map"
    std::span<const std::string_view> channels;
    std::string_view
        validity;             ///< The channel that says where there is something, if there is one.
    std::string_view remedy;  ///< For a file without these channels.
    std::string_view thing;   ///< What a valid pixel has: "ray".
};

constexpr std::array<std::string_view, 6> ray_channels{"origin.X",    "origin.Y",    "origin.Z",
                                                       "direction.X", "direction.Y", "direction.Z"};
constexpr std::array<std::string_view, 2> position_channels{"R", "G"};

constexpr MapForm ray_form{"ray map", ray_channels, "valid.A",
                           "a ray map has the channels origin.X, origin.Y, origin.Z, direction.X, "
                           "direction.Y and direction.Z; `balcony rays` writes one",
                           "ray"};
constexpr MapForm position_form{"STMap", position_channels, "A",
                                "an STMap has its positions in the channels R and G", "position"};

/// The pixels of a map as they come from a file.
class MapBuilder {
public:
    MapBuilder(const MapForm& form, std::size_t width, std::size_t height)
        : form_(form), map_{width, height, {}, {}} {
        map_.channels.resize(form.channels.size());
        for (std::vector<double>& channel : map_.channels) {
            channel.reserve(width * height);
        }
        map_.valid.reserve(width * height);
    }

    void add(std::span<const double> values, bool valid) {
        const std::size_t at = map_.valid.size();
        // A ray without a direction is none.
        const bool there = valid && (values.size() < ray_channels.size() || values[3] != 0.0 ||
                                     values[4] != 0.0 || values[5] != 0.0);
        map_.valid.push_back(there ? 1 : 0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (there && !std::isfinite(values[i]) && !fault_) {
                fault_ = {at, i};
            }
            map_.channels[i].push_back(there ? values[i] : 0.0);
        }
    }

    [[nodiscard]] MapResult finish(const File& file) {
        if (fault_) {
            return error(
                fmt::format("'{}' has a number that is not finite in {} of the pixel in column {} "
                            "and row {} from the top left, where it says that there is a {}",
                            file.name, form_.channels[fault_->channel],
                            fault_->pixel % map_.width + 1, fault_->pixel / map_.width + 1,
                            form_.thing),
                {},
                form_.channels.size() == ray_channels.size()
                    ? "where there is no ray, make its direction or valid.A 0"
                    : "where there is no position, make alpha 0");
        }
        if (std::none_of(map_.valid.begin(), map_.valid.end(),
                         [](std::uint8_t valid) { return valid != 0; })) {
            return error(fmt::format("'{}' has no {} in any pixel", file.name, form_.thing), {},
                         "check that it is the right file");
        }
        return std::make_shared<const PixelMap>(std::move(map_));
    }

private:
    struct Fault {
        std::size_t pixel, channel;
    };

    const MapForm& form_;
    PixelMap map_;
    std::optional<Fault> fault_;
};

std::optional<Diagnostic> refuse_size(const MapForm& form, const File& file, std::size_t width,
                                      std::size_t height) {
    if (width <= max_pixels / height) {
        return std::nullopt;
    }
    return error(
        fmt::format("'{}' has {} x {} pixels, more than 16 million", file.name, width, height), {},
        fmt::format("scale the {} down: what is between its pixels is interpolated", form.what));
}

// --------------------------------------------------------------------------------------- images

Diagnostic no_map(const MapForm& form, const File& file, const Diagnostic& reason) {
    return error(reason.kind,
                 fmt::format("'{}' cannot be read as {} {}: {}", file.name,
                             form.what.starts_with('S') ? "an" : "a", form.what, reason.message),
                 reason.remedy);
}

MapResult read_image(const MapForm& form, const File& file, ImageFile& input) {
    if (auto failure = refuse_size(form, file, input.width(), input.height())) {
        return *std::move(failure);
    }
    if (!input.is_whole_picture()) {
        return error(fmt::format("'{}' has only a part of its picture", file.name), {},
                     "write the whole picture: data window and display window must be the same");
    }
    const std::vector<std::string> names = input.channel_names();
    const auto place_of = [&names](std::string_view name) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                        names.begin());
    };
    std::vector<std::size_t> places;
    for (const std::string_view name : form.channels) {
        places.push_back(place_of(name));
        if (places.back() == names.size()) {
            return error(fmt::format("'{}' has no channel {}, but {}", file.name, name,
                                     fmt::join(names, ", ")),
                         {}, std::string(form.remedy));
        }
    }
    const std::size_t validity = place_of(form.validity);
    MapBuilder builder(form, input.width(), input.height());
    constexpr std::size_t rows_at_once = 64;
    std::vector<float> values;
    std::vector<double> pixel(places.size());
    for (std::size_t row = 0; row < input.height(); row += rows_at_once) {
        const std::size_t end = std::min(row + rows_at_once, input.height());
        values.resize((end - row) * input.width() * names.size());
        if (const auto failure = input.read_rows(row, end, values)) {
            return no_map(form, file, *failure);
        }
        for (std::size_t i = 0; i < values.size(); i += names.size()) {
            std::transform(places.begin(), places.end(), pixel.begin(),
                           [&](std::size_t place) { return double{values[i + place]}; });
            builder.add(pixel, validity == names.size() || values[i + validity] > 0.5F);
        }
    }
    return builder.finish(file);
}

MapResult read_image(const MapForm& form, const File& file) {
    constexpr auto all = images::ImageChannels::all;
    const Result<std::unique_ptr<ImageFile>> input =
        file.bytes ? ImageFile::open(file.path, *file.bytes, all) : ImageFile::open(file.path, all);
    return input ? read_image(form, file, **input) : no_map(form, file, input.diagnostics.front());
}

// --------------------------------------------------------------------------------------- arrays

MapResult read_array(const MapForm& form, const File& file, std::string_view bytes) {
    const Result<NpyArray> array = NpyArray::read(bytes, file.name);
    if (!array) {
        return array.diagnostics;
    }
    const auto [height, width, columns] = array->shape();
    if (auto failure = refuse_size(form, file, width, height)) {
        return *std::move(failure);
    }
    const std::size_t wanted = form.channels.size();
    if (columns < wanted) {
        return error(fmt::format("the array in '{}' has {} numbers for each pixel, but a {} has {}",
                                 file.name, columns, form.what, wanted),
                     {}, fmt::format("the columns are {}", fmt::join(form.channels, ", ")));
    }
    MapBuilder builder(form, width, height);
    std::vector<double> pixel(wanted);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            for (std::size_t k = 0; k < wanted; ++k) {
                pixel[k] = (*array)(y, x, k);
            }
            builder.add(pixel, columns == wanted || (*array)(y, x, wanted) > 0.5);
        }
    }
    return builder.finish(file);
}

MapResult read_map(const MapForm& form, const File& file) {
    if (file.path.extension() != ".npy") {
        return read_image(form, file);
    }
    const Result<std::string> bytes = read_bytes(file, max_map_file);
    if (!bytes) {
        return bytes.diagnostics;
    }
    if (!is_npy(*bytes)) {
        return error(fmt::format("'{}' is no array of NumPy", file.name), {},
                     "write it with numpy.save");
    }
    return read_array(form, file, *bytes);
}

}  // namespace

MapResult read_ray_map(const File& file) { return read_map(ray_form, file); }

MapResult read_st_map(const File& file) { return read_map(position_form, file); }

}  // namespace balcony::data
