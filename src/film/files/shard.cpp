// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/shard.hpp"

#include <algorithm>
#include <sstream>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "film/files/render_facts.hpp"
#include "film/files/sealed_file.hpp"
#include "film/sums/film_arrays.hpp"

namespace balcony::render {

namespace {

constexpr std::string_view shard_signature = "Balcony shard 1\n";

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

// ------------------------------------------------- what a film has besides arrays, as facts

std::string numbers_text(std::initializer_list<double> numbers) {
    return fmt::format("{}", fmt::join(numbers, " "));
}

// Up to the first that cannot be read.
std::vector<double> numbers_of(std::string_view text) {
    std::vector<double> numbers;
    std::istringstream stream{std::string(text)};
    for (double number = 0.0; stream >> number;) {
        numbers.push_back(number);
    }
    return numbers;
}

// `count` sizes of pictures; nothing if the text is damaged.
std::optional<std::vector<std::size_t>> sizes_of(std::string_view text, std::size_t count) {
    constexpr double largest = 1 << 20;
    std::vector<std::size_t> sizes;
    for (const double number : numbers_of(text)) {
        if (!(number >= 0.0 && number <= largest)) {
            return std::nullopt;
        }
        sizes.push_back(static_cast<std::size_t>(number));
    }
    return sizes.size() == count ? std::optional(sizes) : std::nullopt;
}

RenderFacts properties_of(const Film& film) {
    const auto at = [](std::size_t number) { return static_cast<double>(number); };
    RenderFacts facts{{"size", numbers_text({at(film.width), at(film.height)})},
                      {"window", numbers_text({at(film.window.x), at(film.window.y),
                                               at(film.window.width), at(film.window.height)})},
                      {"ambient", numbers_text({film.ambient.x, film.ambient.y, film.ambient.z})},
                      {"data layers", film.layers ? "yes" : "no"}};
    if (film.background) {
        facts.push_back({"background", numbers_text({film.background->x, film.background->y,
                                                     film.background->z})});
    }
    for (const LayerInfo& layer : layers()) {
        if (film.layer_set.contains(layer.id)) {
            facts.push_back({"layer", std::string(layer.name)});
        }
    }
    const auto add_names = [&facts](const char* kind, const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            facts.push_back({kind, name});
        }
    };
    add_names("object", film.objects);
    add_names("material", film.materials);
    add_names("picture layer", film.picture_layers);
    return facts;
}

std::optional<Color3f> color_of(std::string_view text) {
    const std::vector<double> numbers = numbers_of(text);
    return numbers.size() == 3 ? std::optional(Color3f(static_cast<float>(numbers[0]),
                                                       static_cast<float>(numbers[1]),
                                                       static_cast<float>(numbers[2])))
                               : std::nullopt;
}

void add_layer(Film& film, std::string_view name) {
    for (const LayerInfo& layer : layers()) {
        if (layer.name == name) {
            film.layer_set.insert(layer.id);
        }
    }
}

// A film without arrays; nothing if the facts are damaged.
std::optional<Film> film_with(const RenderFacts& properties) {
    Film film;
    for (const auto& [name, value] : properties) {
        if (name == "size") {
            const auto size = sizes_of(value, 2);
            film.width = size ? size->at(0) : 0;
            film.height = size ? size->at(1) : 0;
        } else if (name == "window") {
            const auto window = sizes_of(value, 4);
            film.window =
                window ? Region{(*window)[0], (*window)[1], (*window)[2], (*window)[3]} : Region{};
        } else if (name == "ambient") {
            film.ambient = color_of(value).value_or(Color3f(0.0F));
        } else if (name == "background") {
            film.background = color_of(value);
        } else if (name == "data layers" && value == "yes") {
            film.layers.emplace();
        } else if (name == "layer") {
            add_layer(film, value);
        } else if (name == "object") {
            film.objects.push_back(value);
        } else if (name == "material") {
            film.materials.push_back(value);
        } else if (name == "picture layer") {
            film.picture_layers.push_back(value);
        }
    }
    const Region& window = film.window;
    const bool sound = window.size() > 0 && window.x + window.width <= film.width &&
                       window.y + window.height <= film.height;
    return sound ? std::optional(std::move(film)) : std::nullopt;
}

// ------------------------------------------------------------------------------- the file

std::string name_of(const Shard& shard) {
    return fmt::format("{}/{}", shard.index + 1, shard.count);
}

Diagnostic damaged_shard(const fs::path& file) {
    return error(fmt::format("'{}' is damaged or no shard of a picture", file.string()), {},
                 "render that shard again");
}

std::optional<Shard> shard_of(std::string_view text) {
    const std::vector<double> numbers = numbers_of(text);
    const bool sound = numbers.size() == 2 && numbers[0] >= 0.0 && numbers[0] < numbers[1] &&
                       numbers[1] <= static_cast<double>(max_shards);
    return sound ? std::optional(Shard{static_cast<std::size_t>(numbers[0]),
                                       static_cast<std::size_t>(numbers[1])})
                 : std::nullopt;
}

// The beginning of a shard, and its film without arrays.
struct OpenShard {
    ShardHeading heading;
    RenderFacts properties;
    Film film;
};

std::optional<OpenShard> open_shard(SealedReader& input) {
    const auto own = input.read_beginning(shard_signature);
    const auto shard = own && !own->empty() ? shard_of(own->front().value) : std::nullopt;
    const auto facts = input.read_facts();
    const auto output = input.read_facts();
    const auto properties = input.read_facts();
    if (!shard || !facts || !output || !properties) {
        return std::nullopt;
    }
    auto film = film_with(*properties);
    // A damaged size would need memory that no file of this size describes.
    const std::size_t most = input.rest() / sizeof(Color4d) + tile_width * tile_height;
    if (!film || film->window.size() / shard->count > most) {
        return std::nullopt;
    }
    return OpenShard{{*shard, *facts, *output}, *properties, std::move(*film)};
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
    return fits && input.ends_with_hash();
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
        fmt::format("{} of {} shards missing: {}", count, found.size(), fmt::join(missing, ", ")),
        {}, fmt::format("render with --shard {}", missing.front()));
}

}  // namespace

