// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

namespace {

using camera::PictureMapperPointer;

/// Another mapper with an offset.
class ShiftedMapper final : public camera::PictureMapper {
public:
    ShiftedMapper(PictureMapperPointer mapper, const V2d& shift)
        : mapper_(std::move(mapper)), shift_(shift) {}

    camera::ParameterPoint map(const camera::PicturePoint& picture,
                               camera::Emitter& emit) const override {
        const auto [u, v] = mapper_->map(picture, emit);
        return {u + shift_.x, v + shift_.y};
    }

private:
    PictureMapperPointer mapper_;
    V2d shift_;
};

/// Compares some rays of the camera with those at shifted parameters.
class TurnCounter {
public:
    TurnCounter(const camera::Camera& camera, double width, double height, double time)
        : camera_(camera), width_(width), height_(height), time_(time), rays_(rays_of(camera)) {}

    Turns operator()() const {
        const V2d extent = max_extent();
        return {turns(extent.x, {1.0, 0.0}), turns(extent.y, {0.0, 1.0})};
    }

private:
    // Periodic rays repeat after 2 pi and not after 1; constant rays would repeat after both.
    [[nodiscard]] double turns(double extent, const V2d& along) const {
        constexpr double turn = 2.0 * std::numbers::pi;
        return come_back(turn * along) && !come_back(along) ? extent / turn : 0.0;
    }

    [[nodiscard]] bool come_back(const V2d& shift) const {
        camera::Camera::Parts parts = camera_.parts();
        parts.eye.mapper = std::make_shared<ShiftedMapper>(parts.eye.mapper, shift);
        if (parts.toward) {
            parts.toward->mapper = std::make_shared<ShiftedMapper>(parts.toward->mapper, shift);
        }
        const auto shifted = camera::Camera::make(std::move(parts));
        return shifted && agree(rays_, rays_of(*shifted));
    }

    // In all samples that both have; there must be at least one.
    static bool agree(const std::vector<Ray>& some, const std::vector<Ray>& others) {
        // Far above the rounding error of an angle of many turns, far below visibility.
        constexpr double tolerance = 1e-8;
        bool any = false;
        for (std::size_t i = 0; i < some.size(); ++i) {
            const Ray& a = some[i];
            const Ray& b = others[i];
            if (a.valid != b.valid) {
                return false;
            }
            any = any || a.valid;
            if (a.valid &&
                !((a.origin - b.origin).length() <= tolerance * (1.0 + a.origin.length()) &&
                  (a.direction - b.direction).length() <= tolerance)) {
                return false;
            }
        }
        return any;
    }

    [[nodiscard]] std::vector<Ray> rays_of(const camera::Camera& camera) const {
        constexpr int along_a_side = 5;
        std::vector<V2d> points;
        for (int row = 0; row < along_a_side; ++row) {
            for (int column = 0; column < along_a_side; ++column) {
                points.emplace_back(width_ * (column + 0.5) / along_a_side,
                                    height_ * (row + 0.5) / along_a_side);
            }
        }
        Result<RayField> field =
            RayField::make(camera, width_, height_, time_, RayField::Derivatives::without);
        return field ? field->at(points) : std::vector<Ray>();
    }

    // From the maps of both paths.
    [[nodiscard]] V2d max_extent() const {
        const V2d eye = extent(*camera_.parts().eye.mapper);
        const auto& toward = camera_.parts().toward;
        const V2d other = toward ? extent(*toward->mapper) : V2d(0.0);
        return {std::max(eye.x, other.x), std::max(eye.y, other.y)};
    }

    // The range of u and v from corner to corner.
    [[nodiscard]] V2d extent(const camera::PictureMapper& mapper) const {
        expr::Graph graph;
        camera::Emitter emit(graph);
        const auto at = [&](double x, double y) {
            const camera::ParameterPoint p =
                mapper.map({{graph.constant(x), graph.constant(y)},
                            {graph.constant(width_), graph.constant(height_)}},
                           emit);
            const std::vector<double> values =
                expr::evaluate(std::array{p.u, p.v}, {.x = x, .y = y, .time = time_});
            return V2d(values[0], values[1]);
        };
        const V2d across = at(width_, height_) - at(0.0, 0.0);
        return {std::abs(across.x), std::abs(across.y)};
    }

    const camera::Camera& camera_;
    double width_;
    double height_;
    double time_;
    std::vector<Ray> rays_;
};

}  // namespace

Turns count_turns(const camera::Camera& camera, double width, double height, double time) {
    return TurnCounter(camera, width, height, time)();
}

}  // namespace balcony::analyse
