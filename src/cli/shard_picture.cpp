// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/shard_picture.hpp"

#include <fmt/format.h>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

std::optional<render::Shard> read_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        return std::nullopt;
    }
    const auto number = number_of<std::size_t>(text.substr(0, slash));
    const auto count = number_of<std::size_t>(text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count || *count > render::max_shards) {
        return std::nullopt;
    }
    return render::Shard{*number - 1, *count};
}

std::filesystem::path shard_file(const std::filesystem::path& picture, const render::Shard& shard) {
    std::filesystem::path file = picture;
    file += fmt::format(".shard-{}-of-{}", shard.index + 1, shard.count);
    return file;
}

render::RenderFacts output_facts(const RenderOptions& options,
                                 const std::filesystem::path& picture) {
    return {{"picture", picture.string()},
            {"exposure", options.exposure},
            {"view", options.view},
            {"dither", options.film.no_dither ? "no" : "yes"},
            {"denoiser", options.film.denoise ? options.film.denoiser : ""}};
}

MergedOutput merged_output(const render::RenderFacts& facts) {
    MergedOutput output;
    for (const auto& [name, value] : facts) {
        if (name == "picture") {
            output.picture = value;
        } else if (name == "exposure") {
            output.exposure = number_of<double>(value);
        } else if (name == "view") {
            output.view = render::find_view_transform(value).value_or(output.view);
        } else if (name == "dither") {
            output.dither = value != "no";
        } else if (name == "denoiser") {
            output.denoiser = render::find_denoiser(value);
        }
    }
    return output;
}

}  // namespace balcony::cli