std::vector<std::uint32_t> passes_of(const Film& film, const Shard& shard, std::uint32_t passes) {
    std::vector<std::uint32_t> all(film.tile_count(), 0);
    for (std::size_t tile = 0; tile < all.size(); ++tile) {
        all[tile] = is_own(film, shard, tile) ? passes : 0;
    }
    return all;
}

Diagnostics write_shard(const Film& film, const Shard& shard, const RenderFacts& facts,
                        const RenderFacts& output, const fs::path& file) {
    SealedWriter writer("shard", file);
    writer.write(std::as_bytes(std::span(shard_signature)));
    const RenderFacts own_facts{{"shard", numbers_text({static_cast<double>(shard.index),
                                                        static_cast<double>(shard.count)})}};
    for (const RenderFacts& part : {own_facts, facts, output, properties_of(film)}) {
        writer.write_part(std::as_bytes(std::span<const char>(text_of(part))));
    }
    const OwnParts own = own_parts(film, shard);
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
    auto opened = open_shard(input);
    return opened ? Result<ShardHeading>(std::move(opened->heading))
                  : Result<ShardHeading>(damaged_shard(file));
}

Result<Film> merge_shards(std::span<const fs::path> files) {
    std::optional<OpenShard> merged;
    std::vector<const fs::path*> found;
    for (const fs::path& file : files) {
        SealedReader input(file);
        auto opened = open_shard(input);
        if (!opened) {
            return damaged_shard(file);
        }
        if (!merged) {
            found.resize(opened->heading.shard.count, nullptr);
            merged = opened;
        }
        const Shard& shard = opened->heading.shard;
        const auto refused = [&](const std::string& why) {
            return error(fmt::format("'{}' and '{}' do not belong together: {}",
                                     files.front().string(), file.string(), why),
                         {}, "merge the shards of one render");
        };
        if (shard.count != found.size()) {
            return refused(fmt::format("one is {}, the other {}", name_of(merged->heading.shard),
                                       name_of(shard)));
        }
        std::string why = difference(merged->heading.facts, opened->heading.facts);
        if (why.empty() && text_of(merged->properties) != text_of(opened->properties)) {
            why = "the objects, layers or lights differ";
        }
        if (!why.empty()) {
            return refused(why);
        }
        if (found[shard.index] != nullptr) {
            return refused(fmt::format("both are shard {}", name_of(shard)));
        }
        found[shard.index] = &file;
        if (!read_arrays(input, shard, merged->film)) {
            return damaged_shard(file);
        }
    }
    if (!merged) {
        return error("there is no shard to merge", {}, "name the files of all shards");
    }
    if (std::find(found.begin(), found.end(), nullptr) != found.end()) {
        return missing_shards(found);
    }
    return std::move(merged->film);
}

}  // namespace balcony::render
