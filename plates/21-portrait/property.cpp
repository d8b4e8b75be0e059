// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "balcony/data.hpp"
#include "balcony/lang.hpp"
#include "balcony/prescription.hpp"
#include "balcony/rays.hpp"
#include "measure/property.hpp"

namespace balcony::plates {

namespace portrait_plate {

using rays::V2d;
using rays::V3d;

constexpr V2d picture(600.0, 400.0);   // Pixels.
constexpr double to_queen = 0.824;     // Metres along the axis of the lens.
constexpr double half_width = 0.2118;  // Of the picture, on a plane at distance 1.
constexpr double to_lampion = 9.0;

template <class T>
T checked(Result<T> result) {
    if (!result) {
        throw std::runtime_error(to_text(result.diagnostics));
    }
    return std::move(*result);
}

camera::ParaxialLens prescription() {
    const auto lens =
        checked(data::read_prescription(checked(data::find_file("petzval.dat", std::nullopt))));
    return camera::paraxial(*lens);
}

/// What the lens shows at points of the picture, by rays through points all over its aperture.
class Pencils {
public:
    Pencils(const Overrides& overrides, double entrance_pupil)
        : program_(checked(rays::compile(
              checked(lang::make_camera(BALCONY_PLATES "/21-portrait/camera.cam", "portrait",
                                        overrides)),
              picture.x, picture.y,
              {.points = true,
               .inputs = {{std::string(camera::lens_input_x), program::Rate::pixel},
                          {std::string(camera::lens_input_y), program::Rate::pixel}}}))) {
        const rays::Ray axis = through(0.5 * picture, std::array{0.0}, std::array{0.0}).front();
        forward_ = axis.direction;
        eye_ = axis.origin - 0.001 * entrance_pupil * forward_;
        right_ = forward_.cross(V3d(0.0, 0.0, 1.0)).normalized();
        up_ = right_.cross(forward_);
    }

    struct Pencil {
        double lit = 0.0;  ///< The part of the aperture through which light comes.
        /// Of the rays in metres, to the right and upwards, where they cross a plane.
        V2d extent{0.0};
    };
    /// On a plane across the axis, at a distance from the entrance pupil.
    [[nodiscard]] Pencil operator()(const V2d& point, double distance) const {
        constexpr std::size_t side = 96;
        std::vector<double> x, y;
        for (std::size_t i = 0; i < side * side; ++i) {
            x.push_back((2.0 * static_cast<double>(i % side) + 1.0) / side - 1.0);
            y.push_back((2.0 * static_cast<double>(i / side) + 1.0) / side - 1.0);
        }
        const std::vector<rays::Ray> found = through(point, x, y);
        V2d least(1e9);
        V2d most(-1e9);
        for (const rays::Ray& ray : found) {
            const V3d from = ray.origin - eye_;
            const double along = (distance - from.dot(forward_)) / ray.direction.dot(forward_);
            const V3d at = from + along * ray.direction;
            const V2d across(at.dot(right_), at.dot(up_));
            least = V2d(std::min(least.x, across.x), std::min(least.y, across.y));
            most = V2d(std::max(most.x, across.x), std::max(most.y, across.y));
        }
        return {static_cast<double>(found.size()) / (side * side), most - least};
    }

private:
    [[nodiscard]] std::vector<rays::Ray> through(const V2d& point, std::span<const double> x,
                                                 std::span<const double> y) const {
        const std::vector<double> column(x.size(), point.x);
        const std::vector<double> row(x.size(), point.y);
        rays::Scratch scratch;
        rays::RayBatch batch;
        program_.run(rays::Points{column, row, 0.0, std::array{x, y}}, scratch, batch);
        std::vector<rays::Ray> found;
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (batch.valid(i)) {
                found.push_back(batch[i]);
            }
        }
        return found;
    }

    rays::RayProgram program_;
    V3d eye_{0.0}, forward_{0.0}, right_{0.0}, up_{0.0};
};

// Behind the queen, which is sharp, lampions are discs as large as the prescription says; beside
// the middle, the mount cuts them to the shape of a cat's eye, and the corners are darker.
Measurements measure(Studio&, const Overrides& overrides) {
    const camera::ParaxialLens lens = prescription();
    const Pencils pencil(overrides, lens.entrance_pupil);
    const V2d middle = 0.5 * picture;
    const auto disc = pencil(middle, to_lampion);
    const double thin_lens = 0.002 * lens.entrance_radius * (to_lampion - to_queen) / to_queen;
    const auto edge = pencil({0.02 * picture.x, middle.y}, to_lampion);
    const auto corner = pencil(0.02 * picture, to_lampion);
    const double pixel = 2.0 * half_width * to_queen / picture.x;
    return {
        {"blur of a point of the queen in a picture of 600 pixels, in pixels",
         pencil(middle, to_queen).extent.x / pixel, 0.0, 2.0},
        {"disc of a lampion that is 9 m away, divided by that of the paraxial lens",
         disc.extent.x / thin_lens, 0.97, 1.03},
        {"width of such a disc at the left edge, divided by its height",
         edge.extent.x / edge.extent.y, 0.3, 0.85},
        {"light in the corner, divided by that in the middle", corner.lit / disc.lit, 0.1, 0.6}};
}

}  // namespace portrait_plate

Property plate_21() {
    return {21, portrait_plate::measure, {{{"f", "5.6"}}, {{"distance", "1.2"}}}};
}

}  // namespace balcony::plates
