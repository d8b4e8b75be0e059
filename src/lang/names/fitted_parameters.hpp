// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "lang/names/session.hpp"

namespace balcony::lang {

/// The `fit` statements of a camera or a picture. If the scene has a look, and the camera stands at
/// scene_inside with z up, then its parameters yaw, pitch and roll are fitted as well.
class FittedParameters {
public:
    /// `names` are those that the defaults of parameters may use. Reports names that are not
    /// parameters, or fitted twice.
    FittedParameters(const LocatedDefinition& place, Scope& names, Session& session);

    /// The value of a parameter in the scene of the session, or in an arbitrary one without it, and
    /// where it is written; nothing for a parameter that is not fitted.
    struct Fitted {
        Value value;
        SourceSpan place;
    };
    [[nodiscard]] std::optional<Fitted> find(std::string_view name);
    [[nodiscard]] bool contains(std::string_view name) const {
        return entries_.contains(name) || look_of(name);
    }
    /// Whether a parameter that is fitted follows from where one stands in the scene.
    [[nodiscard]] bool follows_place(std::string_view name) const;

private:
    struct Entry {
        const Assignment* assignment;
        std::size_t index;  ///< Of the name in it.
    };

    void read(const Assignment& assignment, const std::set<std::string_view>& parameters);
    void add(const Assignment& assignment, std::size_t index);
    [[nodiscard]] Axes axes() const;
    [[nodiscard]] bool stands() const;
    [[nodiscard]] std::optional<double> look_of(std::string_view name) const;

    const LocatedDefinition place_;
    const SyntaxTree& tree_;
    Session& session_;
    Scope scene_names_;
    std::map<std::string_view, Entry> entries_;
};

}  // namespace balcony::lang
