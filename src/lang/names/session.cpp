// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/session.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "balcony/names.hpp"
#include "camera/tables/grey_table.hpp"
#include "lang/built_in_cameras.hpp"
#include "lang/names/scene_names.hpp"

namespace balcony::lang {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t deepest_imports = 64;

std::vector<std::string> built_in_names(std::string_view suffix) {
    std::vector<std::string> names;
    for (const BuiltInCamera& camera : built_in_camera_files()) {
        names.push_back(std::string(camera.name) + std::string(suffix));
    }
    return names;
}

// The cameras that a map projection of this name may be taken for, such as orthographic for ortho.
std::vector<std::string> meant_instead_of(const BuiltInCamera& map) {
    std::vector<std::string> names;
    for (const BuiltInCamera& camera : built_in_camera_files()) {
        if (camera.family != map_family && camera.name.starts_with(map.name)) {
            names.emplace_back(camera.name);
        }
    }
    return names;
}

// Whether nothing in a text is a definition. Messages show no line of such a file, which a
// stranger's camera may import.
bool is_foreign(const SyntaxTree& tree) {
    return tree.broken && std::none_of(tree.items.begin(), tree.items.end(), [](const Item& item) {
               return std::holds_alternative<DefinitionSyntax>(item);
           });
}

std::string standard_key(std::string_view name) { return fmt::format("standard/{}.cam", name); }

}  // namespace

const BuiltInCamera* find_built_in_camera(std::string_view name) {
    if (name.ends_with(".cam")) {
        name.remove_suffix(4);
    }
    for (const BuiltInCamera& camera : built_in_camera_files()) {
        if (camera.name == name) {
            return &camera;
        }
    }
    return nullptr;
}

std::string instead_of_camera(std::string_view name) {
    std::vector<std::string> usual;
    for (const BuiltInCamera& camera : built_in_camera_files()) {
        if (camera.family != map_family) {
            usual.emplace_back(camera.name);
        }
    }
    if (const auto nearest = nearest_name(name, usual)) {
        return fmt::format("did you mean '{}'?", *nearest);
    }
    constexpr std::size_t most = 5;
    std::vector<std::string> named;
    std::vector<std::string> described;
    const bool is_file = name.find_first_of("./\\") != std::string_view::npos;
    for (const CameraMatch& match : search_built_in_cameras(is_file ? "" : name)) {
        std::vector<std::string>& names = match.is_named ? named : described;
        if (names.size() < most) {
            names.push_back(match.name);
        }
    }
    if (!named.empty()) {
        return fmt::format("did you mean {}?", one_of(named));
    }
    return did_you_mean(name, built_in_names(""),
                        described.empty() ? "'balcony list cameras' shows the built-in cameras"
                                          : fmt::format("'{}' is in the description of {}", name,
                                                        all_of(described)));
}

Session::Session(Files& files, std::optional<SceneMeasures> scene, std::stop_token stop)
    : files_(files),
      graph_(std::make_shared<expr::Graph>()),
      stop_(std::move(stop)),
      context_{*graph_, reporter_, files.catalogue(), calls_, *this},
      scene_(std::move(scene)),
      constants_(constants(*graph_)) {
    announce_scene_names(*constants_);
}

void Session::note_fitted(std::string_view camera, std::string_view parameter, const Value& value,
                          bool follows_place) {
    std::optional<double> number;
    if (value.is_constant()) {
        number = value.constant();
    }
    fitted_.push_back(
        {std::string(camera), std::string(parameter), number, value.is_angle(), follows_place});
}

const SyntaxTree& Session::keep(SyntaxTree tree) {
    overrides_.push_back(std::make_unique<SyntaxTree>(std::move(tree)));
    return *overrides_.back();
}

std::optional<fs::path> Session::folder_of(const SyntaxTree& tree) const {
    for (const auto& [key, module] : modules_) {
        if (&module->tree == &tree) {
            return module->built_in ? std::nullopt : std::optional(module->folder);
        }
    }
    return fs::path();
}

template <auto read>
const auto* Session::contents(const SyntaxTree& tree, const Identifier& file) {
    const SourceSpan named = tree.at(file.span);
    const Result<data::File>& found = files_.find(file.text, folder_of(tree));
    reporter_.add(found.diagnostics, named);
    if (!found) {
        return static_cast<decltype(&*files_.contents<read>(*found))>(nullptr);
    }
    const auto& made = files_.contents<read>(*found);
    reporter_.add(made.diagnostics, named);
    return made ? &*made : nullptr;
}

const data::NumberTable* Session::table(const SyntaxTree& tree, const Identifier& file) {
    return contents<data::read_table>(tree, file);
}

