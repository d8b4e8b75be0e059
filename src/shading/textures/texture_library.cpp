// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/texture_library.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include <fmt/format.h>

#include "base/parallel_for.hpp"
#include "base/shared_progress.hpp"

namespace balcony::render {

namespace {

// A texture of the scene as a material uses it.
struct Use {
    std::size_t texture = 0;
    TextureEncoding encoding = TextureEncoding::linear;
    auto operator<=>(const Use&) const = default;
};

// Each once, in the order of the textures.
std::vector<Use> uses_of(const scene::Scene& scene) {
    std::vector<Use> uses;
    for (const scene::Material& material : scene.materials) {
        for (const auto texture : scene::texture_uses) {
            const scene::TextureUse& use = material.*texture;
            if (use.valid()) {
                uses.push_back({use.index.value(), use.encoding});
            }
        }
    }
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    return uses;
}

// The use of a texture, and the memory that it takes as a whole.
struct Sized {
    Use use;
    std::size_t bytes = 0;
};

// Which textures fit: all, or the smaller ones within a part of the memory. The textures that are
// held come first. Returns their number.
std::size_t choose_held(std::vector<Sized>& textures, std::size_t memory, std::size_t part) {
    std::stable_sort(textures.begin(), textures.end(),
                     [](const Sized& a, const Sized& b) { return a.bytes < b.bytes; });
    const auto fitting = [&](std::size_t limit) {
        std::size_t count = 0;
        for (std::size_t left = limit; count < textures.size() && textures[count].bytes <= left;
             ++count) {
            left -= textures[count].bytes;
        }
        return count;
    };
    return fitting(memory) == textures.size() ? textures.size() : fitting(part);
}

Diagnostic unreadable(const scene::Texture& texture, const Diagnostic& reason) {
    return warning(fmt::format("texture '{}' cannot be read{}{}", texture.name,
                               reason.message.empty() ? "" : ": ", reason.message),
                   {},
                   reason.remedy.empty() ? "its material is rendered with its constant factors"
                                         : reason.remedy);
}

Diagnostic not_finite(const scene::Texture& texture) {
    return warning(fmt::format("texture '{}' contains values that are not finite; they are read as "
                               "0",
                               texture.name),
                   {}, "export the image again");
}

std::optional<Diagnostic> problem_of(const HeldTexture& held) {
    if (!held.was_read()) {
        return std::nullopt;
    }
    return held.failure()    ? std::optional(unreadable(held.texture(), *held.failure()))
           : held.repaired() ? std::optional(not_finite(held.texture()))
                             : std::nullopt;
}

void decode(const std::vector<const HeldTexture*>& held, const std::stop_token& stop,
            const PartDone& progress) {
    std::atomic<std::size_t> done = 0;
    SharedProgress shared(progress);
    parallel_for(held.size(), [&](std::size_t i) {
        held[i]->decode(stop);
        shared.reach(static_cast<double>(++done) / static_cast<double>(held.size()));
    });
}

}  // namespace

TextureLibrary::TextureLibrary(const scene::Scene& scene, std::size_t memory, Diagnostics& warnings,
                               const std::stop_token& stop)
    : entries_(scene.textures.size()) {
    std::vector<Sized> textures;
    for (const Use& use : uses_of(scene)) {
        if (stop.stop_requested()) {
            break;
        }
        const scene::Texture& texture = scene.textures[use.texture];
        const Result<TextureReader> opened = TextureReader::open(texture, use.encoding);
        if (opened) {
            textures.push_back({use, MipPyramid::bytes(*opened)});
        } else {
            warnings.push_back(unreadable(texture, opened.diagnostics.front()));
        }
    }
    const std::size_t for_file = memory / 4;
    const std::size_t held = choose_held(textures, memory, memory - for_file);
    all_fit_ = held == textures.size();
    file_ = std::make_unique<SpillFile>(for_file);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const Use& use = textures[i].use;
        const scene::Texture& texture = scene.textures[use.texture];
        Entry& entry = entries_[use.texture][static_cast<std::size_t>(use.encoding)];
        entry.held = std::make_unique<const HeldTexture>(texture, use.encoding,
                                                         i < held ? nullptr : file_.get());
        held_bytes_ += i < held ? textures[i].bytes : 0;
    }
}

void TextureLibrary::read_all(const std::stop_token& stop, const PartDone& progress) const {
    std::vector<const HeldTexture*> held;
    for (const std::array<Entry, 2>& pair : entries_) {
        for (const Entry& entry : pair) {
            if (entry.held && entry.held->in_memory()) {
                held.push_back(entry.held.get());
            }
        }
    }
    decode(held, stop, progress);
}

void TextureLibrary::read(std::span<const scene::Material* const> materials,
                          const std::stop_token& stop) const {
    std::vector<const HeldTexture*> used;
    for (const scene::Material* const material : materials) {
        for (const auto texture : scene::texture_uses) {
            const scene::TextureUse& use = material->*texture;
            if (use.valid()) {
                const Entry& entry =
                    entries_[use.index.value()][static_cast<std::size_t>(use.encoding)];
                if (entry.held) {
                    used.push_back(entry.held.get());
                }
            }
        }
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    decode(used, stop, {});
}

const MipPyramid* TextureLibrary::pyramid(scene::TextureIndex texture,
                                          TextureEncoding encoding) const {
    if (!texture.valid()) {
        return nullptr;
    }
    const Entry& entry = entries_[texture.value()][static_cast<std::size_t>(encoding)];
    return entry.held ? entry.held->pyramid() : nullptr;
}

Imath::Color4f TextureLibrary::look_up(scene::TextureIndex texture, TextureEncoding encoding,
                                       const TextureFootprint& footprint) const {
    const MipPyramid* const found = pyramid(texture, encoding);
    return found != nullptr ? found->mean(footprint) : Imath::Color4f(1.0F, 1.0F, 1.0F, 1.0F);
}

void TextureLibrary::look_up(scene::TextureIndex texture, TextureEncoding encoding,
                             const texture_lanes::Footprints& footprints,
                             LaneVectors& colors) const {
    if (const MipPyramid* const found = pyramid(texture, encoding)) {
        found->set_means(footprints, colors);
    } else {
        colors.fill(0, lane_count, Imath::V3f(1.0F));
    }
}

Diagnostics TextureLibrary::warnings() const {
    Diagnostics found;
    if (file_->has_failed() && !file_reported_.exchange(true)) {
        found.push_back(*file_->failure());
    }
    for (const std::array<Entry, 2>& pair : entries_) {
        for (const Entry& entry : pair) {
            const std::optional<Diagnostic> problem =
                entry.held ? problem_of(*entry.held) : std::nullopt;
            if (problem && !entry.reported.exchange(true)) {
                found.push_back(*problem);
            }
        }
    }
    return found;
}

}  // namespace balcony::render
