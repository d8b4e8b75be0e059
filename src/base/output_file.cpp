// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/output_file.hpp"

#include <atomic>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "balcony/input_file.hpp"
#include "balcony/work_file.hpp"

namespace balcony {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view partial_ending = ".partial";

// Process ids are not unique: processes in two containers that share a folder may have the same
// one.
std::uint64_t random_number() {
    static std::atomic<std::uint64_t> last = 0;
    std::uint64_t number = 0;
    // Without a source of randomness, tries names in sequence.
    return ::getentropy(&number, sizeof number) == 0 ? number : ++last;
}

// Creates a file that did not exist before, so that no other writer has it, in this process,
// another one or on another machine, and locks it. Returns its descriptor, or -1 with the reason in
// errno.
int make_beside(const fs::path& file, fs::path& name) {
    constexpr int max_attempts = 1000;
    constexpr mode_t what_the_user_allows = 0666;
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
        name = file;
        name += fmt::format(".{:016x}{}", random_number(), partial_ending);
        const int made =
            ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, what_the_user_allows);
        if (made < 0 && errno != EEXIST) {
            break;
        }
        // Another process may have taken it for one that was left.
        struct stat facts {};
        if (made >= 0 && (::flock(made, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) &&
            ::fstat(made, &facts) == 0 && facts.st_nlink > 0) {
            return made;
        }
        if (made >= 0) {
            ::close(made);
        }
    }
    name.clear();
    return -1;
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// Removes the unfinished files of a file that nobody has open: their writers were killed.
void remove_left(const fs::path& file) {
    constexpr std::size_t digits = 16;
    const std::string beginning = file.filename().string() + ".";
    for (const std::string& name : names_in(file.parent_path())) {
        const fs::path left = file.parent_path() / name;
        if (name.size() == beginning.size() + digits + partial_ending.size() &&
            name.starts_with(beginning) && name.ends_with(partial_ending)) {
            if (const Result<WorkFile> own = WorkFile::reopen(left)) {
                ::unlink(left.c_str());
            }
        }
    }
}

Diagnostic cannot_write(const fs::path& file, int number) {
    const std::string reason = number != 0 ? ": " + std::generic_category().message(number) : "";
    return error(Kind::environment, fmt::format("'{}' cannot be written{}", file.string(), reason));
}

}  // namespace

// Follows links, so that the target is replaced and not the link.
fs::path resolved(const fs::path& file) {
    std::error_code failed;
    fs::path real = fs::weakly_canonical(file, failed);
    return failed ? file : real;
}

std::string ending_of(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return ending;
}

Diagnostics move_into_place(const fs::path& complete, const fs::path& file) {
    std::error_code failed;
    const fs::file_status before = fs::status(file, failed);
    if (fs::exists(before)) {
        // Moving a file there would replace the device or the pipe itself.
        if (!fs::is_regular_file(before)) {
            return {not_regular(file)};
        }
        if (::access(file.c_str(), W_OK) != 0) {
            return {cannot_write(file, errno)};
        }
        fs::permissions(complete, before.permissions(), failed);
    }
    fs::rename(complete, file, failed);
    return failed ? Diagnostics{cannot_write(file, failed.value())} : Diagnostics{};
}

Diagnostics OutputFile::check(const fs::path& file) {
    std::error_code failed;
    const fs::path real = resolved(file);
    const fs::path folder = folder_of(real);
    if (!fs::is_directory(folder, failed)) {
        return {error(
            Kind::environment,
            fmt::format("there is no folder '{}' to write '{}' to", folder.string(), file.string()),
            "create the folder first, or choose another one")};
    }
    if (fs::exists(real, failed) && !fs::is_regular_file(real, failed)) {
        return {not_regular(file)};
    }
    if (::access(folder.c_str(), W_OK) != 0) {
        return {error(Kind::environment,
                      fmt::format("the folder '{}' cannot be written to", folder.string()),
                      "choose a folder with write permission")};
    }
    // What else may be wrong, such as a name that is too long, shows when a file is made.
    fs::path name;
    const int made = make_beside(real, name);
    if (made < 0) {
        Diagnostic found = cannot_write(real, errno);
        found.remedy = "choose another name or folder";
        return {found};
    }
    fs::remove(name, failed);
    ::close(made);
    return {};
}

OutputFile::OutputFile(const fs::path& file) : file_(resolved(file)) {
    remove_left(file_);
    lock_ = make_beside(file_, beside_);
    if (lock_ < 0) {
        stream_.setstate(std::ios::failbit);
    } else {
        errno = 0;
        stream_.open(beside_, std::ios::binary | std::ios::trunc);
    }
    reason_ = errno;
}

OutputFile::~OutputFile() {
    stream_.close();
    std::error_code ignored;
    fs::remove(beside_, ignored);
    if (lock_ >= 0) {
        ::close(lock_);
    }
}

Diagnostics OutputFile::commit() {
    if (stream_) {
        errno = 0;  // Otherwise, it is why a write failed.
    }
    stream_.close();
    if (!stream_) {
        reason_ = errno != 0 ? errno : reason_;
        return {failure()};
    }
    if (Diagnostics found = move_into_place(beside_, file_); !found.empty()) {
        return found;
    }
    beside_.clear();
    return {};
}

Diagnostic OutputFile::failure() const {
    // A write that failed before the commit left its reason.
    return cannot_write(file_, reason_ != 0 ? reason_ : errno);
}

Diagnostics write_whole(const fs::path& file, std::string_view bytes) {
    OutputFile output(file);
    errno = 0;
    output.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return output.commit();
}

Diagnostics write_whole(const fs::path& file, std::span<const std::uint8_t> bytes) {
    return write_whole(file,
                       std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace balcony