std::shared_ptr<const expr::Table> Session::grey(const SyntaxTree& tree, const Identifier& file) {
    const auto* image = contents<data::read_grey_image>(tree, file);
    if (image == nullptr) {
        return nullptr;
    }
    std::shared_ptr<const expr::Table>& made = greys_[image->get()];
    made = made ? made : camera::grey_table(**image);
    return made;
}

// For a tuple or a list: a mark that is not a number, its length and its elements.
void Session::add_to_key(const Value& value, ParameterKey& key) {
    if (!value.elements) {
        key.emplace_back(value.expr.id().value(), value.unit);
        return;
    }
    key.emplace_back(value.elements->size(), value.form);
    for (const Element& element : *value.elements) {
        add_to_key(element.value, key);
    }
}

Session::BuiltKey Session::key_of(const LocatedDefinition& place,
                                  const std::vector<Value>& parameters) {
    BuiltKey key{&place.named(), {}};
    for (const Value& value : parameters) {
        add_to_key(value, key.second);
    }
    return key;
}

const Session::Built* Session::built(const LocatedDefinition& place,
                                     const std::vector<Value>& parameters) const {
    const auto found = built_.find(key_of(place, parameters));
    return found == built_.end() ? nullptr : &found->second;
}

const Session::Built& Session::share(const LocatedDefinition& place,
                                     const std::vector<Value>& parameters, Built made) {
    return built_.try_emplace(key_of(place, parameters), std::move(made)).first->second;
}

Module* Session::load(const fs::path& file) {
    const std::string name = file.string();
    const BuiltInCamera* built_in = find_built_in_camera(name);
    std::error_code failure;
    if (built_in != nullptr && !fs::is_regular_file(file, failure)) {
        const std::vector<std::string> meant = meant_instead_of(*built_in);
        if (built_in->family == map_family && name == built_in->name && !meant.empty()) {
            reporter_.warning({}, fmt::format("'{}' is the map projection of this name", name),
                              fmt::format("did you mean {}? '{}.cam' is the projection without "
                                          "this warning",
                                          one_of(meant), name));
        }
        return open_built_in(built_in->name);
    }
    const std::optional<std::string> key = files_.key_of(file);
    if (!key && name.find("://") != std::string::npos) {
        reporter_.add(*not_a_file(file, fmt::format("'{}'", name)));
        return nullptr;
    }
    if (!key) {
        reporter_.error({}, fmt::format("there is no file and no built-in camera named '{}'", name),
                        instead_of_camera(name));
        return nullptr;
    }
    return open_file(*key, file, name, {});
}

Module* Session::load(std::shared_ptr<const SourceText> source, const fs::path& folder) {
    return resolve(files_.text(source), folder, false, "");
}

Module* Session::load_built_in(std::string_view name) {
    const BuiltInCamera* camera = find_built_in_camera(name);
    return camera != nullptr ? open_built_in(camera->name) : nullptr;
}

const LocatedDefinition* Session::find(const Module& module, std::string_view name) {
    const auto [known, is_new] = visible_.try_emplace(&module);
    if (is_new) {
        for (const LocatedDefinition& place : visible_definitions(module)) {
            known->second.try_emplace(place.camera->name.text, place);
        }
    }
    const auto found = known->second.find(name);
    return found == known->second.end() ? nullptr : &found->second;
}

bool Session::known(const std::string& key, const SourceSpan& asked, Module*& found) {
    const auto circle = std::find_if(opened_.begin(), opened_.end(),
                                     [&key](const Opened& open) { return open.key == key; });
    if (circle != opened_.end()) {
        std::string chain;
        for (auto open = circle; open != opened_.end(); ++open) {
            chain += fmt::format("{} -> ", open->module->tree.source->name());
        }
        const std::string& name = circle->module->tree.source->name();
        reporter_.error(asked, fmt::format("'{}' imports itself: {}{}", name, chain, name),
                        "move the shared definitions to a third file");
        found = nullptr;
        return true;
    }
    const auto module = modules_.find(key);
    found = module == modules_.end() ? nullptr : module->second.get();
    return found != nullptr;
}

Module* Session::open_file(const std::string& key, const fs::path& file, const std::string& name,
                           const SourceSpan& asked) {
    Module* module = nullptr;
    if (known(key, asked, module)) {
        return module;
    }
    const auto parsed = files_.camera_file(key, file, name, asked);
    reporter_.add(parsed.diagnostics);
    if (parsed && file.extension() != ".cam" && is_foreign((*parsed)->tree)) {
        reporter_.error(asked, fmt::format("'{}' is not a camera file", name),
                        "a camera file has definitions: camera name { ... }");
        return nullptr;
    }
    return parsed ? resolve(*parsed, file.parent_path(), false, key) : nullptr;
}

