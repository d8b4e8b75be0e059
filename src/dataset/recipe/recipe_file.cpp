// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "balcony/dataset.hpp"
#include "balcony/input_file.hpp"
#include "balcony/inputs.hpp"
#include "balcony/names.hpp"
#include "dataset/layouts/layout.hpp"
#include "dataset/recipe/entries.hpp"
#include "dataset/recipe/picture_entries.hpp"
#include "dataset/recipe/pose_entries.hpp"

namespace balcony::dataset {

namespace {

namespace fs = std::filesystem;

bool is_in_names(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
}

std::string as_name(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return !is_in_names(c); }, '_');
    return text;
}

// The name of the camera in its file, or else that of the file.
std::string name_of_camera(const std::string& written) {
    const std::size_t colon = written.rfind(':');
    return colon != written.npos && colon + 1 < written.size() ? written.substr(colon + 1)
                                                               : fs::path(written).stem().string();
}

// Where GCC inlines this, it takes a pointer in it for uninitialized.
[[gnu::noinline]] Recipe empty_recipe() { return {}; }

/// Reads a recipe whose text has been parsed.
class RecipeReader {
public:
    RecipeReader(const RecipeText& text, fs::path folder, Recipe& made)
        : text_(text), folder_(std::move(folder)), made_(made) {}

    void read(const toml::table& table) {
        Entries entries(table, text_, "a recipe");
        made_.folder = folder_;
        read_list(entries, "scenes", [&](const toml::node& node) { add_scene(node); });
        read_list(entries, "cameras", [&](const toml::node& node) { add_camera(node); });
        read_list(entries, "poses", [&](const toml::node& node) {
            if (auto group = pose_group_in(node, text_)) {
                made_.groups.push_back(std::move(*group));
            }
        });
        made_.seed = static_cast<std::uint32_t>(
            entries.count("seed", 0, std::numeric_limits<std::uint32_t>::max()).value_or(0));
        read_axes(entries);
        read_names(entries, "layers", dataset::layers(), made_.layers);
        read_names(entries, "layouts", dataset::layouts(), made_.layouts);
        if (!table.contains("layers")) {
            for (const LayerInfo& one : dataset::layers()) {
                if (one.by_default) {
                    made_.layers.emplace_back(one.name);
                }
            }
        }
        add_layers_of_layouts(made_);
        if (const toml::node* const render = entries.find("render")) {
            read_picture(*render, text_, folder_, made_.picture);
        }
    }

private:
    template <class Add>
    void read_list(Entries& entries, const char* name, const Add& add_one) {
        const toml::node* const node = entries.require(name);
        const toml::array* const list = node != nullptr ? node->as_array() : nullptr;
        if (node != nullptr && (list == nullptr || list->empty())) {
            text_.add(*node, fmt::format("'{}' is not a list", name),
                      fmt::format("write [[{}]] before each of them", name));
        }
        for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
            add_one(*list->get(i));
        }
    }

    // In the order of the table, each once.
    template <class Info>
    void read_names(Entries& entries, const char* name, std::span<const Info> known,
                    std::vector<std::string>& to) {
        const auto given = entries.texts(name);
        std::vector<std::string> names;
        for (const Info& one : known) {
            names.emplace_back(one.name);
            if (given && std::find(given->begin(), given->end(), one.name) != given->end()) {
                to.emplace_back(one.name);
            }
        }
        for (const std::string& one : given.value_or(std::vector<std::string>())) {
            if (std::find(names.begin(), names.end(), one) == names.end()) {
                text_.add(*entries.table().get(name), fmt::format("'{}' has no '{}'", name, one),
                          suggestion(one, names, "there are"));
            }
        }
    }

    void read_axes(Entries& entries) {
        made_.axes = entries.text("axes").value_or(made_.axes);
        const auto found = app::matrix_of({}, made_.axes, Axes::z_up);
        if (!found) {
            text_.add(*entries.table().get("axes"), found.diagnostics.front().message,
                      found.diagnostics.front().remedy);
        }
    }

    // A name that the recipe gives, or one that follows from what is named.
    std::string name_in(const std::optional<std::string>& given, const std::string& otherwise,
                        const toml::node& node, std::set<std::string>& taken) {
        const std::string name = given ? *given : as_name(otherwise);
        if (!std::all_of(name.begin(), name.end(), is_in_names) || name.front() == '.') {
            text_.add(node, fmt::format("'{}' is no name of files", name),
                      "use letters, digits, '.', '_' and '-'");
        } else if (!taken.insert(name).second) {
            text_.add(node, fmt::format("the name '{}' is there twice", name),
                      "give each a name of its own, name = \"...\"");
        }
        return name;
    }

    void add_scene(const toml::node& node) {
        SceneChoice made;
        made.span = text_.span_of(node.source());
        std::optional<std::string> name;
        if (const auto written = node.value_exact<std::string>()) {
            made.written = *written;
        } else if (const toml::table* const table = node.as_table()) {
            Entries entries(*table, text_, "a scene");
            static_cast<void>(entries.require("scene"));
            made.written = entries.text("scene").value_or("");
            name = entries.text("name");
        } else {
            text_.add(node, "a scene is neither a file nor a table");
        }
        if (!made.written.empty()) {
            made.file = found_in(folder_, made.written);
            made.name = name_in(name, fs::path(made.written).stem().string(), node, scenes_);
            made_.scenes.push_back(std::move(made));
        }
    }

    void add_camera(const toml::node& node) {
        CameraChoice made;
        made.span = text_.span_of(node.source());
        std::optional<std::string> name;
        if (const auto written = node.value_exact<std::string>()) {
            made.written = *written;
        } else if (const toml::table* const table = node.as_table()) {
            Entries entries(*table, text_, "a camera");
            static_cast<void>(entries.require("camera"));
            made.written = entries.text("camera").value_or("");
            name = entries.text("name");
            read_values(entries, made.set);
        } else {
            text_.add(node, "a camera is neither a text nor a table");
        }
        if (!made.written.empty()) {
            made.camera = found_camera(made.written);
            made.name = name_in(name, name_of_camera(made.written), node, cameras_);
            made_.cameras.push_back(std::move(made));
        }
    }

    [[nodiscard]] std::string found_camera(const std::string& written) const {
        if (app::is_of_scene(written)) {
            return written;
        }
        const std::string file = app::camera_file(written).string();
        return found_in(folder_, file) + written.substr(std::min(file.size(), written.size()));
    }

    void read_values(Entries& entries, std::vector<std::string>& set) {
        const toml::node* const node = entries.find("set");
        const toml::table* const table = node != nullptr ? node->as_table() : nullptr;
        if (node != nullptr && table == nullptr) {
            text_.add(*node, "'set' is not a table", "write set = {fov = \"90deg\"}");
            return;
        }
        if (table == nullptr) {
            return;
        }
        for (const auto& [key, value] : *table) {
            const auto word = value.value_exact<std::string>();
            const auto number = value.value<double>();
            if (!word && !(value.is_number() && number)) {
                text_.add(value, "a value of a parameter is neither a number nor a text",
                          "write an expression of the camera language in quotes");
                continue;
            }
            set.push_back(fmt::format("{}={}", std::string(key.str()),
                                      word ? *word : fmt::format("{}", *number)));
        }
    }

    const RecipeText& text_;
    fs::path folder_;
    Recipe& made_;
    std::set<std::string> scenes_, cameras_;
};

}  // namespace

