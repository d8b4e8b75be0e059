// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "base/installed_file.hpp"

#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

namespace balcony {

namespace fs = std::filesystem;

namespace {

// The executable or the shared library that has this function; empty if it is not known.
fs::path own_file() {
    Dl_info unused;
    void* found = nullptr;
    const bool is_known =
        dladdr1(reinterpret_cast<const void*>(&own_file), &unused, &found, RTLD_DL_LINKMAP) != 0;
    const std::string_view library = is_known ? static_cast<const link_map*>(found)->l_name : "";
    std::error_code unknown;
    return library.empty() ? fs::read_symlink("/proc/self/exe", unknown)
                           : fs::absolute(library, unknown);
}

}  // namespace

Diagnostic incomplete_installation(std::string_view reason, std::string remedy) {
    return error(Kind::environment, fmt::format("the installation is incomplete: {}", reason),
                 std::move(remedy));
}

Result<fs::path> installed_file(const fs::path& folder, const fs::path& name,
                                std::string_view purpose) {
    const fs::path own_folder = own_file().parent_path();
    if (own_folder.empty()) {
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
