// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/web/access.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <random>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace balcony::studio {

namespace {

constexpr std::size_t token_length = 32;

bool is_token(std::string_view text) {
    return text.size() == token_length && std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

Diagnostic unusable(const std::filesystem::path& file, std::string_view reason) {
    return error(Kind::environment,
                 fmt::format("the token file '{}' cannot be used: {}", file.string(), reason),
                 "name another file, or leave --token-file out");
}

}  // namespace

std::string random_token() {
    std::random_device bits;
    std::string made;
    while (made.size() < token_length) {
        made += fmt::format("{:08x}", bits());
    }
    return made;
}

Result<std::string> token_of(const std::filesystem::path& file) {
    const std::string made = random_token();
    // Nobody else can have put a file or a link there.
    const int created =
        open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (created >= 0) {
        const std::string line = made + "\n";
        const bool is_written =
            write(created, line.data(), line.size()) == static_cast<ssize_t>(line.size());
        const int reason = errno;
        close(created);
        return is_written ? Result<std::string>(made) : unusable(file, std::strerror(reason));
    }
    if (errno != EEXIST) {
        return unusable(file, std::strerror(errno));
    }
    std::string found;
    std::ifstream(file) >> found;
    if (!is_token(found)) {
        return unusable(file, "it does not have 32 hexadecimal digits");
    }
    return found;
}

bool is_same_secret(std::string_view one, std::string_view other) {
    if (one.size() != other.size()) {
        return false;
    }
    unsigned differences = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        differences |= static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(other[i]);
    }
    return differences == 0;
}

std::string_view query_value(std::string_view target, std::string_view name) {
    std::size_t at = target.find('?');
    while (at != std::string_view::npos) {
        target.remove_prefix(at + 1);
        const std::string_view part = target.substr(0, target.find('&'));
        if (part.starts_with(name) && part.substr(name.size()).starts_with('=')) {
            return part.substr(name.size() + 1);
        }
        at = target.find('&');
    }
    return {};
}

namespace {

constexpr std::array<std::string_view, 2> own_names{"127.0.0.1:", "localhost:"};

}  // namespace

OwnNames::OwnNames(std::uint16_t port) : port_(std::to_string(port)) {}

bool OwnNames::has_host(std::string_view host) const {
    return std::any_of(own_names.begin(), own_names.end(), [&](std::string_view name) {
        return host.starts_with(name) && host.substr(name.size()) == port_;
    });
}

bool OwnNames::has_origin(std::string_view origin) const {
    constexpr std::string_view scheme = "http://";
    return origin.starts_with(scheme) && has_host(origin.substr(scheme.size()));
}

}  // namespace balcony::studio
