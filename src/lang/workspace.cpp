// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "balcony/progress.hpp"
#include "lang/build/build_camera.hpp"
#include "lang/build/resolved_layer.hpp"
#include "lang/built_in_cameras.hpp"
#include "lang/names/parameter_limits.hpp"
#include "lang/names/session.hpp"
#include "lang/names/unused_names.hpp"
#include "lang/tools/comments.hpp"
#include "lang/tools/explain.hpp"
#include "lang/tools/open_camera.hpp"
#include "lang/tools/rewrite.hpp"

namespace balcony::lang {

namespace {

// A file without a camera is an error if a camera is needed.
bool require_cameras(const Module& module, Reporter& reporter) {
    if (!own_definitions(module).empty() || reporter.error_count() > 0) {
        return !own_definitions(module).empty();
    }
    const SourceText& source = *module.tree.source;
    const bool blank = source.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
    std::vector<std::string> imported;
    for (const LocatedDefinition& place : visible_definitions(module)) {
        imported.emplace_back(place.camera->name.text);
    }
    // The position where a camera could be added: the end of the text.
    const std::size_t end = blank ? 0 : source.text().find_last_not_of(" \t\r\n") + 1;
    reporter.error(module.tree.at({end, end}),
                   fmt::format("'{}' {}", source.name(), blank ? "is empty" : "contains no camera"),
                   imported.empty()
                       ? "the syntax is camera name { ... }"
                       : fmt::format("name one of its imported cameras: {}", one_of(imported)));
    return false;
}

const LocatedDefinition* choose(const std::vector<LocatedDefinition>& cameras,
                                std::string_view name, const Module& module, Reporter& reporter) {
    std::vector<std::string> known;
    for (const LocatedDefinition& place : cameras) {
        if (place.camera->name.text == name) {
            return &place;
        }
        known.emplace_back(place.camera->name.text);
    }
    reporter.error(
        {}, fmt::format("'{}' has no camera or picture '{}'", module.tree.source->name(), name),
        suggestion(name, known, "it contains"));
    return nullptr;
}

// Warns about unused lets outside of cameras. They may be for files that import this one, so only
// a file with cameras is checked.
void warn_of_unused_lets(const Module& module, Reporter& reporter) {
    std::set<std::string_view> used;
    for (const Expression& node : module.tree.expressions) {
        if (node.kind == ExpressionKind::name || node.kind == ExpressionKind::call) {
            used.insert(node.name.text);
        }
    }
    for (const Item& item : module.tree.items) {
        if (const auto* statement = std::get_if<Statement>(&item)) {
            const LetSyntax& let = statement->let();
            if (!used.contains(let.name.text)) {
                warn_of_unused(module.tree, let.name, word_for(let), reporter);
            }
            warn_of_unused_parameters(module.tree, let, reporter);
        }
    }
}

// The selected camera or picture as it is written. An empty name selects the last one of the file,
// or the last camera if a camera is needed. Nothing after an error, which is reported.
std::optional<LocatedDefinition> selected(const Module* module, std::string_view name,
                                          bool camera_wanted, Reporter& reporter) {
    if (module == nullptr || (name.empty() && !require_cameras(*module, reporter))) {
        return std::nullopt;
    }
    if (name.empty()) {
        const std::vector<LocatedDefinition> own = own_definitions(*module);
        const auto last =
            std::find_if(own.rbegin(), own.rend(), [camera_wanted](const LocatedDefinition& place) {
                return !camera_wanted || !place.camera->is_picture;
            });
        return last != own.rend() ? *last : own.back();
    }
    const std::vector<LocatedDefinition> visible = visible_definitions(*module);
    const LocatedDefinition* place = choose(visible, name, *module, reporter);
    return place != nullptr ? std::optional(*place) : std::nullopt;
}

// The same with its base. A picture is an error if a camera is needed.
std::optional<ResolvedLayer> find(const Module* module, std::string_view name, Session& session,
                                  bool camera_wanted = false) {
    const auto place = selected(module, name, camera_wanted, session.reporter());
    auto found = place ? resolve_base({*place, {}}, session) : std::nullopt;
    if (camera_wanted && found && found->place.camera->is_picture) {
        const Identifier& named = found->place.camera->name;
        session.reporter().error(
            found->place.module->tree.at(named.span),
            fmt::format("'{}' is a picture, but a camera is needed", named.text),
            "name a camera, for example one of its layers");
        return std::nullopt;
    }
    return found;
}

// Reports names that are no parameters of a camera.
void check_parameters(const LocatedDefinition& place, const std::vector<std::string>& names,
                      Reporter& reporter) {
    const std::set<std::string_view> known = parameter_names(*place.camera);
    for (const std::string& name : names) {
        if (!known.contains(name)) {
            reporter.error({}, no_parameter(place, name),
                           instead_of_parameter(*place.camera, name));
        }
    }
}

// The result of `build`. A graph that grows too large is an error of the whole definition.
template <class Build>
auto within_graph(const LocatedDefinition& place, Session& session, Build build)
    -> decltype(build()) {
    try {
        return build();
    } catch (const expr::GraphTooLarge&) {
        session.reporter().error(
            place.module->tree.at(place.camera->name.span),
            fmt::format("the {} '{}' is too large: its formulas have more than {} operations",
                        word_for(*place.camera), place.name(), expr::max_nodes),
            "leave out some of its stages");
        return std::nullopt;
    }
}

std::optional<camera::Picture> build_whole(ResolvedLayer& found,
                                           const std::vector<Override>& overrides,
                                           Session& session) {
    found.given.overrides = overrides;
    return within_graph(found.place, session,
                        [&] { return build_picture(found.place, found.given, session); });
}

// The result for a place, with its diagnostics.
template <class Made>
Result<Made> finish(std::optional<Made> made, const Module* module, Session& session) {
    Reporter& reporter = session.reporter();
    const bool failed = reporter.error_count() > 0;
    if (failed && session.stop().stop_requested()) {
        return stopped();
    }
    if (!failed) {
        warn_of_unused_lets(*module, reporter);
    }
    Diagnostics diagnostics = reporter.take();
    return failed ? Result<Made>(std::move(diagnostics))
                  : Result<Made>(std::move(*made), std::move(diagnostics));
}

// The names in layers; those in loops once.
void add_layers(const SyntaxTree& tree, const std::vector<Statement>& statements,
                std::vector<std::string>& names) {
    for (const Statement& statement : statements) {
        if (statement.kind == StatementKind::layer && !statement.broken) {
            names.emplace_back(tree[statement.stages().front()].name.text);
        } else if (statement.kind == StatementKind::loop) {
            add_layers(tree, statement.block, names);
        }
    }
}

Description description_of(const LocatedDefinition& written, const ResolvedLayer& found,
                           Session& session) {
    const SyntaxTree& tree = written.module->tree;
    const DefinitionSyntax& camera = *written.camera;
    Description made;
    made.name = std::string(camera.name.text);
    made.comment = comment_above(tree, camera.span.begin);
    const std::size_t keywords = made.comment.rfind("\n\nKeywords: ");
    if (keywords != std::string::npos) {
        made.keywords = made.comment.substr(keywords + std::string_view("\n\nKeywords: ").size());
        made.comment.erase(keywords);
    }
    made.is_picture = camera.is_picture;
    add_layers(found.place.module->tree, found.place.camera->statements, made.layers);
    for (const DefinitionParameter& parameter : found.place.camera->parameters) {
        made.parameters.push_back({std::string(parameter.name.text), default_text(found, parameter),
                                   limits_of(found.place, parameter, session),
                                   std::string(found.place.module->tree.text(parameter.limits))});
    }
    return made;
}

const Module* read(Session& session, const CameraSource& source) {
    return source.text() ? session.load(source.text(), source.path()) : session.load(source.path());
}

}  // namespace

class Workspace::Implementation {
public:
    explicit Implementation(camera::Catalogue known)
        : catalogue(std::move(known)), files(catalogue) {}

