// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/recipe/pose_entries.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "balcony/options.hpp"

namespace balcony::dataset {

namespace {

constexpr std::size_t max_poses = 1'000'000;
constexpr double huge = std::numeric_limits<double>::max();

// "20deg", or a number of degrees.
std::optional<double> angle_in(const toml::node& node) {
    static const app::Value<double> degrees = app::degrees(-360.0, 360.0);
    if (const auto word = node.value_exact<std::string>()) {
        return degrees.read(*word);
    }
    const std::optional<double> number = node.value<double>();
    return node.is_number() && number ? degrees.read(fmt::format("{}", *number)) : std::nullopt;
}

// An angle, or the least and the most.
AngleRange angles(Entries& entries, std::string_view name, const AngleRange& otherwise) {
    const toml::node* const node = entries.find(name);
    if (node == nullptr) {
        return otherwise;
    }
    const toml::array* const list = node->as_array();
    const bool is_range = list != nullptr && list->size() == 2;
    const auto least = angle_in(is_range ? *list->get(0) : *node);
    const auto most = angle_in(is_range ? *list->get(1) : *node);
    if (!least || !most || *least > *most) {
        entries.recipe().add(*node, fmt::format("'{}' is no angle and no range of angles", name),
                             "write degrees up to 360, such as [-20, 20]");
        return otherwise;
    }
    return {*least, *most};
}

RandomPoses random_poses(Entries& entries) {
    RandomPoses made;
    made.count = entries.count("random", 1, max_poses).value_or(1);
    made.clearance = entries.number("clearance", 0.0, huge);
    if (const toml::node* const node = entries.find("box")) {
        const toml::array* const list = node->as_array();
        const bool is_box = list != nullptr && list->size() == 2;
        const auto from = is_box ? point_in(*list->get(0), entries.recipe(), "box") : std::nullopt;
        const auto to = is_box ? point_in(*list->get(1), entries.recipe(), "box") : std::nullopt;
        if (!is_box) {
            entries.recipe().add(*node, "'box' is not two corners", "write [[x, y, z], [x, y, z]]");
        } else if (from && to) {
            made.box = {*from, *to};
        }
    }
    made.yaw = angles(entries, "yaw", made.yaw);
    made.pitch = angles(entries, "pitch", made.pitch);
    made.roll = angles(entries, "roll", made.roll);
    return made;
}

std::optional<PathKey> key_in(const toml::node& node, std::size_t number, const RecipeText& text) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) {
        text.add(node, "a key of a path is not a table",
                 "write {at = [0, 1.6, 3], look_at = [0, 1, 0]}");
        return std::nullopt;
    }
    Entries entries(*table, text, "a key of a path");
    PathKey key;
    const auto at = entries.point("at");
    const auto look_at = entries.point("look_at");
    const auto direction = entries.point("direction");
    key.time = entries.number("time", -1e9, 1e9).value_or(static_cast<double>(number));
    if (!at || look_at.has_value() == direction.has_value()) {
        text.add(node, "a key of a path needs 'at' and either 'look_at' or 'direction'");
        return std::nullopt;
    }
    key.at = *at;
    key.look_at = look_at ? *look_at : *at + *direction;
    if ((key.look_at - key.at).length2() == 0.0) {
        text.add(node, "a key of a path looks at its own place");
        return std::nullopt;
    }
    return key;
}

// Back to the first key in a step as long as those before it are on average.
PathKey closing_key(const std::vector<PathKey>& keys) {
    PathKey made = keys.front();
    const auto steps = static_cast<double>(keys.size() - 1);
    made.time = keys.back().time + (keys.back().time - keys.front().time) / steps;
    return made;
}

PathPoses path_poses(Entries& entries) {
    PathPoses made;
    made.count = entries.count("path", 1, max_poses).value_or(1);
    made.closed = entries.truth("closed").value_or(false);
    if (const auto ease = entries.text("ease")) {
        if (const auto found = camera::eases().find(*ease)) {
            made.ease = *found;
        } else {
            entries.recipe().add(*entries.table().get("ease"),
                                 fmt::format("there is no ease '{}'", *ease),
                                 suggestion(*ease, camera::eases().all(), "there are"));
        }
    }
    const toml::node* const node = entries.require("keys");
    const toml::array* const list = node != nullptr ? node->as_array() : nullptr;
    if (node != nullptr && (list == nullptr || list->size() < 2)) {
        entries.recipe().add(*node, "a path needs a list of at least two keys");
        return made;
    }
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        const auto key = key_in(*list->get(i), i, entries.recipe());
        if (key && !made.keys.empty() && !(key->time > made.keys.back().time)) {
            entries.recipe().add(*list->get(i), "the times of keys do not increase");
        } else if (key) {
            made.keys.push_back(*key);
        }
    }
    if (made.closed && made.keys.size() > 1) {
        made.keys.push_back(closing_key(made.keys));
    }
    return made;
}

std::optional<app::PoseMatrix> matrix_in(const toml::node& node) {
    const toml::array* const rows = node.as_array();
    app::PoseMatrix made{};
    if (rows == nullptr || (rows->size() != 3 && rows->size() != 4)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const toml::array* const row = rows->get(i)->as_array();
        if (row == nullptr || row->size() != 4) {
            return std::nullopt;
        }
        for (std::size_t j = 0; j < 4; ++j) {
            const std::optional<double> number = row->get(j)->value<double>();
            const bool is_last = i == 3;
            if (!row->get(j)->is_number() || !number ||
                (is_last && *number != (j == 3 ? 1.0 : 0.0))) {
                return std::nullopt;
            }
            if (!is_last) {
                made[i][j] = *number;
            }
        }
    }
    return made;
}

ListedPoses listed_poses(Entries& entries) {
    ListedPoses made;
    made.axes = entries.text("axes").value_or(made.axes);
    const toml::node* const node = entries.find("list");
    const toml::array* const list = node->as_array();
    if (list == nullptr || list->empty()) {
        entries.recipe().add(*node, "'list' is not a list of matrices");
        return made;
    }
    for (const toml::node& one : *list) {
        const auto matrix = matrix_in(one);
        const auto pose = matrix ? app::pose_of(*matrix, made.axes, Axes::z_up)
                                 : Result<camera::Pose>(error(
                                       "the matrix of a pose does not have three rows of four "
                                       "numbers, or a fourth one of 0, 0, 0, 1"));
        if (pose) {
            made.matrices.push_back(*matrix);
        } else {
            entries.recipe().add(one, pose.diagnostics.front().message,
                                 pose.diagnostics.front().remedy);
        }
    }
    return made;
}

}  // namespace

std::optional<PoseGroup> pose_group_in(const toml::node& node, const RecipeText& text) {
    const toml::table* const table = node.as_table();
    const auto has = [&](const char* name) { return table != nullptr && table->contains(name); };
    if (has("random") + has("path") + has("list") != 1) {
        text.add(node, "poses need one of the entries 'random', 'path' and 'list'",
                 "write random = 20 for twenty poses in the open");
        return std::nullopt;
    }
    Entries entries(*table, text, "a table of poses");
    PoseGroup made;
    made.span = text.span_of(node.source());
    if (has("random")) {
        made.poses = random_poses(entries);
    } else if (has("path")) {
        made.poses = path_poses(entries);
    } else {
        made.poses = listed_poses(entries);
    }
    return made;
}

}  // namespace balcony::dataset
