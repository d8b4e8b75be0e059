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
#include <tuple>
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
    /// What a function of data reads from a file.
    template <auto read>
    [[nodiscard]] const auto& contents(const data::File& file) {
        auto& known = std::get<ByName<read>>(contents_).files;
        const auto found = known.find(file.name);
        return found != known.end() ? found->second
                                    : known.emplace(file.name, read(file)).first->second;
    }

    /// The files on the disk that were read or looked for.
    [[nodiscard]] const std::set<std::filesystem::path>& paths() const { return paths_; }

private:
    using Folder = std::optional<std::filesystem::path>;
    template <auto read>
    struct ByName {
        std::map<std::string, decltype(read(std::declval<data::File>()))> files;
    };

    std::shared_ptr<const ParsedFile> parsed(std::shared_ptr<const SourceText> source) const;

    const camera::Catalogue* catalogue_;
    std::set<std::filesystem::path> paths_;
    std::map<std::filesystem::path, std::string> keys_;
    std::map<std::string, std::shared_ptr<const ParsedFile>> camera_files_;
    std::map<const SourceText*, std::shared_ptr<const ParsedFile>> texts_;
    std::map<std::pair<std::string, Folder>, Result<data::File>> found_;
    std::tuple<ByName<data::read_table>, ByName<data::read_grey_image>, ByName<data::read_mesh>,
               ByName<data::read_ray_map>, ByName<data::read_st_map>,
               ByName<data::read_calibration>, ByName<data::read_prescription>>
        contents_;
};

}  // namespace balcony::lang
