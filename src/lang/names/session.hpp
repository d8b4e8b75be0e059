// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The state of one call of a library function: the camera files with their names resolved, a graph
// for the values, and the diagnostics.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "balcony/catalogue.hpp"
#include "balcony/expr.hpp"
#include "balcony/lang.hpp"
#include "balcony/picture.hpp"
#include "lang/names/files.hpp"
#include "lang/names/scope.hpp"
#include "lang/syntax/parser.hpp"

namespace balcony::lang {

/// A camera file with its names resolved.
struct Module {
    explicit Module(std::shared_ptr<const ParsedFile> parsed)
        : file(std::move(parsed)), tree(file->tree) {}

    std::shared_ptr<const ParsedFile> file;
    const SyntaxTree& tree;
    std::filesystem::path folder;  ///< Where its imports are looked for first.
    bool built_in = false;         ///< One of the built-in cameras' files.
    std::vector<Module*> imports;
    std::unique_ptr<Scope> scope;  ///< Its lets and those of its imports.
};

/// A camera or a picture and its file.
struct LocatedDefinition {
    const Module* module = nullptr;
    const DefinitionSyntax* camera = nullptr;
    /// The definition, in any file, that this one is the base of, and whose name it has then.
    const DefinitionSyntax* derived = nullptr;

    [[nodiscard]] const DefinitionSyntax& named() const {
        return derived != nullptr ? *derived : *camera;
    }
    [[nodiscard]] std::string_view name() const { return named().name.text; }
};

class Session final : public Tables {
public:
    /// The files must outlive it. With a scene, cameras are fitted to it.
    explicit Session(Files& files, std::optional<SceneMeasures> scene = {},
                     std::stop_token stop = {});

    [[nodiscard]] Reporter& reporter() { return reporter_; }
    [[nodiscard]] const std::shared_ptr<expr::Graph>& graph() const { return graph_; }

    [[nodiscard]] const std::stop_token& stop() const { return stop_; }
    [[nodiscard]] const Context& context() const { return context_; }
    [[nodiscard]] const camera::Catalogue& catalogue() const { return files_.catalogue(); }
    [[nodiscard]] Files& files() { return files_; }
    /// Where the files are that a camera file or a text of the command line names; nothing for a
    /// built-in camera.
    [[nodiscard]] std::optional<std::filesystem::path> folder_of(const SyntaxTree& tree) const;

    /// The scene that cameras are fitted to.
    [[nodiscard]] const std::optional<SceneMeasures>& scene() const { return scene_; }
    void note_fitted(std::string_view camera, std::string_view parameter, const Value& value,
                     bool follows_place);
    /// The parameters that were fitted.
    [[nodiscard]] const std::vector<FittedParameter>& fitted() const { return fitted_; }

    /// Reads a file or a built-in camera with its imports. Returns null if there is none, which is
    /// reported. Other errors are reported too, but return a module.
    Module* load(const std::filesystem::path& file);
    Module* load(std::shared_ptr<const SourceText> source, const std::filesystem::path& folder);

    /// The file of a built-in camera; null if there is no camera with that name.
    Module* load_built_in(std::string_view name);
    /// The first camera or picture of a name that is visible in a file; null if there is none.
    [[nodiscard]] const LocatedDefinition* find(const Module& module, std::string_view name);

    /// What is built of a definition with values of its parameters: nothing after an error, which
    /// is reported.
    using Shown = decltype(camera::Layer::content);
    using Built = std::optional<Shown>;
    /// Null until it is shared.
    [[nodiscard]] const Built* built(const LocatedDefinition& place,
                                     const std::vector<Value>& parameters) const;
    /// The first one that is shared for the same definition with the same values.
    const Built& share(const LocatedDefinition& place, const std::vector<Value>& parameters,
                       Built made);

    /// Further inputs of the formulas: parameters that stay open.
    [[nodiscard]] std::vector<camera::KnownInput>& inputs() { return inputs_; }

    const data::NumberTable* table(const SyntaxTree& tree, const Identifier& file) override;
    std::shared_ptr<const expr::Table> grey(const SyntaxTree& tree,
                                            const Identifier& file) override;

    /// The cameras whose morphs are under construction, from the outermost.
    [[nodiscard]] std::vector<const DefinitionSyntax*>& morphs() { return morphs_; }
    /// How deep morphs are nested in a camera, by the ones that have been built.
    [[nodiscard]] std::size_t& morph_levels(const DefinitionSyntax* camera) {
        return morph_levels_[camera];
    }

    /// Keeps the tree of an override alive, since other values refer to its text.
    const SyntaxTree& keep(SyntaxTree tree);

private:
    template <auto read>
    const auto* contents(const SyntaxTree& tree, const Identifier& file);

    struct Opened {
        const Module* module;
        std::string key;  // Equal for two names of the same file.
    };

    Module* open_file(const std::string& key, const std::filesystem::path& file,
                      const std::string& name, const SourceSpan& asked);
    Module* open_built_in(std::string_view name);
    Module* resolve(std::shared_ptr<const ParsedFile> file, std::filesystem::path folder,
                    bool built_in, const std::string& key);
    void import(Module& module, const Import& import);
    Module* find_import(const Module& module, const Import& import);
    void check_duplicate_definitions(const Module& module);
    /// A module that has been read; reports cyclic imports.
    bool known(const std::string& key, const SourceSpan& asked, Module*& found);

    Files& files_;
    Reporter reporter_;
    std::shared_ptr<expr::Graph> graph_;
    std::stop_token stop_;
    CallWork calls_;
    const Context context_;
    const std::optional<SceneMeasures> scene_;
    std::vector<FittedParameter> fitted_;
    std::map<const camera::GreyImage*, std::shared_ptr<const expr::Table>> greys_;
    std::unique_ptr<Scope> constants_;
    std::map<std::string, std::unique_ptr<Module>> modules_;
    std::map<const Module*, std::unordered_map<std::string_view, LocatedDefinition>> visible_;
    std::vector<Opened> opened_;  // The current chain of imports.
    std::vector<std::unique_ptr<SyntaxTree>> overrides_;
    std::vector<camera::KnownInput> inputs_;
    std::vector<const DefinitionSyntax*> morphs_;
    std::map<const DefinitionSyntax*, std::size_t> morph_levels_;
    // By the syntax that names them and their parameters' values: nodes with units, forms with
    // lengths.
    using ParameterKey = std::vector<std::pair<std::size_t, std::variant<Unit, Value::Form>>>;
    using BuiltKey = std::pair<const DefinitionSyntax*, ParameterKey>;
    static BuiltKey key_of(const LocatedDefinition& place, const std::vector<Value>& parameters);
    static void add_to_key(const Value& value, ParameterKey& key);
    std::map<BuiltKey, Built> built_;
};

/// The cameras and pictures visible in a file: its own in their order, then those of its
/// imports.
[[nodiscard]] std::vector<LocatedDefinition> visible_definitions(const Module& module);
[[nodiscard]] std::vector<LocatedDefinition> own_definitions(const Module& module);

}  // namespace balcony::lang
