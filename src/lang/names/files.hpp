// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The files that cameras are made of. Each is read once, however many cameras are made of it.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "balcony/data.hpp"
#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// A camera file as it was read, with what is wrong with its syntax.
struct ParsedFile {
    SyntaxTree tree;
    Reporter found;
};

class Files {
public:
    explicit Files(const camera::Catalogue& catalogue) : catalogue_(&catalogue) {}

    [[nodiscard]] const camera::Catalogue& catalogue() const { return *catalogue_; }

    /// What tells whether two paths mean one file; nothing if there is no such file.
    [[nodiscard]] std::optional<std::string> key_of(const std::filesystem::path& path);
    /// The camera file of a key. `name` is what the user calls it, `asked` where it is named.
    [[nodiscard]] Result<std::shared_ptr<const ParsedFile>> camera_file(
        const std::string& key, const std::filesystem::path& path, const std::string& name,
        const SourceSpan& asked);
    [[nodiscard]] std::shared_ptr<const ParsedFile> text(
        const std::shared_ptr<const SourceText>& source);
    [[nodiscard]] std::shared_ptr<const ParsedFile> built_in(const std::string& key,
                                                             std::string_view text);

    /// The file that a camera file in a folder names.
    [[nodiscard]] const Result<data::File>& find(
        std::string_view name, const std::optional<std::filesystem::path>& folder);
    [[nodiscard]] const Result<data::NumberTable>& table(const data::File& file);
    [[nodiscard]] const Result<std::shared_ptr<const camera::GreyImage>>& image(
        const data::File& file);
    [[nodiscard]] const Result<std::shared_ptr<const camera::TexturedMesh>>& mesh(
        const data::File& file);
    [[nodiscard]] const Result<std::shared_ptr<const camera::CalibrationFile>>& calibration(
        const data::File& file);

    [[nodiscard]] const Result<std::shared_ptr<const camera::PixelMap>>& map(
        const data::File& file, camera::MapParameter::Content content);

    /// The files on the disk that were read or looked for.
    [[nodiscard]] const std::set<std::filesystem::path>& paths() const { return paths_; }

private:
    using Folder = std::optional<std::filesystem::path>;

    std::shared_ptr<const ParsedFile> parsed(std::shared_ptr<const SourceText> source) const;

    const camera::Catalogue* catalogue_;
    std::set<std::filesystem::path> paths_;
    std::map<std::filesystem::path, std::string> keys_;
    std::map<std::string, std::shared_ptr<const ParsedFile>> camera_files_;
    std::map<const SourceText*, std::shared_ptr<const ParsedFile>> texts_;
    std::map<std::pair<std::string, Folder>, Result<data::File>> found_;
    std::map<std::string, Result<data::NumberTable>> tables_;
    std::map<std::string, Result<std::shared_ptr<const camera::GreyImage>>> images_;
    std::map<std::string, Result<std::shared_ptr<const camera::TexturedMesh>>> meshes_;
    std::map<std::string, Result<std::shared_ptr<const camera::PixelMap>>> ray_maps_;
    std::map<std::string, Result<std::shared_ptr<const camera::PixelMap>>> st_maps_;
    std::map<std::string, Result<std::shared_ptr<const camera::CalibrationFile>>> calibrations_;
};

}  // namespace balcony::lang
