// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Several projectors that show one picture together: masks that blend their edges, and meshes that
// warp the picture for each.
//
//     Blend::make(projectors) ─▶ write_mask(blend, 0, 2.2, "left.png")
//                             ─▶ warp_mesh(blend, 0, StMap from the picture) ─▶ to_text
//
// The camera of a projector says from which direction the audience sees the light of each of its
// pixels. So all of them have a single viewpoint, that of the audience.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "balcony/st_maps.hpp"

namespace balcony::bridge {

/// Shares of projectors in the light of each place. Immutable, may be shared by threads, cheap to
/// copy.
class Blend {
public:
    /// The pictures of the projectors, at least one: each with its pixels and its inverse. Unless
    /// parallax is ignored, several viewpoints are an error. A stop is an error of
    /// Kind::interrupted.
    [[nodiscard]] static Result<Blend> make(const std::vector<SourceCamera>& projectors,
                                            Parallax parallax = Parallax::refuse,
                                            const std::stop_token& stop = {});

    [[nodiscard]] std::size_t size() const;  ///< The number of projectors.
    [[nodiscard]] const RayGrid& rays(std::size_t projector) const;

    /// The share of a projector, from 0 to 1, at pixels of some of its rows; 0 where it shows
    /// nothing. It is the distance from the border of what the projector shows, as a part of the
    /// shorter side of its picture, divided by the sum of those of all projectors that show the
    /// same direction. So the shares of a direction have the sum 1.
    void run(std::size_t projector, std::size_t first_row, std::size_t rows,
             std::vector<double>& shares) const;
    /// The same at any places of its picture where it has rays, in pixels.
    void at(std::size_t projector, std::span<const V2d> places, std::vector<double>& shares) const;

private:
    class Index;
    explicit Blend(std::shared_ptr<const Index> index) : index_(std::move(index)) {}
    std::shared_ptr<const Index> index_;
};

/// What came of a mask.
struct MaskWritten {
    std::size_t overlap = 0;  ///< Pixels that other projectors show, too.
    Diagnostics problems{};
};

/// Writes what the pixels of a projector have to be multiplied by: share^(1/gamma), for a projector
/// whose light is its pixel^gamma. A grey picture of 16 bits: .png or .tif.
[[nodiscard]] MaskWritten write_mask(const Blend& blend, std::size_t projector, double gamma,
                                     const std::filesystem::path& file,
                                     const std::stop_token& stop = {});

/// A mesh in the format of P. Bourke, "Mesh format for image warping", 2006
/// (paulbourke.net/dataformats/meshwarp), of type 2, rectangular.
struct WarpMesh {
    struct Node {
        V2d position;  ///< In the projector's picture: x from -aspect to aspect, y from -1 up to 1.
        V2d texture;   ///< In the picture to be shown, from (0, 0) at its bottom left to (1, 1).
        double intensity =
            -1.0;  ///< What its light is multiplied by; below 0 where nothing is shown.
    };
    std::size_t columns = 0, rows = 0;  ///< Of nodes.
    std::vector<Node> nodes;            ///< Row by row from the bottom left.
};

/// The mesh of a projector; `picture` is the map from the same rays to the picture to be shown. The
/// intensity is share^(1/gamma), as in a mask, or 1 for a projector that a mask blends.
[[nodiscard]] WarpMesh warp_mesh(const Blend& blend, std::size_t projector, const StMap& picture,
                                 std::size_t columns, std::size_t rows,
                                 std::optional<double> gamma);
[[nodiscard]] std::string to_text(const WarpMesh& mesh);

}  // namespace balcony::bridge
