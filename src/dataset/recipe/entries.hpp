// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The entries of a table of TOML, with the places of what is wrong.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>
#include <toml++/toml.h>

#include "balcony/base.hpp"

namespace balcony::dataset {

/// What all tables of a file share.
struct RecipeText {
    std::shared_ptr<const SourceText> source;
    Diagnostics& found;

    [[nodiscard]] SourceSpan span_of(const toml::source_region& region) const;
    void add(const toml::node& where, std::string message, std::string remedy = {}) const;
};

/// Asks for each entry that a table can have. The destructor reports the entries that were not
/// asked for.
class Entries {
public:
    /// `what` is what messages call the table: "a scene".
    Entries(const toml::table& table, const RecipeText& text, std::string what)
        : table_(table), text_(text), what_(std::move(what)) {}
    Entries(const Entries&) = delete;
    Entries& operator=(const Entries&) = delete;
    ~Entries();

    /// Null if there is none.
    [[nodiscard]] const toml::node* find(std::string_view name);
    /// The same; a missing one is an error.
    [[nodiscard]] const toml::node* require(std::string_view name);

    // What is there but of another kind is an error, and as if it were not there.
    [[nodiscard]] std::optional<std::string> text(std::string_view name);
    [[nodiscard]] std::optional<bool> truth(std::string_view name);
    [[nodiscard]] std::optional<double> number(std::string_view name, double least, double most);
    [[nodiscard]] std::optional<std::size_t> count(std::string_view name, std::size_t least,
                                                   std::size_t most);
    [[nodiscard]] std::optional<Imath::V3d> point(std::string_view name);
    /// A text, or a list of texts.
    [[nodiscard]] std::optional<std::vector<std::string>> texts(std::string_view name);

    [[nodiscard]] const toml::table& table() const { return table_; }
    [[nodiscard]] const RecipeText& recipe() const { return text_; }

private:
    const toml::table& table_;
    const RecipeText& text_;
    std::string what_;
    std::vector<std::string> asked_;
};

/// Three finite numbers; otherwise an error.
[[nodiscard]] std::optional<Imath::V3d> point_in(const toml::node& node, const RecipeText& text,
                                                 std::string_view name);

}  // namespace balcony::dataset
