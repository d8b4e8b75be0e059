// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/textures/spill_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace balcony::render {

namespace {

constexpr std::size_t chunk_bytes = TexelBlock::chunk_bytes;

std::size_t chunks_of(std::size_t bytes) { return (bytes + chunk_bytes - 1) / chunk_bytes; }

// Not /tmp, which is often in memory.
std::string folder() {
    const char* const given = std::getenv("TMPDIR");
    if (given != nullptr && *given != '\0') {
        return given;
    }
    std::error_code ignored;
    return std::filesystem::is_directory("/var/tmp", ignored) ? "/var/tmp" : "/tmp";
}

int open_without_name(const std::string& where) {
    int descriptor = -1;
#ifdef O_TMPFILE
    descriptor = open(where.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
#endif
    if (descriptor < 0) {  // Some file systems only have files with names.
        std::string name = where + "/balcony-textures-XXXXXX";
        descriptor = mkstemp(name.data());
        if (descriptor >= 0) {
            unlink(name.c_str());
        }
    }
    return descriptor;
}

Diagnostic no_space(std::size_t bytes, int code) {
    return error(
        fmt::format("it does not fit into the memory for textures, and {:.0f} MB cannot be "
                    "written to the folder {}: {}",
                    static_cast<double>(bytes) * 1e-6, folder(),
                    std::generic_category().message(code)),
        {},
        "raise --texture-memory, or let the environment variable TMPDIR name a folder on "
        "a disk with more space");
}

// Returns 0, or the system's number of the failure.
int write_all(int to, std::size_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = pwrite(to, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno != EINTR) {
            return errno;
        }
        const std::size_t count = written > 0 ? static_cast<std::size_t>(written) : 0;
        offset += count;
        bytes = bytes.subspan(count);
    }
    return 0;
}

int read_all(int from, std::size_t offset, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t read = pread(from, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (read == 0) {
            return EIO;  // The file is shorter than what was written.
        }
        if (read < 0 && errno != EINTR) {
            return errno;
        }
        const std::size_t count = read > 0 ? static_cast<std::size_t>(read) : 0;
        offset += count;
        bytes = bytes.subspan(count);
    }
    return 0;
}

}  // namespace

SpillFile::SpillFile(std::size_t resident)
    : max_frames_(
          std::clamp<std::size_t>(resident / chunk_bytes, 16, (std::size_t{1} << frame_bits) - 1)),
      frames_(std::make_unique<Frame[]>(max_frames_)) {}

SpillFile::~SpillFile() {
    for (const Part& part : parts_) {
        if (part.descriptor >= 0) {
            close(part.descriptor);
        }
    }
}

// Space is reserved for whole chunks, so that each can be read as one.
Result<TexelBlock> SpillFile::reserve(std::size_t bytes, std::size_t filled_later,
                                      TexelBlock::Fill fill) {
    const std::size_t chunks = chunks_of(bytes);
    const std::size_t size = chunks * chunk_bytes;
    TexelBlock block;
    block.file_ = this;
    block.slots_ = std::make_unique<Slot[]>(chunks);
    block.later_.reset(new TexelBlock::Later{chunks_of(filled_later), std::move(fill)});
    const std::lock_guard lock(mutex_);
    Part& part = parts_[blocks_++ % parts_.size()];
    if (part.descriptor < 0) {
        part.descriptor = open_without_name(folder());
    }
    if (part.descriptor < 0) {
        return no_space(size, errno);
    }
    // Whether there is space shows before it is filled.
    block.descriptor_ = part.descriptor;
    block.begin_ = part.size;
    if (const int failure = posix_fallocate(part.descriptor, static_cast<off_t>(part.size),
                                            static_cast<off_t>(size))) {
        return no_space(size, failure);
    }
    part.size += size;
    return block;
}

