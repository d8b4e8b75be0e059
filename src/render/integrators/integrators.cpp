// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The table of integrators.

#include <algorithm>
#include <array>

#include "render/integrators/integrator.hpp"

namespace balcony::render {

std::unique_ptr<Integrator> make_direct(const TracedScene& traced, const Settings& settings);
std::unique_ptr<Integrator> make_path(const TracedScene& traced, const Settings& settings);
std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings& settings);

Diagnostics check_path(const Settings& settings);
bool has_mirrors(const scene::Scene& scene);

namespace {

constexpr std::array rows{
    IntegratorRow{.info = {"path", "global illumination"},
                  .make = make_path,
                  .check = check_path,
                  .traces_environment = true},
    IntegratorRow{.info = {"direct", "lights, sharp shadows, mirrors"},
                  .make = make_direct,
                  .shows_mirrors = has_mirrors},
    IntegratorRow{.info = {"preview", "lit from the eye"}, .make = make_preview},
};

constexpr auto infos = [] {
    std::array<IntegratorInfo, rows.size()> made;
    std::transform(rows.begin(), rows.end(), made.begin(),
                   [](const IntegratorRow& row) { return row.info; });
    return made;
}();

}  // namespace

std::span<const IntegratorInfo> integrators() { return infos; }

const IntegratorRow* find_integrator(std::string_view name) {
    const auto* const row = std::find_if(
        rows.begin(), rows.end(), [&](const IntegratorRow& one) { return one.info.name == name; });
    return row != rows.end() ? &*row : nullptr;
}

}  // namespace balcony::render
