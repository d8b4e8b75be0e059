// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/files.hpp"

#include "lang/syntax/parser.hpp"
#include "lang/syntax/read_source.hpp"

namespace balcony::lang {

namespace fs = std::filesystem;

std::shared_ptr<const ParsedFile> Files::parsed(std::shared_ptr<const SourceText> source) const {
    auto made = std::make_shared<ParsedFile>();
    made->tree = parse(std::move(source), *catalogue_, made->found);
    return made;
}

std::optional<std::string> Files::key_of(const fs::path& path) {
    const auto known = keys_.find(path);
    if (known != keys_.end()) {
        return known->second;
    }
    paths_.insert(path);
    std::error_code failure;
    if (!fs::exists(path, failure)) {
        return std::nullopt;
    }
    const fs::path canonical = fs::weakly_canonical(path, failure);
    return keys_.emplace(path, failure ? path.string() : canonical.string()).first->second;
}

Result<std::shared_ptr<const ParsedFile>> Files::camera_file(const std::string& key,
                                                             const fs::path& path,
                                                             const std::string& name,
                                                             const SourceSpan& asked) {
    std::shared_ptr<const ParsedFile>& known = camera_files_[key];
    if (!known) {
        Result<std::shared_ptr<const SourceText>> source = read_source(path, name, asked);
        if (!source) {
            return std::move(source.diagnostics);
        }
        known = parsed(std::move(*source));
    }
    return known;
}

std::shared_ptr<const ParsedFile> Files::text(const std::shared_ptr<const SourceText>& source) {
    std::shared_ptr<const ParsedFile>& known = texts_[source.get()];
    if (!known) {
        known = parsed(source);
    }
    return known;
}

std::shared_ptr<const ParsedFile> Files::built_in(const std::string& key, std::string_view text) {
    std::shared_ptr<const ParsedFile>& known = camera_files_[key];
    if (!known) {
        known = parsed(std::make_shared<const SourceText>(key, std::string(text)));
    }
    return known;
}

const Result<data::File>& Files::find(std::string_view name,
                                      const std::optional<fs::path>& folder) {
    if (folder) {
        paths_.insert(*folder / name);
    }
    const std::pair key(std::string(name), folder);
    const auto known = found_.find(key);
    return known != found_.end() ? known->second
                                 : found_.emplace(key, data::find_file(name, folder)).first->second;
}

}  // namespace balcony::lang
