// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/edits/parts_by_name.hpp"

#include <fmt/format.h>

namespace balcony::scene {

namespace {

// The numbers of the parts with a name.
template <class Part>
std::vector<std::size_t> numbers_of(const std::vector<Part>& parts, std::string_view name) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].name == name) {
            found.push_back(i);
        }
    }
    return found;
}

template <class Part>
Diagnostic unknown(const std::vector<Part>& parts, std::string_view noun, std::string_view name) {
    std::vector<std::string> known;
    for (const Part& part : parts) {
        if (!part.name.empty()) {
            known.push_back(part.name);
        }
    }
    return error(fmt::format("the scene has no {} '{}'", noun, printable(name)), {},
                 printable(suggestion(name, known, fmt::format("it has the {}s", noun))));
}

template <class Part>
Result<std::size_t> find(const std::vector<Part>& parts, std::string_view noun,
                         const PartName& part) {
    if (const auto* const number = std::get_if<std::size_t>(&part)) {
        if (*number < parts.size()) {
            return *number;
        }
        return error(fmt::format("the scene has no {} {}", noun, *number), {},
                     fmt::format("it has {}, numbered from 0", counted(parts.size(), noun)));
    }
    const std::string& name = std::get<std::string>(part);
    const std::vector<std::size_t> found = numbers_of(parts, name);
    if (found.empty()) {
        return unknown(parts, noun, name);
    }
    if (found.size() > 1) {
        return error(
            fmt::format("the scene has {} '{}'", counted(found.size(), noun), printable(name)), {},
            fmt::format("give its number; the first of them is {}", found.front()));
    }
    return found.front();
}

template <class Part>
Diagnostics refuse(const std::vector<Part>& parts, std::string_view noun, const std::string& name) {
    if (name.empty()) {
        return {error(fmt::format("the {} has no name", noun), {}, "give it one to find it by")};
    }
    if (!numbers_of(parts, name).empty()) {
        return {error(fmt::format("the {} '{}' is in the scene already", noun, printable(name)), {},
                      "give another name")};
    }
    return {};
}

}  // namespace

Result<std::size_t> find_object(const Scene& scene, const PartName& name) {
    return find(scene.objects, "object", name);
}
Result<std::size_t> find_material(const Scene& scene, const PartName& name) {
    return find(scene.materials, "material", name);
}
Result<std::size_t> find_light(const Scene& scene, const PartName& name) {
    return find(scene.lights, "light", name);
}

Diagnostics refuse_object_name(const Scene& scene, const std::string& name) {
    return refuse(scene.objects, "object", name);
}
Diagnostics refuse_material_name(const Scene& scene, const std::string& name) {
    return refuse(scene.materials, "material", name);
}
Diagnostics refuse_light_name(const Scene& scene, const std::string& name) {
    return refuse(scene.lights, "light", name);
}

}  // namespace balcony::scene
