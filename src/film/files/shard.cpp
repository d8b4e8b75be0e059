// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/shard.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "film/files/sealed_file.hpp"
#include "film/sums/film_arrays.hpp"

namespace balcony::render {

namespace {

bool is_own(const Film& film, const Shard& shard, std::size_t tile) {
    const Region region = film.tile(tile);
    return (region.x / tile_width + region.y / tile_height) % shard.count == shard.index;
}

// The indices of a shard's pixels in the vectors of a film, and of its tiles.
struct OwnParts {
    std::vector<std::size_t> pixels;
    std::vector<std::size_t> tiles;
};

OwnParts own_parts(const Film& film, const Shard& shard) {
    OwnParts own;
    for (std::size_t tile = 0; tile < film.tile_count(); ++tile) {
        if (!is_own(film, shard, tile)) {
            continue;
        }
        own.tiles.push_back(tile);
        const Region region = film.tile(tile);
        for (std::size_t y = region.y; y < region.y + region.height; ++y) {
            for (std::size_t x = region.x; x < region.x + region.width; ++x) {
                if (film.window.contains(x, y)) {
                    own.pixels.push_back(film.index(x, y));
                }
            }
        }
    }
    return own;
}

// Calls visit(array, indices) for all arrays of a film, with the indices of the elements that
// belong to a shard; null for an array that does not consist of pixels or tiles.
template <class AnyFilm, class Visit>
void for_each_part(AnyFilm& film, const OwnParts& own, const Visit& visit) {
    for_each_array(film, [&](auto& array) {
        const auto* const address = static_cast<const void*>(&array);
        const bool tiles = address == static_cast<const void*>(&film.passes);
        constexpr bool alone = !requires { array.capacity(); };
        visit(array, tiles ? &own.tiles : alone ? nullptr : &own.pixels);
    });
}

// ------------------------------------------------------------------------------- the file

constexpr std::string_view shard_kind = "shard";

std::string name_of(const Shard& shard) {
    return fmt::format("{}/{}", shard.index + 1, shard.count);
}

Diagnostic not_a_shard(const fs::path& file, std::string_view reason) {
    return error(Kind::input, fmt::format("'{}' cannot be merged: {}", file.string(), reason),
                 "render that shard again");
}

// What is written of a heading, and of a film besides its arrays.
auto members_of_shard(auto& heading) {
    auto& finish = heading.finish;
    return std::tie(heading.shard, heading.facts, heading.frame, finish.output, finish.exposure,
                    finish.view, finish.dither, finish.dpi, finish.denoiser);
}
auto properties_of(auto& film) {
    return std::tie(film.width, film.height, film.window, film.background, film.ambient,
                    film.layer_set, film.objects, film.materials, film.picture_layers);
}

// The beginning of a shard, and its film without arrays.
struct OpenShard {
    ShardHeading heading;
    Film film;
};

// Whether the sizes are possible, and of a film that a file with so many bytes may be a part of.
bool is_sound(const OpenShard& opened, std::uintmax_t bytes) {
    const Shard& shard = opened.heading.shard;
    const Film& film = opened.film;
    const Region& window = film.window;
    return shard.index < shard.count && shard.count <= max_shards &&
           std::max(film.width, film.height) <= max_film_side &&
           is_part(window, film.width, film.height) &&
           window.size() / shard.count <= bytes / sizeof(Color4d) + tile_width * tile_height;
}

Result<OpenShard> open_shard(SealedReader& input, const fs::path& file) {
    if (const auto missing = not_a_file(file, fmt::format("'{}'", file.string()))) {
        return *missing;
    }
    if (const auto why = input.begins_otherwise(shard_kind)) {
        return not_a_shard(file, *why);
    }
    OpenShard opened;
    bool has_layers = false;
    if (!input.read_fields(std::tuple_cat(members_of_shard(opened.heading),
                                          properties_of(opened.film), std::tie(has_layers))) ||
        !input.is_sealed() || !is_sound(opened, input.rest())) {
        return not_a_shard(file, damaged(shard_kind));
    }
    if (has_layers) {
        opened.film.layers.emplace();
    }
    return opened;
}

// Reads the elements of one array that belong to a shard into the array of the whole film, which
// gets its size with the first shard.
template <class Array>
bool read_part(SealedReader& input, Array& array, const std::vector<std::size_t>* own,
               std::size_t all) {
    using Element = std::remove_reference_t<decltype(array[0])>;
    if (own == nullptr) {
        const auto bytes = std::as_writable_bytes(std::span(array));
        return input.read_size() == bytes.size() && input.read(bytes);
    }
    const auto size = input.read_size();
    if (!size || (*size != 0 && *size != own->size() * sizeof(Element))) {
        return false;
    }
    std::vector<Element> part(*size / sizeof(Element));
    if (!input.read(std::as_writable_bytes(std::span(part)))) {
        return false;
    }
    if (part.empty()) {
        return true;
    }
    if constexpr (requires { array.resize(all, zero<Element>()); }) {
        array.resize(all, zero<Element>());
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
        array[(*own)[i]] = part[i];
    }
    return true;
}

bool read_arrays(SealedReader& input, const Shard& shard, Film& film) {
    const OwnParts own = own_parts(film, shard);
    bool fits = true;
    for_each_part(film, own, [&](auto& array, const std::vector<std::size_t>* parts) {
        const std::size_t all = parts == &own.tiles ? film.tile_count() : film.window.size();
        fits = fits && read_part(input, array, parts, all);
    });
    return fits && input.ends_sealed();
}

// Which shards there are not, for a message: "2/5 and 4/5".
Diagnostic missing_shards(const std::vector<const fs::path*>& found) {
    std::vector<std::string> missing;
    constexpr std::size_t most = 10;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] == nullptr) {
            missing.push_back(name_of({i, found.size()}));
        }
    }
    const std::size_t count = missing.size();
    if (count > most) {
        missing.resize(most);
        missing.push_back("...");
    }
    return error(
        Kind::input,
        fmt::format("{} of {} shards missing: {}", count, found.size(), fmt::join(missing, ", ")),
        fmt::format("render with --shard {}", missing.front()));
}

}  // namespace

