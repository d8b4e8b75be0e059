// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "balcony/scene.hpp"
#include "shading/lights/light_tree.hpp"

namespace balcony::render {

using Imath::V3f;

/// Builds the tree from the root. A node's lights are divided in two, then the more expensive part
/// again, until there are as many parts as lanes.
class LightTreeBuilder {
public:
    LightTreeBuilder(LightTree& tree, std::span<const LightBounds> lights,
                     const std::stop_token& stop)
        : tree_(tree), stop_(stop) {
        tree.places_.assign(lights.size(), LightTree::none);
        double power = 0.0;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (lights[i].power > 0.0F) {
                power += double{lights[i].power};
                bounds_.push_back(lights[i]);
                numbers_.push_back(static_cast<std::uint32_t>(i));
            }
        }
        scale_ = static_cast<float>(1.0 / power);
        tree.power_ = static_cast<float>(std::min(power, scene::max_quantity));
    }

    void build() {
        if (!bounds_.empty() && !stop_.stop_requested()) {
            add_node(0, bounds_.size(), LightTree::none, 0, 0);
        }
    }

private:
    // Bounds are wider than the lights by more than rounding errors, so that no light has
    // importance 0 where it arrives.
    static constexpr float slack = 1e-3F;
    static constexpr std::size_t bins = 12;
    // Deeper nodes are divided in the middle.
    static constexpr std::size_t max_depth = 24;

    struct Part {
        std::size_t begin = 0;
        std::size_t end = 0;
        float cost = 0.0F;

        [[nodiscard]] std::size_t size() const { return end - begin; }
    };

    // What the cost of a choice among lights depends on.
    struct Sum {
        Imath::Box3f box;
        V3f axes{0.0F};
        float count = 0.0F;
        float power = 0.0F;

        void add(const LightBounds& light) {
            box.extendBy(light.box);
            const float spread = 0.5F * (1.0F + light.cosine_spread);
            axes +=
                (light.two_sided && light.axis.dot(axes) < 0.0F ? -spread : spread) * light.axis;
            count += 1.0F;
            power += light.power;
        }

        void add(const Sum& other) {
            box.extendBy(other.box);
            axes += other.axes;
            count += other.count;
            power += other.power;
        }

        // The orientation heuristic of Conty Estevez and Kulla, with the radius of the sphere that
        // importance() uses in place of the surface of a box, and with a line through the values of
        // the solid angle of emission for a single axis and for all: pi and 4 pi. Directions spread
        // evenly within an angle have a mean vector of length (1 + cosine) / 2.
        [[nodiscard]] float cost() const {
            const float cosine = 2.0F * axes.length() / count - 1.0F;
            return power * (2.5F - 1.5F * cosine) * box.size().length2();
        }
    };

    struct Split {
        int axis = -1;
        std::size_t bin = 0;
        float cost = std::numeric_limits<float>::infinity();
    };

    std::uint32_t add_node(std::size_t begin, std::size_t end, std::uint32_t parent,
                           std::uint32_t place, std::size_t depth) {
        const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
        tree_.nodes_.emplace_back();
        tree_.nodes_[index].parent = parent;
        tree_.nodes_[index].place = place;
        if (stop_.stop_requested()) {
            return index;
        }
        const std::vector<Part> parts = divided(begin, end, depth);
        for (std::uint32_t child = 0; child < parts.size(); ++child) {
            const Part& part = parts[child];
            set_bounds(tree_.nodes_[index], child,
                       bounds_of(std::span(bounds_).subspan(part.begin, part.size())));
            if (part.size() == 1) {
                const std::uint32_t light = numbers_[part.begin];
                tree_.nodes_[index].child[child] = light;
                tree_.nodes_[index].leaves |= 1U << child;
                tree_.places_[light] = LightTree::width * index + child;
            } else {
                const std::uint32_t below = add_node(part.begin, part.end, index, child, depth + 1);
                tree_.nodes_[index].child[child] = below;
            }
        }
        return index;
    }

    void set_bounds(LightTree::Node& node, std::uint32_t child, const LightBounds& bounds) const {
        const V3f center = bounds.box.center();
        const float rounding = std::numeric_limits<float>::epsilon() *
                               (std::abs(center.x) + std::abs(center.y) + std::abs(center.z));
        const V3f half = (0.5F + slack) * bounds.box.size() + V3f(rounding);
        const float spread = widened(bounds.cosine_spread);
        const bool all_directions = spread >= std::numbers::pi_v<float>;
        node.x[child] = center.x;
        node.y[child] = center.y;
        node.z[child] = center.z;
        node.half_x[child] = half.x;
        node.half_y[child] = half.y;
        node.half_z[child] = half.z;
        node.axis_x[child] = bounds.axis.x;
        node.axis_y[child] = bounds.axis.y;
        node.axis_z[child] = bounds.axis.z;
        node.cosine_spread[child] = all_directions ? -2.0F : std::cos(spread);
        node.sine_spread[child] = std::sin(spread);
        node.cosine_falloff[child] = std::cos(widened(bounds.cosine_falloff));
        node.back[child] = bounds.two_sided ? -1.0F : 1.0F;
        node.power[child] = bounds.power * scale_;
    }

