// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What one call of the library's functions works on: the files it has read, with their names
// resolved, and what there is to say about them.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "balcony/catalogue.hpp"
#include "balcony/expr.hpp"
#include "balcony/picture.hpp"
#include "lang/names/scope.hpp"
#include "lang/syntax/parser.hpp"

namespace balcony::lang {

/// A file that was read.
struct Module {
    SyntaxTree tree;
    std::filesystem::path folder;  ///< Where its imports are looked for first.
    bool built_in = false;         ///< One of the built-in cameras' files.
    std::vector<Module*> imports;
    std::unique_ptr<Scope> scope;  ///< Its lets and those of its imports.
};

/// A camera or a picture and the file that it is in.
struct LocatedDefinition {
    const Module* module = nullptr;
    const DefinitionSyntax* camera = nullptr;
};

class Session {
public:
    Session();

    [[nodiscard]] Reporter& reporter() { return reporter_; }
    [[nodiscard]] const std::shared_ptr<expr::Graph>& graph() const { return graph_; }

    /// The images and meshes that stages were given, by the names of their files.
    [[nodiscard]] std::map<std::string, std::shared_ptr<const camera::GreyImage>>& images() {
        return images_;
    }
    [[nodiscard]] std::map<std::string, std::shared_ptr<const camera::TexturedMesh>>& meshes() {
        return meshes_;
    }

    /// Reads a file or a built-in camera, as the user names it, and what it imports; null, with the
    /// reason reported, if there is none. Other errors are reported and leave a module behind.
    Module* load(const std::filesystem::path& file);
    Module* load(std::shared_ptr<const SourceText> source, const std::filesystem::path& folder);

    /// The file of a built-in camera; null if there is none of that name.
    Module* load_built_in(std::string_view name);

    /// What was made of a camera or a picture: what was made of it before with the same values of
    /// its parameters, if there is that, so that all who show it share it.
    using Shown = decltype(camera::Layer::content);
    [[nodiscard]] Shown share(const LocatedDefinition& place, const std::vector<Value>& parameters,
                              Shown made);

    /// Keeps the tree of an override, whose texts others refer to.
    const SyntaxTree& keep(SyntaxTree tree);

private:
    struct Opened {
        const Module* module;
        std::string key;  // Tells whether two names mean one file.
    };

    Module* open_file(const std::filesystem::path& file, const std::string& name,
                      const SourceSpan& asked);
    Module* open_built_in(std::string_view name);
    Module* resolve(std::shared_ptr<const SourceText> source, std::filesystem::path folder,
                    bool built_in, const std::string& key);
    void import(Module& module, const Import& import);
    Module* find_import(const Module& module, const Import& import);
    void check_duplicate_definitions(const Module& module);
    /// A module read before; reports an import that leads back to itself.
    bool known(const std::string& key, const SourceSpan& asked, Module*& found);

    Reporter reporter_;
    std::shared_ptr<expr::Graph> graph_;
    std::unique_ptr<Scope> constants_;
    std::map<std::string, std::unique_ptr<Module>> modules_;
    std::vector<Opened> opened_;  // The chain of imports that is being read.
    std::vector<std::unique_ptr<SyntaxTree>> overrides_;
    std::map<std::string, std::shared_ptr<const camera::GreyImage>> images_;
    std::map<std::string, std::shared_ptr<const camera::TexturedMesh>> meshes_;
    // By their syntax and their parameters' values: nodes with units, forms with lengths.
    using ParameterKey = std::vector<std::pair<std::size_t, std::variant<Dimension, Value::Form>>>;
    static void add_to_key(const Value& value, ParameterKey& key);
    std::map<std::pair<const DefinitionSyntax*, ParameterKey>, Shown> shared_;
};

/// The cameras and pictures that a file makes visible: its own in their order, then those of its
/// imports.
[[nodiscard]] std::vector<LocatedDefinition> visible_definitions(const Module& module);
[[nodiscard]] std::vector<LocatedDefinition> own_definitions(const Module& module);

}  // namespace balcony::lang