Module* Session::open_built_in(std::string_view name) {
    const std::string key = standard_key(name);
    Module* module = nullptr;
    if (known(key, {}, module)) {
        return module;
    }
    const BuiltInCamera* camera = find_built_in_camera(name);
    return resolve(files_.built_in(key, camera->text), {}, true, key);
}

Module* Session::resolve(std::shared_ptr<const ParsedFile> file, fs::path folder, bool built_in,
                         const std::string& key) {
    std::unique_ptr<Module>& slot = modules_[key];
    slot = std::make_unique<Module>(std::move(file));
    Module& module = *slot;
    reporter_.add(module.file->found);
    module.folder = std::move(folder);
    module.built_in = built_in;
    module.scope = std::make_unique<Scope>(constants_.get());

    if (module.tree.broken) {
        module.scope->mark_incomplete();
    }
    opened_.push_back({&module, key});
    std::vector<const Statement*> lets;
    for (const Item& item : module.tree.items) {
        if (const auto* import_item = std::get_if<Import>(&item)) {
            import(module, *import_item);
        } else if (const auto* let = std::get_if<Statement>(&item)) {
            lets.push_back(let);
        }
    }
    opened_.pop_back();
    define_lets(module.tree, lets, *module.scope, context_);
    check_duplicate_definitions(module);
    return &module;
}

void Session::import(Module& module, const Import& import) {
    const SourceSpan place = module.tree.at(import.file.span);
    if (import.broken) {
        module.scope->mark_incomplete();
        return;
    }
    if (opened_.size() >= deepest_imports) {
        reporter_.error(place,
                        fmt::format("imports are nested more than {} files deep", deepest_imports));
        module.scope->mark_incomplete();
        return;
    }
    Module* imported = find_import(module, import);
    if (imported == nullptr || imported->scope->incomplete()) {
        module.scope->mark_incomplete();
    }
    if (imported == nullptr ||
        std::find(module.imports.begin(), module.imports.end(), imported) != module.imports.end()) {
        return;
    }
    module.imports.push_back(imported);
    module.scope->copy_from(*imported->scope, [&](std::string_view name, const Definition& here,
                                                  const Definition& there) {
        Diagnostic diagnostic =
            error(fmt::format("this import defines '{}', which another import defines too", name),
                  place, "rename one of the two");
        diagnostic.notes.push_back({here.place, "first defined here"});
        diagnostic.notes.push_back({there.place, "defined again here"});
        reporter_.add(std::move(diagnostic));
    });
}

Module* Session::find_import(const Module& module, const Import& import) {
    const SourceSpan place = module.tree.at(import.file.span);
    const fs::path file = module.folder / fs::path(std::string(import.file.text));
    const auto key =
        module.built_in || import.file.text.empty() ? std::nullopt : files_.key_of(file);
    if (key) {
        return open_file(*key, file, file.lexically_normal().string(), place);
    }
    if (const BuiltInCamera* built_in = find_built_in_camera(import.file.text)) {
        return open_built_in(built_in->name);
    }
    const std::string name(import.file.text);
    const std::string folder = module.folder.empty() ? "." : module.folder.string();
    reporter_.error(place,
                    fmt::format("there is no file '{}' in this folder and no built-in camera of "
                                "that name",
                                name),
                    did_you_mean(name, built_in_names(".cam"),
                                 fmt::format("the search folder is '{}'", folder)));
    return nullptr;
}

void Session::check_duplicate_definitions(const Module& module) {
    std::map<std::string_view, const DefinitionSyntax*> cameras;
    for (const LocatedDefinition& place : own_definitions(module)) {
        const Identifier& name = place.camera->name;
        const auto [earlier, is_new] = cameras.emplace(name.text, place.camera);
        if (!is_new && !name.text.empty()) {
            report_duplicate(name, module.tree.at(name.span),
                             module.tree.at(earlier->second->name.span), reporter_);
        }
    }
}

std::vector<LocatedDefinition> own_definitions(const Module& module) {
    std::vector<LocatedDefinition> cameras;
    for (const Item& item : module.tree.items) {
        if (const auto* camera = std::get_if<DefinitionSyntax>(&item)) {
            cameras.push_back({&module, camera});
        }
    }
    return cameras;
}

std::vector<LocatedDefinition> visible_definitions(const Module& module) {
    std::vector<LocatedDefinition> cameras;
    std::vector<const Module*> modules = {&module};
    std::set<const Module*> seen = {&module};
    for (std::size_t i = 0; i < modules.size(); ++i) {
        const std::vector<LocatedDefinition> own = own_definitions(*modules[i]);
        cameras.insert(cameras.end(), own.begin(), own.end());
        for (const Module* imported : modules[i]->imports) {
            if (seen.insert(imported).second) {
                modules.push_back(imported);
            }
        }
    }
    return cameras;
}

}  // namespace balcony::lang
