// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/work_file.hpp"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace balcony {

namespace {

namespace fs = std::filesystem;

// Without O_NONBLOCK, opening a pipe waits for its reader.
constexpr int own_file = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;

Diagnostic cannot_open(const fs::path& file, int reason) {
    return error(Kind::environment, fmt::format("'{}' cannot be opened: {}", file.string(),
                                                std::generic_category().message(reason)));
}

// A file system that has no locks is no reason to fail.
bool is_locked_elsewhere(int descriptor) {
    return ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

Diagnostic not_regular(const fs::path& file) {
    return error(Kind::environment,
                 fmt::format("'{}' exists and is not a regular file", file.string()),
                 "choose another name for the output");
}

Result<WorkFile> WorkFile::create(const fs::path& file) {
    const bool exists = fs::exists(fs::symlink_status(file));
    if (exists) {
        const Result<WorkFile> before = reopen(file);
        if (!before) {
            return before.diagnostics;
        }
        ::unlink(file.c_str());
    }
    constexpr mode_t what_the_user_allows = 0666;
    WorkFile made(::open(file.c_str(), own_file | O_CREAT | O_EXCL, what_the_user_allows));
    if (made.descriptor_ < 0) {
        return cannot_open(file, errno);
    }
    is_locked_elsewhere(made.descriptor_);
    return made;
}

Result<WorkFile> WorkFile::reopen(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return not_regular(file);
    }
    WorkFile opened(::open(file.c_str(), own_file));
    if (opened.descriptor_ < 0) {
        return cannot_open(file, errno);
    }
    // Whether it is still what it was before it was opened.
    struct stat facts {};
    if (::fstat(opened.descriptor_, &facts) != 0 || !S_ISREG(facts.st_mode)) {
        return not_regular(file);
    }
    if (is_locked_elsewhere(opened.descriptor_)) {
        return error(Kind::usage, fmt::format("another process is writing '{}'", file.string()),
                     "wait until it is done, or choose another name for the output");
    }
    return opened;
}

WorkFile::WorkFile(WorkFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

WorkFile& WorkFile::operator=(WorkFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

WorkFile::~WorkFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

}  // namespace balcony
