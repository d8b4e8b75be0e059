// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include <dlfcn.h>
#include <fmt/format.h>

#include "../files/temporary_folder.hpp"

namespace balcony::bridge::test {

/// Exported code, made into a library by a compiler with these options.
class CompiledLibrary {
public:
    CompiledLibrary(std::string_view text, std::string_view options) {
        const std::string source = folder_.write("all", text).string();
        const std::string made = source + ".so";
        const std::string command =
            fmt::format("{} {} -O0 -ffp-contract=off -shared -fPIC '{}' -o '{}' -lm",
                        BALCONY_C_COMPILER, options, source, made);
        if (std::system(command.c_str()) == 0) {
            handle_ = dlopen(made.c_str(), RTLD_NOW | RTLD_LOCAL);
        }
    }
    CompiledLibrary(const CompiledLibrary&) = delete;
    CompiledLibrary& operator=(const CompiledLibrary&) = delete;
    ~CompiledLibrary() {
        if (handle_ != nullptr) {
            dlclose(handle_);
        }
    }

    [[nodiscard]] bool compiled() const { return handle_ != nullptr; }
    [[nodiscard]] void* symbol(const std::string& name) const {
        return dlsym(handle_, name.c_str());
    }

private:
    files::TemporaryFolder folder_;
    void* handle_ = nullptr;
};

}  // namespace balcony::bridge::test