Result<Recipe> read_recipe(const std::shared_ptr<const SourceText>& text, const fs::path& folder) {
    Diagnostics found;
    const RecipeText recipe_text{text, found};
    const toml::parse_result parsed = toml::parse(text->text(), text->name());
    if (!parsed) {
        const toml::parse_error& failure = parsed.error();
        std::string message(failure.description());
        if (!message.empty()) {
            message.front() = static_cast<char>(std::tolower(message.front()));
        }
        return error(std::move(message), recipe_text.span_of(failure.source()),
                     "https://toml.io describes the format");
    }
    Recipe recipe = empty_recipe();
    RecipeReader(recipe_text, folder, recipe).read(parsed.table());
    return has_errors(found) ? Result<Recipe>(std::move(found))
                             : Result<Recipe>(std::move(recipe), std::move(found));
}

Result<Recipe> read_recipe(const fs::path& file) {
    constexpr std::uintmax_t max_bytes = 64'000'000;
    const std::string name = fmt::format("'{}'", file.string());
    if (const auto problem = not_a_file(file, name)) {
        return *problem;
    }
    std::error_code failed;
    if (fs::file_size(file, failed) > max_bytes || failed) {
        return error(fmt::format("{} is too large for a recipe", name));
    }
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(stream), {});
    if (!stream && bytes.empty()) {
        return error(Kind::environment, fmt::format("{} cannot be read", name));
    }
    std::string_view begun = bytes;
    if (const auto problem = begin_text(begun, name)) {
        return *problem;
    }
    return read_recipe(std::make_shared<const SourceText>(file.string(), std::string(begun)),
                       file.parent_path());
}

}  // namespace balcony::dataset
