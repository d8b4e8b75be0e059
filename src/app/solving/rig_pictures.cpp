// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/rig_pictures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

using solve::Constraint;
using solve::ConstraintKind;
using solve::Mark;
using solve::V2d;

namespace {

// What is said of a mark, of another one too.
template <class Row>
void copy_row(std::vector<Row>& rows, std::size_t mark, std::size_t other) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [mark](const Row& one) { return one.mark == mark; });
    if (found != rows.end()) {
        Row same = *found;
        same.mark = other;
        rows.push_back(std::move(same));
    }
}

}  // namespace

void RigPictures::read(const YamlEntry& entry) {
    constexpr std::string_view remedy =
        "name the pictures of a rig from left to right: [left, right]";
    for (const YAML::Node& one : yaml_.list(entry.value)) {
        const auto name = yaml_.word(one, remedy);
        if (name && std::find(names_.begin(), names_.end(), *name) != names_.end()) {
            yaml_.error(yaml_.at(one), fmt::format("there are two pictures '{}'", *name),
                        std::string(remedy));
        } else if (name) {
            names_.push_back(*name);
        }
    }
    width_ = marks_.width;
    if (names_.size() > 1 && width_ > max_side / names_.size()) {
        yaml_.error(entry.written,
                    fmt::format("{} pictures of {} pixels side by side are too wide", names_.size(),
                                width_),
                    fmt::format("together they may have {} pixels", max_side));
    } else if (!names_.empty()) {
        marks_.width = width_ * names_.size();
    }
}

V2d RigPictures::corner_of(std::size_t picture) const {
    return {static_cast<double>(picture * width_), 0.0};
}

std::string RigPictures::words_for(std::size_t picture) const {
    return names_.empty() ? "" : fmt::format(" in {}", names_[picture]);
}

std::optional<std::size_t> RigPictures::of_row(const YAML::Node& row) {
    const YAML::Node name = row.IsMap() ? row["picture"] : YAML::Node(YAML::NodeType::Undefined);
    if (names_.empty() && name) {
        yaml_.error(yaml_.at(name), "there is one picture, which has no name",
                    "add pictures: [left, right], or remove it");
        return std::nullopt;
    }
    if (names_.empty()) {
        return 0;
    }
    if (!name) {
        yaml_.error(yaml_.at(row), "this row does not say which picture of the rig it is about",
                    fmt::format("add picture: {}", one_of(names_)));
        return std::nullopt;
    }
    return yaml_.index_of(name, names_, "picture");
}

bool RigPictures::show(Constraint& constraint, std::size_t picture) {
    if (names_.empty()) {
        return true;
    }
    const auto& kind = solve::constraint_kinds()[static_cast<std::size_t>(constraint.kind)];
    if (kind.is_of_outline || constraint.kind == ConstraintKind::inside ||
        constraint.kind == ConstraintKind::outside) {
        yaml_.error(constraint.written,
                    fmt::format("'{}' cannot be about one of several pictures", kind.name),
                    "demand positions of marks there");
        return false;
    }
    for (std::size_t& mark : constraint.marks) {
        mark = shown_in(mark, picture);
    }
    if (constraint.kind == ConstraintKind::at) {
        std::optional<V2d>& near = marks_.problem.marks[constraint.marks.front()].near;
        near = near.value_or(constraint.position);
    }
    return true;
}

std::size_t RigPictures::shown_in(std::size_t mark, std::size_t picture) {
    if (picture == 0) {
        return mark;
    }
    const auto [found, is_new] = copies_.try_emplace({mark, picture}, marks_.problem.marks.size());
    if (is_new) {
        Mark copy = marks_.problem.marks[mark];
        copy.near.reset();
        copy.name += words_for(picture);
        marks_.problem.marks.push_back(std::move(copy));
        copy_row(marks_.on_objects, mark, found->second);
        copy_row(marks_.directions, mark, found->second);
    }
    return found->second;
}

void RigPictures::begin_in_pictures() {
    if (names_.empty()) {
        return;
    }
    const auto middle_of = [this](std::size_t picture) {
        return corner_of(picture) +
               0.5 * V2d(static_cast<double>(width_), static_cast<double>(marks_.height));
    };
    for (const auto& [of, copy] : copies_) {
        std::optional<V2d>& near = marks_.problem.marks[copy].near;
        near = near.value_or(middle_of(of.second));
    }
    for (Mark& mark : marks_.problem.marks) {
        mark.near = mark.near.value_or(middle_of(0));
    }
}

}  // namespace balcony::app
