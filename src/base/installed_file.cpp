// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/installed_file.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace balcony {

namespace fs = std::filesystem;

Diagnostic incomplete_installation(std::string_view reason, std::string remedy) {
    return error(Kind::environment, fmt::format("the installation is incomplete: {}", reason),
                 std::move(remedy));
}

Result<fs::path> installed_file(const fs::path& folder, const fs::path& name,
                                std::string_view purpose) {
    std::error_code unknown;
    const fs::path own_folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
    if (unknown) {
        return incomplete_installation("the place of the executable is not known", "mount /proc");
    }
    const fs::path installed = (own_folder / folder / name).lexically_normal();
    for (const fs::path& candidate : {own_folder / name, installed}) {
        std::error_code ignored;
        if (fs::exists(candidate, ignored)) {
            return candidate;
        }
    }
    return incomplete_installation(
        fmt::format("there is no '{}', which {}", installed.string(), purpose),
        "install Balcony again, and move or copy its folders together");
}

}  // namespace balcony
