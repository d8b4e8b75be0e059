// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Random cameras from the whole catalogue.

#include <random>

#include "support.hpp"

namespace balcony::camera::random_cameras_test {

namespace {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}

    Camera camera() {
        Camera::Parts parts;
        parts.name = "random";
        parts.look =
            std::dynamic_pointer_cast<const DirectionRule>(stage(StageKind::direction_rule));
        parts.eye = path(parts.look->min_eye_dimension());
        if (parts.look->needs_direction_object()) {
            parts.toward = path(parts.look->min_direction_dimension());
        }
        // The parts fit, but a straight line has no outside.
        const Result<Camera> made = Camera::make(std::move(parts));
        return made ? *made : camera();
    }

private:
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
    }

    // Any stage of a kind, its numbers within their ranges and otherwise at will.
    std::shared_ptr<const Stage> stage(StageKind kind) {
        std::vector<const StageEntry*> rows;
        for (const StageEntry& row : catalogue()) {
            if (row.kind == kind) {
                rows.push_back(&row);
            }
        }
        const StageEntry& row = *rows[below(rows.size())];
        Given given;
        for (const StageParameter& parameter : row.parameters) {
            // Distortions at will fold nearly all of the image.
            if (row.section == "Calibrated cameras" && parameter.as<ChoiceParameter>() == nullptr) {
                continue;
            }
            if (const auto* choice = parameter.as<ChoiceParameter>()) {
                given[parameter.name] = std::string(choice->choices[below(choice->choices.size())]);
            } else if (const auto* count = parameter.as<CountParameter>()) {
                given[parameter.name] = numbers({std::round(number(count->range))});
            } else if (const auto* one = parameter.as<NumberParameter>()) {
                given[parameter.name] = numbers({number(one->range)});
            } else if (const auto* pair = parameter.as<PairParameter>()) {
                given[parameter.name] = numbers({number(pair->range), number(pair->range)});
            } else if (const auto* triple = parameter.as<TripleParameter>()) {
                const Range& range = triple->range;
                given[parameter.name] = numbers({number(range), number(range), number(range)});
            }
        }
        auto made = row.make(arguments_for(row, given));
        return made ? *made : stage(kind);
    }

    double number(const Range& range) {
        const double minimum = std::max(range.minimum, -4.0);
        const double maximum = std::min(range.maximum, 4.0);
        return std::uniform_real_distribution<double>(minimum, maximum)(engine_);
    }

    Path path(int min_dimension) {
        Path path;
        path.mapper =
            std::dynamic_pointer_cast<const PictureMapper>(stage(StageKind::picture_mapper));
        do {
            path.generator = std::dynamic_pointer_cast<const ObjectGenerator>(
                stage(StageKind::object_generator));
        } while (path.generator->dimension() < min_dimension);
        for (std::size_t i = below(4); i > 0; --i) {
            path.parameter_transformers.push_back(
                std::dynamic_pointer_cast<const ParameterTransformer>(
                    stage(StageKind::parameter_transformer)));
        }
        for (std::size_t i = below(4); i > 0; --i) {
            auto move = std::dynamic_pointer_cast<const ObjectTransformer>(
                stage(StageKind::object_transformer));
            if (move->min_dimension() <= path.generator->dimension()) {
                path.object_transformers.push_back(std::move(move));
            }
        }
        return path;
    }

    std::mt19937_64 engine_;
};

bool finite(const Vector& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace

TEST(RandomCameras, WhereThereIsARayItIsFiniteAndOfUnitDirection) {
    Random random(81);
    std::size_t rays_seen = 0;
    std::size_t without = 0;
    for (int i = 0; i < 1500; ++i) {
        const CameraProbe rays(random.camera(), 20.0, 12.0);
        for (double x = 0.0; x <= 20.0; x += 2.5) {
            for (double y = 0.0; y <= 12.0; y += 2.0) {
                const Ray ray = rays(x, y);
                if (!ray.valid) {
                    ++without;
                    continue;
                }
                ++rays_seen;
                ASSERT_TRUE(finite(ray.origin) && finite(ray.direction)) << "camera " << i;
                // The sum of three squares, a root, a division and three products.
                ASSERT_NEAR(length(ray.direction), 1.0, 2e-15) << "camera " << i;
            }
        }
    }
    // Many rays fall beside the maps, which have rays in a box alone.
    EXPECT_GT(rays_seen, without);
    EXPECT_GT(without, 0U);
}

}  // namespace balcony::camera::random_cameras_test
