// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "scene/import.hpp"

namespace balcony::scene {

namespace fs = std::filesystem;

void Import::warn(std::string message, std::string remedy) {
    if (adds_warnings()) {
        diagnostics.push_back(warning(std::move(message), {}, std::move(remedy)));
    } else {
        ++further_warnings;
    }
}

std::string Import::advice_on(const fs::path& missing) const {
    return adds_warnings() ? similar_file(missing) : "";
}

std::vector<std::uint8_t> Import::bytes() const {
    return given ? std::vector<std::uint8_t>(given->begin(), given->end()) : read_bytes(file);
}

std::string in_quotes(std::string_view name) {
    constexpr std::size_t longest = 80;
    std::string shown;
    for (const char byte : name.substr(0, longest)) {
        const auto code = static_cast<unsigned char>(byte);
        shown += code < 0x20 || code == 0x7f ? '?' : byte;
    }
    if (name.size() > longest) {
        // Do not cut a character in half.
        while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80U) != 0) {
            shown.pop_back();
        }
        shown += "...";
    }
    return "'" + shown + "'";
}

std::string counted(std::size_t count, std::string_view noun) {
    const bool sibilant = noun.ends_with('x') || noun.ends_with("sh");
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : sibilant ? "es" : "s");
}

std::string similar_file(const fs::path& file) {
    std::error_code code;
    const fs::path directory = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::vector<std::string> names;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end;
         entry.increment(code)) {
        names.push_back(entry->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    const auto near = nearest_name(file.filename().string(), names);
    return near ? fmt::format("did you mean {}?", in_quotes((file.parent_path() / *near).string()))
                : "check its name and its folder";
}

std::vector<std::uint8_t> read_bytes(const fs::path& file) {
    const std::string name = in_quotes(file.string());
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) {
        throw ReadError{error(fmt::format("there is no file {}", name), {}, similar_file(file))};
    }
    if (fs::is_directory(status)) {
        throw ReadError{error(fmt::format("{} is a directory", name), {}, "name a file in it")};
    }
    if (!fs::is_regular_file(status)) {
        throw ReadError{
            error(fmt::format("{} is not a regular file", name), {}, "save its output to a file")};
    }
    const std::uintmax_t size = fs::file_size(file, code);
    std::ifstream stream(file, std::ios::binary);
    if (code || !stream) {
        throw ReadError{
            error(fmt::format("{} cannot be opened", name), {}, "check its read permission")};
    }
    std::vector<std::uint8_t> bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (stream.gcount() != static_cast<std::streamsize>(size)) {
        throw ReadError{error(fmt::format("{} could not be read completely", name))};
    }
    return bytes;
}

fs::path Import::beside(const fs::path& other, std::string_view written) {
    if (written.find("://") != std::string_view::npos) {
        throw PartError{fmt::format("{} is an address, which is not opened", in_quotes(written)),
                        "download it into the folder of the scene, and name the file"};
    }
    std::string portable(written);
    std::replace(portable.begin(), portable.end(), '\\', '/');
    fs::path named = (other.parent_path() / fs::path(portable)).lexically_normal();
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const fs::path inside = named.lexically_relative(folder.lexically_normal());
    if (inside.empty() || *inside.begin() == "..") {
        throw PartError{
            fmt::format("{} is outside the folder of the scene", in_quotes(named.string())),
            "copy it into that folder, and name it there"};
    }
    return scene.files.emplace_back(std::move(named));
}

}  // namespace balcony::scene
