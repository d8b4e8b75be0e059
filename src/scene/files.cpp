// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "balcony/input_file.hpp"
#include "scene/import.hpp"

namespace balcony::scene {

namespace fs = std::filesystem;

void Import::warn(std::string message, std::string remedy) {
    if (adds_warnings()) {
        diagnostics.push_back(warning(std::move(message), {}, std::move(remedy)));
    } else {
        ++further_warnings;
    }
}

void Import::count_fault(const std::string& mesh, std::string_view noun, std::size_t count,
                         std::string_view what) {
    if (count == 0) {
        return;
    }
    auto fault = std::find_if(mesh_faults.begin(), mesh_faults.end(),
                              [what](const MeshFault& known) { return known.what == what; });
    if (fault == mesh_faults.end()) {
        fault = mesh_faults.insert(fault, {noun, what, 0, 0, mesh});
    }
    fault->count += count;
    ++fault->meshes;
}

bool Import::has_texture(const fs::path& texture, const std::string& user) {
    const std::optional<Diagnostic> fault = not_a_file(texture, in_quotes(texture.string()));
    if (fault) {
        // Searching the folder takes time.
        const auto near = adds_warnings() ? near_name(texture) : std::nullopt;
        warn(fmt::format("{}: its texture is skipped: {}", user, fault->message),
             near.value_or(fault->remedy));
    }
    return !fault;
}

void Import::check_stop() const {
    if (stop.stop_requested()) {
        throw Stopped{};
    }
}

void Import::begin_phase(double begin, double end) {
    phase_begin_ = begin;
    phase_end_ = end;
    report(0, 1);
}

void Import::report(std::size_t done, std::size_t total) {
    constexpr std::size_t until_next = std::size_t{1} << 16U;
    next_report_ = done + until_next;
    check_stop();
    if (progress) {
        const double part = static_cast<double>(std::min(done, total)) /
                            static_cast<double>(std::max<std::size_t>(total, 1));
        reported_ = std::max(reported_, phase_begin_ + part * (phase_end_ - phase_begin_));
        progress(reported_);
    }
}

std::vector<std::uint8_t> Import::bytes() {
    return given ? std::vector<std::uint8_t>(given->begin(), given->end()) : bytes_of(file);
}

std::string in_quotes(std::string_view name) {
    constexpr std::size_t longest = 80;
    std::string shown;
    for (const char byte : name.substr(0, longest)) {
        const auto code = static_cast<unsigned char>(byte);
        shown += code < 0x20 || code == 0x7f ? '?' : byte;
    }
    if (name.size() > longest) {
        // Do not cut a character in half.
        while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80U) != 0) {
            shown.pop_back();
        }
        shown += "...";
    }
    return "'" + shown + "'";
}

std::optional<std::string> Import::near_name(const fs::path& missing) const {
    std::error_code code;
    if (fs::exists(fs::symlink_status(missing, code))) {
        return std::nullopt;
    }
    std::vector<std::string> names = names_in(missing.parent_path());
    std::erase(names, file.filename().string());
    const auto near = nearest_name(missing.filename().string(), names);
    return near ? std::optional(fmt::format("did you mean {}?",
                                            in_quotes((missing.parent_path() / *near).string())))
                : std::nullopt;
}

std::vector<std::uint8_t> Import::bytes_of(const fs::path& other) {
    const std::string name = in_quotes(other.string());
    if (std::optional<Diagnostic> fault = not_a_file(other, name)) {
        fault->remedy = near_name(other).value_or(fault->remedy);
        throw ReadError{*fault};
    }
    std::error_code code;
    const std::uintmax_t size = fs::file_size(other, code);
    std::ifstream stream(other, std::ios::binary);
    if (code || !stream) {
        throw ReadError{
            error(fmt::format("{} cannot be opened", name), {}, "check its read permission")};
    }
    constexpr std::size_t at_once = std::size_t{1} << 22U;
    std::vector<std::uint8_t> bytes(size);
    for (std::size_t done = 0; done < size;) {
        report(done, size);
        const std::size_t count = std::min<std::size_t>(at_once, size - done);
        stream.read(reinterpret_cast<char*>(bytes.data() + done),
                    static_cast<std::streamsize>(count));
        if (stream.gcount() != static_cast<std::streamsize>(count)) {
            throw ReadError{error(fmt::format("{} could not be read completely", name))};
        }
        done += count;
    }
    return bytes;
}

fs::path Import::beside(const fs::path& other, std::string_view written) {
    if (written.starts_with("file:") || written.find("://") != std::string_view::npos) {
        throw PartError{fmt::format("{} is an address, which is not opened", in_quotes(written)),
                        "download it into the folder of the scene, and name the file"};
    }
    std::string portable(written);
    std::replace(portable.begin(), portable.end(), '\\', '/');
    fs::path named = (other.parent_path() / fs::path(portable)).lexically_normal();
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const fs::path inside = named.lexically_relative(folder.lexically_normal());
    if (inside.empty() || *inside.begin() == "..") {
        throw PartError{
            fmt::format("{} is outside the folder of the scene", in_quotes(named.string())),
            "copy it into that folder, and name it there"};
    }
    return scene.files.emplace_back(std::move(named));
}

}  // namespace balcony::scene
