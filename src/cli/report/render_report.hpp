// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "balcony/render.hpp"
#include "cli/exit_code.hpp"
#include "cli/options/picture_output.hpp"

namespace balcony::cli {

/// What there is to say of a render, as text or JSON.
struct RenderReport {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics;
    nlohmann::json facts = nlohmann::json::object();
    std::string sentence;
    /// What a picture chose by itself, for another one that must look the same.
    double exposure = 0.0;
    render::Color3f ambient{0.0F};
    bool outdated = false;  ///< Stopped because a file changed.
};

void add(RenderReport& report, const Diagnostics& diagnostics);

/// The same report of a render that ends here, with the reasons.
[[nodiscard]] RenderReport failed(RenderReport report, ExitCode code,
                                  const Diagnostics& diagnostics = {});

/// Adds the facts of a run, and warnings about what is missing in the picture.
void describe(RenderReport& report, const PictureOutput& output, const camera::Picture& picture,
              const render::Film& film, const render::Summary& summary);

/// Warns of layers whose rays meet nothing, with the reason.
void describe_misses(RenderReport& report, const scene::Scene& scene,
                     const camera::Picture& picture, const render::Settings& settings,
                     const render::Film& film, const render::Summary& summary);

/// Warns if the film is transparent somewhere, but the format has no alpha and shows black there.
void warn_of_lost_alpha(RenderReport& report, const render::Film& film,
                        const PictureOutput& output);

[[nodiscard]] nlohmann::json json_of(const RenderReport& report);

}  // namespace balcony::cli
