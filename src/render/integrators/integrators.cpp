// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The table of integrators.

#include <algorithm>
#include <array>

#include "render/integrators/direct.hpp"
#include "render/integrators/integrator.hpp"

namespace balcony::render {

std::unique_ptr<Integrator> make_direct(const TracedScene& traced, const Settings& settings);
std::unique_ptr<Integrator> make_path(const TracedScene& traced, const Settings& settings);
std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings& settings);

Diagnostics check_path(const Settings& settings);

namespace {

struct Row {
    IntegratorInfo info;
    IntegratorMaker make;
    Diagnostics (*check)(const Settings& settings) = nullptr;  // Of its own settings.
    bool traces_environment = false;
    bool shows_mirrors = false;
};

constexpr std::array rows{
    Row{{"path", "global illumination"}, make_path, check_path, true},
    Row{{"direct", "lights, sharp shadows, mirrors"}, make_direct, nullptr, false, true},
    Row{{"preview", "lit from the eye"}, make_preview},
};

constexpr auto infos = [] {
    std::array<IntegratorInfo, rows.size()> made;
    std::transform(rows.begin(), rows.end(), made.begin(), [](const Row& row) { return row.info; });
    return made;
}();

}  // namespace

std::span<const IntegratorInfo> integrators() { return infos; }

namespace {

const Row* find_row(std::string_view name) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& one) { return one.info.name == name; });
    return row != rows.end() ? &*row : nullptr;
}

}  // namespace

IntegratorMaker find_integrator(std::string_view name) {
    const Row* const row = find_row(name);
    return row != nullptr ? row->make : nullptr;
}

Diagnostics check_own_settings(const Settings& settings) {
    const Row* const row = find_row(settings.integrator);
    return row != nullptr && row->check != nullptr ? row->check(settings) : Diagnostics{};
}

bool shows_mirrors(std::string_view name, const scene::Scene& scene) {
    const Row* const row = find_row(name);
    return row != nullptr && row->shows_mirrors &&
           std::any_of(scene.materials.begin(), scene.materials.end(), may_be_mirror);
}

bool traces_environment(std::string_view name) {
    const Row* const row = find_row(name);
    return row != nullptr && row->traces_environment;
}

}  // namespace balcony::render
