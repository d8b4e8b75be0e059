// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/read_source.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <initializer_list>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"
#include "balcony/scene.hpp"

namespace balcony::lang {

namespace fs = std::filesystem;

namespace {

bool ends_in(std::string_view ending, std::initializer_list<std::string_view> endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

std::optional<Diagnostic> not_a_camera_file(const fs::path& file, const std::string& name) {
    const std::string ending = ending_of(file);
    const auto scenes = scene::file_extensions();
    if (std::find(scenes.begin(), scenes.end(), ending) != scenes.end()) {
        return error(fmt::format("'{}' is a scene, not a camera file", name), {},
                     fmt::format("balcony info {} describes it; where a camera is meant, name a "
                                 "camera file or a built-in camera",
                                 name));
    }
    if (ends_in(ending, {".yml", ".yaml"})) {
        const std::string stem = file.stem().string();
        const bool is_word = !stem.empty() && std::isalpha(stem.front()) != 0 &&
                             std::all_of(stem.begin(), stem.end(), [](unsigned char c) {
                                 return c < 128 && (std::isalnum(c) != 0 || c == '_');
                             });
        return error(fmt::format("'{}' is a calibration, not a camera file", name), {},
                     fmt::format("write a file such as {0}.cam beside it, with camera {0} {{ eye "
                                 "opencv(\"{1}\") }}",
                                 is_word ? stem : "mine", file.filename().string()));
    }
    if (ends_in(ending, {".png", ".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".exr", ".hdr"})) {
        return error(fmt::format("'{}' is a picture, not a camera file", name), {},
                     "name a camera file or a built-in camera");
    }
    return std::nullopt;
}

Result<std::shared_ptr<const SourceText>> read_text(const fs::path& file) {
    return read_source(file, file.string(), {});
}

Result<std::shared_ptr<const SourceText>> read_source(const fs::path& file, const std::string& name,
                                                      const SourceSpan& asked) {
    if (std::optional<Diagnostic> fault = not_a_file(file, fmt::format("'{}'", name))) {
        fault->span = asked;
        return std::move(*fault);
    }
    if (std::optional<Diagnostic> other = not_a_camera_file(file, name)) {
        other->span = asked;
        return std::move(*other);
    }
    const auto too_large = [&] {
        return error(fmt::format("'{}' is larger than 1 MB, the maximum for camera files", name),
                     asked, "check that it is a camera file");
    };
    std::error_code failure;
    if (fs::file_size(file, failure) > max_file && !failure) {
        return too_large();
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text(max_file + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream.is_open() || stream.bad()) {
        Diagnostic unreadable =
            error(fmt::format("'{}' cannot be read", name), asked, "check its read permission");
        unreadable.kind = Kind::environment;
        return unreadable;
    }
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_file) {
        return too_large();
    }
    std::string_view begun = text;
    if (std::optional<Diagnostic> fault = begin_text(begun, fmt::format("'{}'", name))) {
        fault->span = asked;
        return std::move(*fault);
    }
    return std::make_shared<const SourceText>(name, std::move(text));
}

}  // namespace balcony::lang