    // An angle with the slack, by its cosine.
    [[nodiscard]] static float widened(float cosine) {
        return std::acos(std::clamp(cosine, -1.0F, 1.0F)) + slack;
    }

    [[nodiscard]] std::vector<Part> divided(std::size_t begin, std::size_t end, std::size_t depth) {
        std::vector<Part> parts;
        if (end - begin <= LightTree::width) {
            for (std::size_t i = begin; i < end; ++i) {
                parts.push_back({i, i + 1});
            }
            return parts;
        }
        parts.push_back({begin, end});
        while (parts.size() < LightTree::width) {
            const auto next =
                std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
                    return std::pair(a.size() > 1, a.cost) < std::pair(b.size() > 1, b.cost);
                });
            if (next->size() == 1) {
                break;
            }
            const std::size_t middle = divide(*next, depth);
            const Part upper = part(middle, next->end);
            *next = part(next->begin, middle);
            parts.push_back(upper);
        }
        return parts;
    }

    [[nodiscard]] Part part(std::size_t begin, std::size_t end) const {
        Sum sum;
        for (std::size_t i = begin; i < end; ++i) {
            sum.add(bounds_[i]);
        }
        return {begin, end, sum.cost()};
    }

    // Reorders the lights of a part, and returns the first of its upper half.
    std::size_t divide(const Part& all, std::size_t depth) {
        Imath::Box3f centers;
        for (std::size_t i = all.begin; i < all.end; ++i) {
            centers.extendBy(bounds_[i].box.center());
        }
        Split best;
        for (int axis = 0; axis < 3 && depth < max_depth && all.size() > 2; ++axis) {
            const float extent = centers.size()[axis];
            if (extent > 0.0F && std::isfinite(extent)) {
                const Split found = find_split(all, axis, centers);
                best = found.cost < best.cost ? found : best;
            }
        }
        if (best.axis < 0) {
            return all.begin + all.size() / 2;
        }
        std::size_t middle = all.begin;
        for (std::size_t i = all.begin; i < all.end; ++i) {
            if (bin_of(bounds_[i], best.axis, centers) < best.bin) {
                std::swap(bounds_[i], bounds_[middle]);
                std::swap(numbers_[i], numbers_[middle]);
                ++middle;
            }
        }
        return middle;
    }

    [[nodiscard]] static std::size_t bin_of(const LightBounds& one, int axis,
                                            const Imath::Box3f& centers) {
        const float low = centers.min[axis];
        const float share = (one.box.center()[axis] - low) / (centers.max[axis] - low);
        return std::min(static_cast<std::size_t>(share * static_cast<float>(bins)), bins - 1);
    }

    // The cheapest division between two bins along an axis.
    [[nodiscard]] Split find_split(const Part& all, int axis, const Imath::Box3f& centers) const {
        std::array<Sum, bins> found;
        for (std::size_t i = all.begin; i < all.end; ++i) {
            found[bin_of(bounds_[i], axis, centers)].add(bounds_[i]);
        }
        // The first and the last bin are never empty.
        std::array<float, bins> below{};
        Sum sum;
        for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
            sum.add(found[bin]);
            below[bin + 1] = sum.cost();
        }
        // Against thin parts.
        const V3f size = centers.size();
        const float regularity = std::max({size.x, size.y, size.z}) / size[axis];
        Split best;
        sum = {};
        for (std::size_t bin = bins - 1; bin > 0; --bin) {
            sum.add(found[bin]);
            const float total = regularity * (below[bin] + sum.cost());
            if (total < best.cost) {
                best = {axis, bin, total};
            }
        }
        return best;
    }

    LightTree& tree_;
    const std::stop_token& stop_;
    std::vector<LightBounds> bounds_;     // Of lights with power, reordered.
    std::vector<std::uint32_t> numbers_;  // The lights in this order.
    float scale_ = 1.0F;                  // Makes the power of all lights 1.
};

LightTree::LightTree(std::span<const LightBounds> lights, const std::stop_token& stop) {
    LightTreeBuilder(*this, lights, stop).build();
}

}  // namespace balcony::render
