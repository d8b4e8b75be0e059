// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "data/files.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "data/built_in_files.hpp"

namespace balcony::data {

namespace fs = std::filesystem;

namespace {

const BuiltInFile* find_built_in_file(std::string_view name) {
    const std::span<const BuiltInFile> all = embedded_files();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [name](const BuiltInFile& file) { return file.name == name; });
    return found == all.end() ? nullptr : &*found;
}

Diagnostic not_found(std::string_view name, const std::optional<fs::path>& folder) {
    std::vector<std::string> known;
    if (folder) {
        known = names_in((*folder / name).parent_path());
    }
    const std::vector<std::string> built_in = built_in_files();
    known.insert(known.end(), built_in.begin(), built_in.end());
    const fs::path path = folder ? (*folder / name).lexically_normal() : fs::path();
    std::string message =
        folder ? fmt::format("there is no file and no built-in file named '{}'", path.string())
               : fmt::format("there is no built-in file named '{}'", name);
    const std::string wanted = fs::path(name).filename().string();
    auto nearest = nearest_name(wanted, known);
    // vase for vase.obj.
    const auto same_stem = std::find_if(known.begin(), known.end(), [&](const std::string& one) {
        return fs::path(one).stem() == wanted;
    });
    if (!nearest && same_stem != known.end()) {
        nearest = *same_stem;
    }
    return error(std::move(message), {},
                 nearest ? fmt::format("did you mean '{}'?", *nearest)
                         : "the search folder is that of the camera file");
}

}  // namespace

std::vector<std::string> built_in_files() {
    std::vector<std::string> names;
    for (const BuiltInFile& file : embedded_files()) {
        names.emplace_back(file.name);
    }
    return names;
}

Result<File> find_file(std::string_view name, const std::optional<fs::path>& folder) {
    if (name.empty()) {
        return error("this file name is empty", {}, "name a file in the folder of the camera file");
    }
    std::error_code failure;
    if (folder) {
        fs::path path = (*folder / name).lexically_normal();
        if (fs::exists(fs::symlink_status(path, failure))) {
            const auto fault = not_a_file(path, fmt::format("'{}'", path.string()));
            return fault ? Result<File>(*fault) : Result<File>(File::on_disk(path));
        }
    }
    if (const BuiltInFile* built_in = find_built_in_file(name)) {
        return File::in_memory(fmt::format("standard/{}", name), name, built_in->bytes);
    }
    return not_found(name, folder);
}

Result<std::uintmax_t> size_of(const File& file) {
    if (file.bytes) {
        return std::uintmax_t{file.bytes->size()};
    }
    std::error_code failure;
    const std::uintmax_t size = fs::file_size(file.path, failure);
    return failure ? Result<std::uintmax_t>(cannot_read(file)) : Result<std::uintmax_t>(size);
}

Result<std::string> read_bytes(const File& file, std::size_t largest) {
    const Result<std::uintmax_t> size = size_of(file);
    if (!size) {
        return size.diagnostics;
    }
    if (*size > largest) {
        return error(fmt::format("'{}' is larger than {} MB", file.name, largest / 1'000'000), {},
                     "check that it is the right file");
    }
    if (file.bytes) {
        return std::string(file.bytes->begin(), file.bytes->end());
    }
    std::string text(static_cast<std::size_t>(*size), '\0');
    std::ifstream stream(file.path, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (stream.gcount() != static_cast<std::streamsize>(text.size())) {
        return cannot_read(file);
    }
    return text;
}

Result<std::shared_ptr<const SourceText>> read_text(const File& file, std::size_t largest,
                                                    std::string_view remedy) {
    Result<std::string> bytes = read_bytes(file, largest);
    if (!bytes) {
        return bytes.diagnostics;
    }
    std::string_view text = *bytes;
    if (std::optional<Diagnostic> fault = begin_text(text, fmt::format("'{}'", file.name))) {
        return *std::move(fault);
    }
    if (const std::size_t zero = text.find('\0'); zero != text.npos) {
        return error(
            fmt::format("'{}' is not a text file: its byte {} is zero", file.name, zero + 1), {},
            std::string(remedy));
    }
    return std::make_shared<const SourceText>(file.name, std::move(*bytes));
}

Diagnostic cannot_read(const File& file) {
    return error(fmt::format("'{}' cannot be read", file.name), {}, "check its read permission");
}

}  // namespace balcony::data
