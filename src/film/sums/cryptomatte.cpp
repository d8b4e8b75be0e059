// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/sums/cryptomatte.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

namespace balcony::render {

namespace {

std::string name_of(std::span<const std::string> names, std::uint32_t id) {
    const bool named = id <= names.size() && !names[id - 1].empty();
    return named ? names[id - 1] : fmt::format("{}", id);
}

std::uint32_t byte_at(std::string_view text, std::size_t i) {
    return static_cast<unsigned char>(text[i]);
}

// A text in JSON.
std::string json_text(std::string_view text) {
    std::string made = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            made += '\\';
            made += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            made += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            made += c;
        }
    }
    return made + '"';
}

}  // namespace

std::uint32_t matte_hash(std::string_view name) {
    constexpr std::uint32_t factor_1 = 0xcc9e2d51;
    constexpr std::uint32_t factor_2 = 0x1b873593;
    const auto mixed = [](std::uint32_t word) { return std::rotl(word * factor_1, 15) * factor_2; };
    std::uint32_t hash = 0;
    std::size_t i = 0;
    for (; i + 4 <= name.size(); i += 4) {
        const std::uint32_t word = byte_at(name, i) | byte_at(name, i + 1) << 8 |
                                   byte_at(name, i + 2) << 16 | byte_at(name, i + 3) << 24;
        hash = std::rotl(hash ^ mixed(word), 13) * 5 + 0xe6546b64;
    }
    std::uint32_t rest = 0;
    for (std::size_t last = name.size(); last > i; --last) {
        rest = rest << 8 | byte_at(name, last - 1);
    }
    hash ^= mixed(rest);
    hash ^= static_cast<std::uint32_t>(name.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6b;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35;
    return hash ^ hash >> 16;
}

float matte_float(std::uint32_t hash) {
    const std::uint32_t exponent = hash >> 23 & 255;
    return std::bit_cast<float>(exponent == 0 || exponent == 255 ? hash ^ std::uint32_t{1} << 23
                                                                 : hash);
}

void Matte::add(std::uint32_t id, float coverage) {
    const auto same = std::find_if(entries.begin(), entries.end(), [id](const Entry& entry) {
        return entry.id == id || entry.id == 0;
    });
    if (same != entries.end()) {
        same->id = id;
        same->coverage += coverage;
        return;
    }
    const auto least =
        std::min_element(entries.begin(), entries.end(),
                         [](const Entry& a, const Entry& b) { return a.coverage < b.coverage; });
    if (least->coverage <= coverage) {
        *least = {id, coverage};
    }
}

void read_matte(const Matte& matte, std::span<const std::string> names, std::uint32_t samples,
                float* channels) {
    auto ranked = matte.entries;
    std::stable_sort(
        ranked.begin(), ranked.end(),
        [](const Matte::Entry& a, const Matte::Entry& b) { return a.coverage > b.coverage; });
    for (const Matte::Entry& entry : ranked) {
        const bool used = entry.id != 0 && samples > 0;
        *channels++ = used ? matte_float(matte_hash(name_of(names, entry.id))) : 0.0F;
        *channels++ = used ? entry.coverage / static_cast<float>(samples) : 0.0F;
    }
}

std::map<std::string, std::string> matte_attributes(std::string_view layer,
                                                    std::span<const std::string> names) {
    const std::string prefix =
        fmt::format("cryptomatte/{}/", fmt::format("{:08x}", matte_hash(layer)).substr(0, 7));
    std::map<std::string, std::uint32_t> bits_of_names;
    for (std::uint32_t id = 1; id <= names.size(); ++id) {
        const std::string name = name_of(names, id);
        bits_of_names[name] = std::bit_cast<std::uint32_t>(matte_float(matte_hash(name)));
    }
    std::string manifest;
    for (const auto& [name, bits] : bits_of_names) {
        manifest +=
            fmt::format("{}{}:\"{:08x}\"", manifest.empty() ? "{" : ",", json_text(name), bits);
    }
    return {{prefix + "name", std::string(layer)},
            {prefix + "hash", "MurmurHash3_32"},
            {prefix + "conversion", "uint32_to_float32"},
            {prefix + "manifest", manifest.empty() ? "{}" : manifest + "}"}};
}

}  // namespace balcony::render