    Result<OpenPicture> make_open(const CameraSource& source, std::string_view name,
                                  const std::vector<Override>& overrides,
                                  const std::optional<std::vector<std::string>>& open,
                                  bool camera_wanted) {
        const auto make = [&](const std::vector<std::string>& names) -> Result<OpenAttempt> {
            Session session = begin();
            const Module* module = read(session, source);
            auto found = find(module, name, session, camera_wanted);
            std::vector<Value> values;
            if (found && names.empty() && open) {
                check_parameters(found->place, *open, session.reporter());
            }
            std::optional<camera::Picture> picture;
            if (found) {
                found->given.overrides = overrides;
                found->given.open = names;
                picture = within_graph(found->place, session, [&] {
                    return build_picture(found->place, found->given, session, &values);
                });
            }
            std::optional<OpenAttempt> made;
            if (picture) {
                made = open_attempt(std::move(*picture), *found, values, session);
            }
            return finish(std::move(made), module, session);
        };
        return open_picture(make, open);
    }

    [[nodiscard]] Session begin() { return Session(files, scene, stop); }

    const camera::Catalogue catalogue;
    Files files;
    std::optional<SceneMeasures> scene;
    std::stop_token stop;
    std::vector<FittedParameter> fitted;
};

Workspace::Workspace(camera::Catalogue catalogue)
    : implementation_(std::make_unique<Implementation>(std::move(catalogue))) {}
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

std::vector<std::filesystem::path> Workspace::files() const {
    const auto& paths = implementation_->files.paths();
    return {paths.begin(), paths.end()};
}

void Workspace::fit_to(std::optional<SceneMeasures> scene) {
    implementation_->scene = std::move(scene);
}

void Workspace::stop_with(std::stop_token stop) { implementation_->stop = std::move(stop); }

const std::vector<FittedParameter>& Workspace::fitted() const { return implementation_->fitted; }

void Workspace::reload() { implementation_->files = Files(implementation_->catalogue); }

Result<camera::Camera> Workspace::make_camera(const CameraSource& source, std::string_view name,
                                              const std::vector<Override>& overrides) {
    Session session = implementation_->begin();
    const Module* module = read(session, source);
    auto found = find(module, name, session, true);
    std::optional<camera::Camera> made;
    if (found) {
        found->given.overrides = overrides;
        made = within_graph(found->place, session, [&] {
            return build_camera(found->place, found->given, session, true);
        });
    }
    return finish(std::move(made), module, session);
}

Result<OpenCamera> Workspace::make_open_camera(
    const CameraSource& source, std::string_view name, const std::vector<Override>& overrides,
    const std::optional<std::vector<std::string>>& open) {
    Result<OpenPicture> made = implementation_->make_open(source, name, overrides, open, true);
    if (!made) {
        return std::move(made.diagnostics);
    }
    return {OpenCamera{*made->picture.only_camera(), std::move(made->open), std::move(made->closed),
                       std::move(made->numbers)},
            std::move(made.diagnostics)};
}

Result<OpenPicture> Workspace::make_open_picture(
    const CameraSource& source, std::string_view name, const std::vector<Override>& overrides,
    const std::optional<std::vector<std::string>>& open) {
    return implementation_->make_open(source, name, overrides, open, false);
}

Result<camera::Picture> Workspace::make_picture(const CameraSource& source, std::string_view name,
                                                const std::vector<Override>& overrides) {
    Session session = implementation_->begin();
    const Module* module = read(session, source);
    auto found = find(module, name, session);
    std::optional<camera::Picture> made =
        found ? build_whole(*found, overrides, session) : std::nullopt;
    implementation_->fitted = session.fitted();
    return finish(std::move(made), module, session);
}

Result<std::vector<camera::Picture>> Workspace::make_all(const CameraSource& source,
                                                         const std::vector<Override>& overrides,
                                                         std::string_view name) {
    Session session = implementation_->begin();
    const Module* module = read(session, source);
    const auto named =
        name.empty() ? std::nullopt : selected(module, name, false, session.reporter());
    std::vector<camera::Picture> made;
    const auto build = [&](const LocatedDefinition& place, const std::vector<Override>& values) {
        auto found = resolve_base({place, {}}, session);
        if (auto picture = found ? build_whole(*found, values, session) : std::nullopt) {
            made.push_back(std::move(*picture));
        }
    };
    if (module != nullptr && require_cameras(*module, session.reporter())) {
        bool is_imported = named.has_value();
        for (const LocatedDefinition& place : own_definitions(*module)) {
            const bool is_named = named && place.camera == named->camera;
            is_imported = is_imported && !is_named;
            build(place, name.empty() || is_named ? overrides : std::vector<Override>());
            if (session.reporter().full()) {
                break;
            }
        }
        if (is_imported) {
            build(*named, overrides);
        }
    }
    return finish(std::optional(std::move(made)), module, session);
}

Result<ExplainedPicture> Workspace::explain(const CameraSource& source, std::string_view name,
                                            const std::vector<Override>& overrides) {
    Session session = implementation_->begin();
    const Module* module = read(session, source);
    auto found = find(module, name, session);
    std::optional<camera::Picture> made =
        found ? build_whole(*found, overrides, session) : std::nullopt;
    std::optional<ExplainedPicture> explained;
    if (made && session.reporter().error_count() == 0) {
        Explanation explanation = lang::explain(found->place, *made, found->given, session);
        explained = ExplainedPicture{std::move(*made), std::move(explanation)};
    }
    return finish(std::move(explained), module, session);
}

Result<std::string> Workspace::with_values(const CameraSource& source, std::string_view name,
                                           const std::vector<Override>& values) {
    Session session = implementation_->begin();
    const Module* module = read(session, source);
    const auto written = selected(module, name, false, session.reporter());
    const auto found = written ? resolve_base({*written, {}}, session) : std::nullopt;
    std::optional<std::string> made;
    if (found) {
        // Reports what is wrong with the names and the expressions.
        const GivenParameters given{values, found->given.values};
        [[maybe_unused]] const DefinitionScope checked(found->place, given, session);
        made = rewritten(*module, *written, values);
    }
    return finish(std::move(made), module, session);
}

Result<std::vector<Description>> Workspace::describe(const CameraSource& source) {
    Session session = implementation_->begin();
    const Module* module = read(session, source);
    if (session.reporter().error_count() > 0) {
        return session.reporter().take();
    }
    std::vector<Description> made;
    for (const LocatedDefinition& place : own_definitions(*module)) {
        if (const auto found = resolve_base({place, {}}, session)) {
            made.push_back(description_of(place, *found, session));
        }
    }
    if (session.reporter().error_count() > 0) {
        return session.reporter().take();
    }
    return {std::move(made), session.reporter().take()};
}

Result<camera::Camera> make_camera(const CameraSource& source, std::string_view name,
                                   const std::vector<Override>& overrides) {
    return Workspace().make_camera(source, name, overrides);
}

Result<camera::Picture> make_picture(const CameraSource& source, std::string_view name,
                                     const std::vector<Override>& overrides) {
    return Workspace().make_picture(source, name, overrides);
}

const std::vector<std::string>& built_in_cameras() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> made;
        for (const BuiltInCamera& camera : built_in_camera_files()) {
            made.emplace_back(camera.name);
        }
        return made;
    }();
    return names;
}

std::string_view family_of(std::string_view built_in_camera) {
    const BuiltInCamera* camera = find_built_in_camera(built_in_camera);
    return camera != nullptr ? camera->family : std::string_view();
}

}  // namespace balcony::lang
