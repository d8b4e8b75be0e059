// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays of a camera that is made anew for some of the unknowns.

#include <map>
#include <memory>
#include <vector>

#include "solve/input_rays.hpp"

namespace balcony::solve {

/// The rays of a camera for any values of the unknowns of a problem. Unknowns without an input are
/// numbers that the camera is made of; derivatives by them are differences. Belongs to one thread.
class CameraRays {
public:
    /// Fails if no camera can be made of the first values. All of these must outlive it.
    [[nodiscard]] static Result<CameraRays> make(const CameraMaker& make, const V2d& size,
                                                 const Problem& problem,
                                                 const std::stop_token& stop);

    /// The rays of a camera whose unknowns all have inputs, without shapes.
    CameraRays(std::shared_ptr<const InputRays> rays, const V2d& size, const Problem& problem);

    /// As of InputRays, by unknown. Invalid where no camera can be made.
    [[nodiscard]] std::vector<InputRay> at(std::span<const V2d> points,
                                           std::span<const double> values, bool by_unknown) const;
    [[nodiscard]] std::vector<ShapeValues> shapes(std::span<const double> values) const;

private:
    CameraRays(const CameraMaker& make, const V2d& size, const Problem& problem,
               const std::stop_token& stop);
    struct Split;
    [[nodiscard]] Split split(std::span<const double> values) const;
    struct Beside;
    template <class Open, class Closed>
    void for_each_unknown(const Split& numbers, const Open& open, const Closed& closed) const;
    [[nodiscard]] Result<std::shared_ptr<const InputRays>> made_of(
        const std::vector<double>& closed) const;
    [[nodiscard]] std::shared_ptr<const InputRays> kept(const std::vector<double>& closed) const;

    const CameraMaker* make_;
    const Problem* problem_;
    std::stop_token stop_;
    V2d size_;
    std::vector<std::string> inputs_;
    std::vector<const Constraint*> shapes_;
    std::size_t closed_ = 0;  ///< How many unknowns have no input.
    /// By the numbers that a camera is made of; null if none can be made.
    mutable std::map<std::vector<double>, std::shared_ptr<const InputRays>> cameras_;
};

}  // namespace balcony::solve