std::vector<std::uint32_t> passes_of(const Film& film, const Shard& shard, std::uint32_t passes) {
    std::vector<std::uint32_t> all(film.tile_count(), 0);
    for (std::size_t tile = 0; tile < all.size(); ++tile) {
        all[tile] = is_own(film, shard, tile) ? passes : 0;
    }
    return all;
}

Diagnostics write_shard(const Film& film, const ShardHeading& heading, const fs::path& file) {
    SealedWriter writer(shard_kind, file);
    const bool has_layers = film.layers.has_value();
    writer.write_fields(
        std::tuple_cat(members_of_shard(heading), properties_of(film), std::tie(has_layers)));
    writer.seal();
    const OwnParts own = own_parts(film, heading.shard);
    for_each_part(film, own, [&](const auto& array, const std::vector<std::size_t>* parts) {
        if (parts == nullptr || array.empty()) {
            writer.write_part(std::as_bytes(std::span(array)));
            return;
        }
        std::vector<std::remove_cvref_t<decltype(array[0])>> part;
        part.reserve(parts->size());
        for (const std::size_t index : *parts) {
            part.push_back(array[index]);
        }
        writer.write_part(std::as_bytes(std::span(part)));
    });
    return writer.commit();
}

Result<ShardHeading> read_shard_heading(const fs::path& file) {
    SealedReader input(file);
    auto opened = open_shard(input, file);
    return opened ? Result<ShardHeading>(std::move(opened->heading))
                  : Result<ShardHeading>(std::move(opened.diagnostics));
}

bool is_whole_shard(const fs::path& file) {
    SealedReader input(file);
    Result<OpenShard> opened = open_shard(input, file);
    bool fits = static_cast<bool>(opened);
    if (fits) {
        for_each_array(opened->film, [&](const auto&) {
            const auto size = fits ? input.read_size() : std::nullopt;
            fits = size && input.pass_over(*size);
        });
    }
    return fits && input.is_at_seal();
}

Result<Film> merge_shards(std::span<const fs::path> files) {
    std::optional<OpenShard> merged;
    std::vector<const fs::path*> found;
    for (const fs::path& file : files) {
        SealedReader input(file);
        Result<OpenShard> opened = open_shard(input, file);
        if (!opened) {
            return std::move(opened.diagnostics);
        }
        if (!merged) {
            found.resize(opened->heading.shard.count, nullptr);
            merged = *opened;
        }
        const Shard& shard = opened->heading.shard;
        const auto other_than_first = [&](const std::string& why) {
            return error(Kind::input,
                         fmt::format("'{}' and '{}' do not belong together: {}",
                                     files.front().string(), file.string(), why),
                         "merge the shards of one render");
        };
        if (shard.count != found.size()) {
            return other_than_first(fmt::format("one is {}, the other {}",
                                                name_of(merged->heading.shard), name_of(shard)));
        }
        if (merged->heading.frame != opened->heading.frame) {
            return other_than_first("they are of two frames");
        }
        std::string why = difference(merged->heading.facts, opened->heading.facts);
        if (why.empty() && properties_of(merged->film) != properties_of(opened->film)) {
            why = "the size, objects, layers or lights differ";
        }
        if (!why.empty()) {
            return other_than_first(why);
        }
        if (found[shard.index] != nullptr) {
            return other_than_first(fmt::format("both are shard {}", name_of(shard)));
        }
        found[shard.index] = &file;
        if (!read_arrays(input, shard, merged->film)) {
            return not_a_shard(file, damaged(shard_kind));
        }
    }
    if (!merged) {
        return error(Kind::usage, "there is no shard to merge", "name the files of all shards");
    }
    if (std::find(found.begin(), found.end(), nullptr) != found.end()) {
        return missing_shards(found);
    }
    return std::move(merged->film);
}

}  // namespace balcony::render
