// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/textures/spill_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

namespace balcony::render {

namespace {

constexpr std::size_t chunk_bytes = TexelBlock::chunk_bytes;

std::size_t rounded_up(std::size_t bytes) {
    return (bytes + chunk_bytes - 1) / chunk_bytes * chunk_bytes;
}

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

}  // namespace

TexelBlock::TexelBlock(TexelBlock&& other) noexcept
    : heap_(std::move(other.heap_)),
      data_(std::exchange(other.data_, nullptr)),
      file_(other.file_),
      chunks_(std::move(other.chunks_)),
      mapping_(std::exchange(other.mapping_, nullptr)),
      bytes_(other.bytes_) {}

TexelBlock::~TexelBlock() {
    if (mapping_ != nullptr) {
        munmap(mapping_, bytes_ + chunk_bytes);
    }
}

void TexelBlock::use_chunk(std::size_t index) const {
    Chunk& chunk = chunks_[index];
    if (chunk.state.load(std::memory_order_relaxed) == absent) {
        file_->admit(chunk);
    } else {
        chunk.state.store(recent, std::memory_order_relaxed);
    }
}

void TexelBlock::finish_writing() const {
    if (mapping_ != nullptr) {
        madvise(data_, bytes_, MADV_DONTNEED);
    }
}

SpillFile::SpillFile(std::size_t resident)
    : max_chunks_(std::max<std::size_t>(resident / chunk_bytes, 16)) {}

SpillFile::~SpillFile() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

// Space is reserved before the block is mapped: to write to a page that has none ends the process.
Result<TexelBlock> SpillFile::allocate(std::size_t bytes) {
    const std::size_t size = rounded_up(bytes);
    std::size_t begin = 0;
    {
        const std::lock_guard lock(mutex_);
        if (descriptor_ < 0) {
            descriptor_ = open_without_name(folder());
        }
        if (descriptor_ < 0) {
            return no_space(size, errno);
        }
        begin = size_;
        if (const int failure =
                posix_fallocate(descriptor_, static_cast<off_t>(begin), static_cast<off_t>(size))) {
            return no_space(size, failure);
        }
        size_ += size;
    }
    TexelBlock block;
    block.bytes_ = size;
    block.file_ = this;
    // Reserves more addresses than needed, to begin at a multiple of a chunk.
    void* const reserved = mmap(nullptr, size + chunk_bytes, PROT_NONE,
                                MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (reserved == MAP_FAILED) {
        return no_space(size, errno);
    }
    block.mapping_ = static_cast<std::byte*>(reserved);
    void* aligned = reserved;
    std::size_t left = size + chunk_bytes;
    std::align(chunk_bytes, size, aligned, left);
    if (mmap(aligned, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, descriptor_,
             static_cast<off_t>(begin)) == MAP_FAILED) {
        return no_space(size, errno);
    }
    block.data_ = static_cast<std::byte*>(aligned);
    block.chunks_ = std::make_unique<TexelBlock::Chunk[]>(size / chunk_bytes);
    for (std::size_t i = 0; i < size / chunk_bytes; ++i) {
        block.chunks_[i].begin = block.data_ + i * chunk_bytes;
    }
    return block;
}

std::size_t SpillFile::resident_bytes() const {
    const std::lock_guard lock(mutex_);
    return in_use_.size() * chunk_bytes;
}

void SpillFile::admit(TexelBlock::Chunk& chunk) {
    const std::lock_guard lock(mutex_);
    if (chunk.state.load(std::memory_order_relaxed) != TexelBlock::absent) {
        return;  // Another thread was faster.
    }
    while (in_use_.size() >= max_chunks_) {
        TexelBlock::Chunk* const oldest = in_use_.front();
        in_use_.pop_front();
        if (oldest->state.load(std::memory_order_relaxed) == TexelBlock::recent) {
            oldest->state.store(TexelBlock::present, std::memory_order_relaxed);
            in_use_.push_back(oldest);
        } else {
            oldest->state.store(TexelBlock::absent, std::memory_order_relaxed);
            madvise(oldest->begin, chunk_bytes, MADV_DONTNEED);
        }
    }
    chunk.state.store(TexelBlock::recent, std::memory_order_relaxed);
    in_use_.push_back(&chunk);
}

}  // namespace balcony::render