std::optional<Diagnostic> SpillFile::write(const TexelBlock& block, std::size_t offset,
                                           std::span<const std::byte> bytes) const {
    const int failure = write_all(block.descriptor_, block.begin_ + offset, bytes);
    return failure == 0 ? std::nullopt : std::optional(no_space(bytes.size(), failure));
}

std::optional<Diagnostic> SpillFile::failure() const {
    const std::lock_guard lock(mutex_);
    if (!failure_) {
        return std::nullopt;
    }
    return warning(
        fmt::format("textures in the temporary file in {} cannot be read any more: {}", folder(),
                    *failure_),
        {},
        "their materials have their constant factors since; let the environment variable TMPDIR "
        "name a folder on another disk, or raise --texture-memory, and render again");
}

std::size_t SpillFile::resident_bytes() const {
    const std::lock_guard lock(mutex_);
    return made_frames_ * chunk_bytes;
}

// A frame whose chunk was not used since the hand passed it. The chunk loses its slot before the
// frame is written.
std::optional<std::size_t> SpillFile::frame_without_use() {
    for (std::size_t step = 0; step < 2 * max_frames_; ++step) {
        const std::size_t index = hand_;
        hand_ = (hand_ + 1) % max_frames_;
        Frame& frame = frames_[index];
        if (frame.holder != nullptr && !frame.recent.exchange(false, std::memory_order_relaxed)) {
            frame.holder->store(0, std::memory_order_relaxed);
            std::atomic_thread_fence(std::memory_order_release);
            frame.holder = nullptr;
            return index;
        }
    }
    return std::nullopt;
}

std::size_t SpillFile::take_frame(std::unique_lock<std::mutex>& lock) {
    for (;;) {
        if (!free_.empty()) {
            const std::size_t index = free_.back();
            free_.pop_back();
            return index;
        }
        if (made_frames_ < max_frames_) {
            frames_[made_frames_].bytes = std::make_unique<std::byte[]>(chunk_bytes);
            return made_frames_++;
        }
        if (const auto index = frame_without_use()) {
            return *index;
        }
        filled_.wait(lock);  // All are being filled, or were used in two rounds of the hand.
    }
}

// Threads read different chunks at once. If two read the same one, the first is right.
std::uint64_t SpillFile::fetch(const TexelBlock& block, std::size_t chunk) {
    Slot& slot = block.slots_[chunk];
    if (chunk < block.later_->chunks) {
        fill(block);
    }
    std::unique_lock lock(mutex_);
    if (const std::uint64_t known = slot.load(std::memory_order_acquire)) {
        return known;
    }
    const std::size_t index = take_frame(lock);
    Frame& frame = frames_[index];
    lock.unlock();
    read_chunk(block, chunk, frame.bytes.get());
    lock.lock();
    filled_.notify_one();
    if (const std::uint64_t known = slot.load(std::memory_order_acquire)) {
        free_.push_back(index);
        return known;
    }
    const std::uint64_t found = ++reads_ << frame_bits | (index + 1);
    frame.holder = &slot;
    frame.recent.store(true, std::memory_order_relaxed);
    slot.store(found, std::memory_order_release);
    return found;
}

void SpillFile::read_chunk(const TexelBlock& block, std::size_t chunk, std::byte* to) {
    const std::span bytes(to, chunk_bytes);
    if (const int failure =
            read_all(block.descriptor_, block.begin_ + chunk * chunk_bytes, bytes)) {
        std::fill(bytes.begin(), bytes.end(), std::byte{0});
        fail(std::generic_category().message(failure));
    }
}

void SpillFile::fill(const TexelBlock& block) {
    std::call_once(block.later_->once, [&] {
        if (const std::optional<Diagnostic> failure = block.later_->fill(block)) {
            fail(failure->message);
        }
    });
}

void SpillFile::fail(std::string reason) {
    const std::lock_guard lock(mutex_);
    if (!failure_) {
        failure_ = std::move(reason);
    }
    failed_.store(true, std::memory_order_relaxed);
}

}  // namespace balcony::render
