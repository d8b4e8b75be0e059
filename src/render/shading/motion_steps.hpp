// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "balcony/motion.hpp"

namespace balcony::render {

/// The place of a time from 0 to 1 between equal steps.
struct BetweenSteps {
    std::size_t before = 0;  ///< There is a step after this one, unless there is only one.
    float part = 0.0F;       ///< Of the way to that step.

    /// For a number of steps.
    BetweenSteps(float time, std::size_t count);
};

/// The places of all instances of a scene at equal steps of time; what stands still has one step.
/// The scene and the movement must outlive it.
class MotionSteps {
public:
    MotionSteps(const scene::Scene& scene, const scene::Movement& movement);

    [[nodiscard]] std::span<const scene::M44d> matrices(std::size_t instance) const {
        const auto found = instances_.find(instance);
        return found == instances_.end()
                   ? std::span(&scene_->instances[instance].world_from_mesh, 1)
                   : std::span<const scene::M44d>(found->second->world_from_mesh);
    }

private:
    const scene::Scene* scene_;
    std::unordered_map<std::size_t, const scene::InstanceSteps*> instances_;
};

/// The places of the instances that move, in floats, as they are traced: between two steps, the
/// elements of the matrix change linearly.
class MovingPlacements {
public:
    explicit MovingPlacements(const scene::Movement& movement);

    [[nodiscard]] bool empty() const { return steps_.empty(); }
    /// The place of an instance at a time; nothing if it stands still.
    [[nodiscard]] std::optional<Imath::M44f> world_from_mesh(std::uint32_t instance,
                                                             float time) const;
    /// 1 if the instance stands still.
    [[nodiscard]] std::size_t step_count(std::uint32_t instance) const;

private:
    std::unordered_map<std::uint32_t, std::vector<Imath::M44f>> steps_;
};

}  // namespace balcony::render
