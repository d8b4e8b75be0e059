// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/lang.hpp"
#include "lang/session.hpp"

namespace balcony::lang {

/// The names of one camera: its parameters, with values from outside or their defaults, and lets.
class CameraScope {
public:
    CameraScope(const CameraPlace& place, const std::vector<Override>& overrides, Session& session);

    [[nodiscard]] Scope& names() { return scope_; }
    /// For a camera without errors: names that nothing uses.
    void warn_of_unused();

private:
    struct Given {
        std::string_view name;
        const SyntaxTree* tree;
    };

    void read_overrides(const std::vector<Override>& overrides);
    void define_parameters();
    void define_parameter(const CameraParameter& parameter);
    [[nodiscard]] Value overridden(const Given& given, const Value& default_value,
                                   std::string_view name);

    const CameraPlace place_;
    const SyntaxTree& tree_;
    Session& session_;
    Scope scope_;
    std::vector<Given> given_;
};

}  // namespace balcony::lang
