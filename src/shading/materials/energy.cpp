// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/energy.hpp"

#include <cmath>

#include <tbb/task_arena.h>

#include "base/parallel_for.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t width_count = 40;

// The mean of schlick(), weighted by the cosine.
constexpr float mean_schlick = 1.0F / 21.0F;

}  // namespace

LayerEnergies::Row LayerEnergies::make_row(float alpha) {
    const GgxTransport transport = ggx_transport(alpha);
    ByCosine one;
    one.fill(1.0F);
    const ByCosine scale = balance(transport.reflected, one);
    Row row{};
    for (std::size_t i = 0; i < cosine_count; ++i) {
        const Entry entry{scale[i], transport.reflected(i, one), transport.edge(i, one),
                          scale[i] * transport.edge(i, scale)};
        row.by_cosine[i] = entry;
        const float weight = cosine_weights()[i];
        row.mean.single += weight * entry.single;
        row.mean.single_edge += weight * entry.single_edge;
        row.mean.all_edge += weight * entry.all_edge;
    }
    return row;
}

const std::vector<LayerEnergies::Row>& LayerEnergies::rows() {
    static const std::vector<Row> made = [] {
        std::vector<Row> all(width_count);
        // Isolated: this thread takes no other task, which might wait for these rows.
        tbb::this_task_arena::isolate([&all] {
            parallel_for(width_count,
                         [&all](std::size_t i) { all[i] = make_row(table_width(i, width_count)); });
        });
        return all;
    }();
    return made;
}

LayerEnergies::LayerEnergies(float alpha) {
    if (alpha < min_alpha) {
        return;
    }
    const TablePosition at = position_of_width(alpha, width_count);
    lower_ = &rows()[at.node];
    fraction_ = at.fraction;
}

std::shared_ptr<const void> LayerEnergies::keep_row() {
    if (lower_ == nullptr) {
        return nullptr;
    }
    const auto row = std::make_shared<Row>();
    for (std::size_t i = 0; i < cosine_count; ++i) {
        row->by_cosine[i] = between(lower_[0].by_cosine[i], lower_[1].by_cosine[i], fraction_);
    }
    row->mean = between(lower_[0].mean, lower_[1].mean, fraction_);
    lower_ = row.get();
    fraction_ = 0.0F;
    return row;
}

LayerEnergy LayerEnergies::mean() const {
    if (lower_ == nullptr) {
        return {1.0F, 1.0F, mean_schlick, 1.0F, mean_schlick};
    }
    const Entry entry =
        fraction_ > 0.0F ? between(lower_[0].mean, lower_[1].mean, fraction_) : lower_->mean;
    return {entry.scale, entry.single, entry.single_edge, 1.0F, entry.all_edge};
}

}  // namespace balcony::render
