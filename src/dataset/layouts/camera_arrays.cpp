// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/layouts/camera_arrays.hpp"

#include "dataset/frames/frame_data.hpp"

namespace balcony::dataset {

std::string vectors_npy(const std::vector<std::size_t>& shape, const std::vector<V3d>& vectors) {
    std::vector<float> numbers;
    numbers.reserve(3 * vectors.size());
    for (const V3d& v : vectors) {
        numbers.insert(numbers.end(),
                       {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    }
    return npy_bytes(shape, std::span<const float>(numbers));
}

std::string poses_npy(const Plan& plan, std::size_t scene, const camera::Pose& in_camera) {
    const PlannedScene& planned = plan.scenes[scene];
    std::vector<double> numbers;
    for (const PlannedPose& one : planned.poses) {
        const auto matrix =
            app::matrix_of(app::combined(one.pose, in_camera), "opencv", planned.axes);
        for (const auto& row : *matrix) {
            numbers.insert(numbers.end(), row.begin(), row.end());
        }
        numbers.insert(numbers.end(), {0.0, 0.0, 0.0, 1.0});
    }
    return npy_bytes({planned.poses.size(), 4, 4}, std::span<const double>(numbers));
}

}  // namespace balcony::dataset
