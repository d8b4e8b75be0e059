// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/object_names.hpp"

#include <utility>

#include <fmt/format.h>

#include "balcony/names.hpp"

namespace balcony::scene {

namespace {

// Only the last star is tried again, since an earlier one could not match more.
bool matches(std::string_view pattern, std::string_view name) {
    std::size_t p = 0;
    std::size_t n = 0;
    std::size_t behind_star = std::string_view::npos;
    std::size_t taken = 0;  // Where what that star stands for ends.
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            behind_star = ++p;
            taken = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (behind_star != std::string_view::npos) {
            p = behind_star;
            n = ++taken;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

template <class Is>
std::vector<std::uint32_t> objects_that(const Scene& scene, const Is& is) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        if (is(scene.objects[i].name)) {
            found.push_back(i);
        }
    }
    return found;
}

}  // namespace

std::vector<std::uint32_t> objects_named(const Scene& scene, std::string_view name) {
    std::vector<std::uint32_t> found =
        objects_that(scene, [name](const std::string& own) { return own == name; });
    return !found.empty()
               ? std::move(found)
               : objects_that(scene, [name](const std::string& own) { return matches(name, own); });
}

Diagnostic no_object(const Scene& scene, std::string message, std::string_view name,
                     SourceSpan written) {
    std::vector<std::string> known;
    for (const Object& object : scene.objects) {
        if (!object.name.empty()) {
            known.push_back(object.name);
        }
    }
    const std::string_view list = "'balcony info --objects' lists the objects of a scene";
    return error(std::move(message), std::move(written),
                 printable(did_you_mean(name, known, std::string(list))));
}

}  // namespace balcony::scene
