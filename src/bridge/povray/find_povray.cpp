// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cstdlib>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include "balcony/povray.hpp"
#include "bridge/povray/process.hpp"

namespace balcony::bridge {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view package_remedy =
    "install POV-Ray 3.7: on Debian and Ubuntu, apt install povray";

fs::path program_in_path(std::string_view name) {
    const char* const variable = std::getenv("PATH");
    std::string_view folders = variable != nullptr ? variable : "/usr/local/bin:/usr/bin:/bin";
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        const fs::path file = fs::absolute(fs::path(folders.substr(0, end)) / name);
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) {
            return file;
        }
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return {};
}

// The version in "POV-Ray 3.7.0.10.unofficial".
std::string version_in(std::string_view output) {
    constexpr std::string_view name = "POV-Ray ";
    std::size_t at = output.find(name);
    while (at != std::string_view::npos) {
        const std::string_view rest = output.substr(at + name.size());
        if (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
            return std::string(rest.substr(0, rest.find_first_of(" \r\n")));
        }
        at = output.find(name, at + 1);
    }
    return "";
}

}  // namespace

Result<PovrayProgram> find_povray() {
    PovrayProgram program{program_in_path("povray"), ""};
    if (program.file.empty()) {
        return error(Kind::environment,
                     "POV-Ray is not installed: there is no program named 'povray' in the PATH",
                     std::string(package_remedy));
    }
    program.version = version_in(povray::run_process({program.file, {"--version"}}).output);
    if (!program.version.starts_with("3.7")) {
        return error(Kind::environment,
                     fmt::format("'{}' is not POV-Ray 3.7{}", program.file.string(),
                                 program.version.empty() ? "" : ", but " + program.version),
                     std::string(package_remedy));
    }
    return program;
}

}  // namespace balcony::bridge
