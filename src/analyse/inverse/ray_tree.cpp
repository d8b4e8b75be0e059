// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/ray_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

namespace balcony::analyse {

namespace {

// The radii of the bounds of a patch's own rays.
double origin_radius(const RayPatch& patch) {
    return RayPatch::reach * ((patch.ray.origin_by_x * patch.half.x).length() +
                              (patch.ray.origin_by_y * patch.half.y).length()) +
           patch.origin_bend;
}

double cone_angle(const RayPatch& patch) {
    const double chord = RayPatch::reach * ((patch.ray.direction_by_x * patch.half.x).length() +
                                            (patch.ray.direction_by_y * patch.half.y).length()) +
                         patch.direction_bend;
    return 2.0 * std::asin(std::min(0.5 * chord, 1.0));
}

double angle_between(const V3d& a, const V3d& b) {
    return 2.0 * std::asin(std::min(0.5 * (a - b).length(), 1.0));
}

}  // namespace

class RayTree::Builder {
public:
    Builder(const std::vector<RayPatch>& patches, double extent, const Work& work)
        : patches_(patches), work_(work), numbers_(patches.size()) {
        std::iota(numbers_.begin(), numbers_.end(), 0U);
        for (const RayPatch& patch : patches) {
            const V3d origin = extent > 0.0 ? patch.ray.origin / extent : V3d(0.0);
            const V3d& direction = patch.ray.direction;
            keys_.push_back({origin.x, origin.y, origin.z, direction.x, direction.y, direction.z});
            radii_.push_back(origin_radius(patch));
            angles_.push_back(cone_angle(patch));
        }
    }

    std::vector<Node> run() {
        if (!numbers_.empty()) {
            build(0, numbers_.size());
        }
        return std::move(nodes_);
    }

private:
    // Halves are of equal size, so the depth is the logarithm of their number.
    void build(std::size_t begin, std::size_t end) {
        work_.go_on();
        const std::size_t at = nodes_.size();
        const std::span<std::uint32_t> part(numbers_.data() + begin, end - begin);
        nodes_.push_back({bounds(part), 0, part.size() == 1 ? part.front() : no_patch});
        if (part.size() > 1) {
            const std::size_t half = part.size() / 2;
            const std::size_t axis = widest_axis(part);
            std::nth_element(
                part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                [&](std::uint32_t a, std::uint32_t b) { return keys_[a][axis] < keys_[b][axis]; });
            build(begin, begin + half);
            build(begin + half, end);
        }
        nodes_[at].skip = static_cast<std::uint32_t>(nodes_.size());
    }

    [[nodiscard]] std::size_t widest_axis(std::span<const std::uint32_t> part) const {
        Key minimum = keys_[part.front()];
        Key maximum = minimum;
        for (const std::uint32_t number : part) {
            for (std::size_t axis = 0; axis < minimum.size(); ++axis) {
                minimum[axis] = std::min(minimum[axis], keys_[number][axis]);
                maximum[axis] = std::max(maximum[axis], keys_[number][axis]);
            }
        }
        std::size_t widest = 0;
        for (std::size_t axis = 1; axis < minimum.size(); ++axis) {
            if (maximum[axis] - minimum[axis] > maximum[widest] - minimum[widest]) {
                widest = axis;
            }
        }
        return widest;
    }

    [[nodiscard]] Bounds bounds(std::span<const std::uint32_t> part) const {
        Bounds made;
        for (const std::uint32_t number : part) {
            made.center += patches_[number].ray.origin / static_cast<double>(part.size());
            made.axis += patches_[number].ray.direction;
        }
        // The directions of a hemisphere or more may cancel out.
        made.axis = made.axis.length() > 1e-6 ? made.axis.normalized()
                                              : patches_[part.front()].ray.direction;
        double angle = 0.0;
        for (const std::uint32_t number : part) {
            const Ray& ray = patches_[number].ray;
            made.radius =
                std::max(made.radius, (ray.origin - made.center).length() + radii_[number]);
            angle = std::max(angle, angle_between(ray.direction, made.axis) + angles_[number]);
        }
        angle = std::min(angle, std::numbers::pi);
        made.cosine = std::cos(angle);
        made.sine = std::sin(angle);
        return made;
    }

    using Key = std::array<double, 6>;

    const std::vector<RayPatch>& patches_;
    const Work& work_;
    std::vector<std::uint32_t> numbers_;
    std::vector<Key> keys_;
    std::vector<double> radii_;
    std::vector<double> angles_;
    std::vector<Node> nodes_;
};

RayTree::RayTree(std::vector<RayPatch> patches, double extent, const Work& work)
    : patches_(std::move(patches)), nodes_(Builder(patches_, extent, work).run()) {}

// Seen from anywhere in the ball, the point may lie in directions up to asin(radius/distance)
// from that of the ball's centre; a cone widened by that angle must hold it.
bool RayTree::Bounds::sees(const V3d& point) const {
    const V3d v = point - center;
    const double squared = v.length2() - radius * radius;
    if (squared <= 0.0) {
        return true;
    }
    const double tangent = std::sqrt(squared);
    const bool wider_than_all = sine * tangent + cosine * radius < 0.0;
    // A small tolerance, because a cone may be a single direction.
    const double rounding = 1e-13 * (tangent + radius);
    return wider_than_all || v.dot(axis) >= cosine * tangent - sine * radius - rounding;
}

void RayTree::find(const V3d& point, std::vector<std::uint32_t>& found) const {
    std::uint32_t at = 0;
    while (at < nodes_.size()) {
        const Node& node = nodes_[at];
        if (!node.bounds.sees(point)) {
            at = node.skip;
            continue;
        }
        if (node.patch != no_patch) {
            found.push_back(node.patch);
        }
        ++at;
    }
}

}  // namespace balcony::analyse
