// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Layers: the images that a film has beside the picture. docs/layers.md lists them.
//
// A new layer needs an enumerator, a vector in film.hpp for its values, a row in layers.cpp, and
// the place that computes it.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "balcony/base.hpp"

namespace balcony::render {

enum class LayerId : std::uint8_t {
    ray_length,
    position,
    normal,
    albedo,
    object,
    origin,
    direction,
    parameters,
    valid,
    picture_layer,
    samples,
    magnification,
    motion,
    emission,
    direct,
    indirect,
    direct_half,
    indirect_half,
    mean_albedo,
    mean_normal,
    mean_position,
    crypto_object,
    crypto_material,
    variance,
    noisy,
};

/// A set of layers.
class LayerSet {
public:
    constexpr LayerSet() = default;
    constexpr LayerSet(std::initializer_list<LayerId> ids) {
        for (const LayerId id : ids) {
            insert(id);
        }
    }

    constexpr void insert(LayerId id) { bits_ |= bit(id); }
    constexpr void insert(LayerSet other) { bits_ |= other.bits_; }
    constexpr void erase(LayerId id) { bits_ &= ~bit(id); }
    [[nodiscard]] constexpr bool contains(LayerId id) const { return (bits_ & bit(id)) != 0; }
    [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
    bool operator==(const LayerSet&) const = default;

private:
    static constexpr std::uint64_t bit(LayerId id) {
        return std::uint64_t{1} << static_cast<unsigned>(id);
    }
    std::uint64_t bits_ = 0;
};

/// How the value of a pixel comes about.
enum class LayerSampling : std::uint8_t {
    center,  ///< At the exact centre of the pixel, unfiltered: by pass 0.
    mean,    ///< The mean over all passes, filtered like the picture.
    film,    ///< A number of the film itself.
};

struct LayerInfo {
    LayerId id;
    std::string_view name;  ///< In an EXR file, a channel is called name.letter.
    /// A letter for each channel, as other programs expect them: one, three or four.
    std::string_view channels;
    std::string_view meaning;
    LayerSampling sampling = LayerSampling::center;
    bool by_default = true;  ///< Whether an EXR file has the layer without being asked.
    std::size_t bytes = 0;   ///< Of the film, per pixel.
    std::size_t levels = 1;  ///< If more than one, the name in a channel has two digits: name00.
    LayerSet needs{};        ///< Layers from which this one is computed.
};

/// All layers, in the order of LayerId.
[[nodiscard]] std::span<const LayerInfo> layers();

/// The layers that an EXR file has without being asked: those that cost little.
[[nodiscard]] LayerSet default_layers();

/// The layers of a list of names, separated by commas, where `default`, `all` and `none` are sets.
/// `noisy` is none of them, since only denoising adds it. An unknown name is an error.
[[nodiscard]] Result<LayerSet> find_layers(std::string_view list);

}  // namespace balcony::render
