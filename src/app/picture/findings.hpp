// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/inputs/loaded.hpp"
#include "app/picture/finished_picture.hpp"
#include "balcony/app.hpp"

namespace balcony::app {

/// The part of a picture that a film shows, and what is behind it.
struct Shown {
    render::Region window;
    bool has_background = false;
};

/// Adds the facts of a run to the report, and warnings about what is missing in the picture.
void describe(Report& report, const Loaded& loaded, const camera::Picture& picture,
              const Shown& shown, const render::Summary& summary);

/// Warns of layers whose rays meet nothing, with the reason, or start in closed objects. The
/// picture has this size in pixels.
void describe_sight(Report& report, const Loaded& loaded, const camera::Picture& picture,
                    std::pair<std::size_t, std::size_t> size, const std::stop_token& stop);

/// Sets the objects that the rays of a picture of this size start in and pass by the rule, in the
/// settings that are loaded.
[[nodiscard]] Diagnostics pass_starts(InsideRule rule, const camera::Picture& picture,
                                      std::pair<std::size_t, std::size_t> size, Loaded& loaded,
                                      const std::stop_token& stop);

/// The numbers of samples of adaptive sampling; nothing without it.
[[nodiscard]] std::optional<SampleRange> sample_range(const render::Film& film);

}  // namespace balcony::app
