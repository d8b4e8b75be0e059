// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/format.h>

#include "balcony/expr.hpp"
#include "dataset/poses/poses.hpp"

namespace balcony::dataset {

namespace {

/// Places on a path and what is looked at, as functions of time.
class Path {
public:
    explicit Path(const PathPoses& wanted)
        : expressions_(camera::between_keys(keyframes(wanted), graph_.time())) {}

    [[nodiscard]] PathKey at(double time) const {
        const std::vector<double> values = expr::evaluate(expressions_, {.time = time});
        return {{values[0], values[1], values[2]}, {values[3], values[4], values[5]}, time};
    }

private:
    camera::Keyframes keyframes(const PathPoses& wanted) {
        camera::Keyframes keys{.times = {}, .values = {}, .ease = wanted.ease};
        keys.beyond = wanted.closed ? camera::BeyondKeys::repeat : camera::BeyondKeys::constant;
        keys.values.resize(6);
        for (const PathKey& key : wanted.keys) {
            keys.times.push_back(key.time);
            for (int i = 0; i < 3; ++i) {
                const auto component = static_cast<std::size_t>(i);
                keys.values[component].push_back(graph_.constant(key.at[i]));
                keys.values[component + 3].push_back(graph_.constant(key.look_at[i]));
            }
        }
        return keys;
    }

    expr::Graph graph_;
    std::vector<expr::Expr> expressions_;
};

}  // namespace

Result<std::vector<camera::Pose>> path_poses(const PathPoses& wanted, Axes axes) {
    const Path path(wanted);
    const double first = wanted.keys.front().time;
    const double length = wanted.keys.back().time - first;
    // The last pose of a closed path would be the first one again.
    const std::size_t steps = wanted.closed ? wanted.count : wanted.count - 1;
    std::vector<camera::Pose> made;
    for (std::size_t i = 0; i < wanted.count; ++i) {
        const double part = steps > 0 ? static_cast<double>(i) / static_cast<double>(steps) : 0.0;
        const PathKey key = path.at(first + part * length);
        const V3d ahead = turned(key.look_at - key.at, axes, Axes::z_up);
        const double level = std::hypot(ahead.x, ahead.y);
        constexpr double vertical = 1e-9;
        if (!(level > vertical * ahead.length())) {
            return error(
                Kind::usage,
                fmt::format("pose {} of a path looks straight up or down, or nowhere", i + 1),
                "move what is looked at a little, or list poses as matrices");
        }
        made.push_back(pose_at(turned(key.at, axes, Axes::z_up), std::atan2(ahead.y, ahead.x),
                               std::atan2(ahead.z, level), 0.0));
    }
    return made;
}

}  // namespace balcony::dataset
