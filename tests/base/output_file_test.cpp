// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/output_file.hpp"

#include <array>
#include <iterator>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../files/temporary_folder.hpp"

namespace balcony::output_file_test {

namespace {

namespace fs = std::filesystem;

auto file_count(const files::TemporaryFolder& folder) {
    return std::distance(fs::directory_iterator(folder.path()), {});
}

/// Two pipes to and from processes that write a file.
struct Channel {
    std::array<int, 2> to_writers{};
    std::array<int, 2> from_writers{};
    Channel() {
        if (pipe(to_writers.data()) != 0 || pipe(from_writers.data()) != 0) {
            throw std::runtime_error("no pipe");
        }
    }
    void tell_writers() const { ASSERT_EQ(write(to_writers[1], "..", 2), 2); }
    // '+' if it has the file open, '-' if this system makes no containers for us.
    [[nodiscard]] char answer() const {
        char byte = '-';
        return read(from_writers[0], &byte, 1) == 1 ? byte : '-';
    }
};

// Starts a process that is the first of its own numbering, as in a container. It opens the file,
// and at a word from here it ends.
pid_t start_writer_in_container(const fs::path& file, const Channel& channel) {
    const pid_t outside = fork();
    if (outside != 0) {
        return outside;
    }
    const bool separate = unshare(CLONE_NEWPID) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWPID) == 0;
    const pid_t inside = separate ? fork() : -1;
    if (inside == 0) {
        const OutputFile output(file);
        char byte = '+';
        _exit(getpid() == 1 && write(channel.from_writers[1], &byte, 1) == 1 &&
                      read(channel.to_writers[0], &byte, 1) == 1
                  ? 0
                  : 1);
    }
    if (inside < 0) {
        _exit(write(channel.from_writers[1], "-", 1) == 1 ? 0 : 1);
    }
    waitpid(inside, nullptr, 0);
    _exit(0);
}

}  // namespace

TEST(WriteWhole, ReplacesAFileAndLeavesNothingElse) {
    const files::TemporaryFolder folder;
    EXPECT_TRUE(write_whole(folder / "file", "a longer text").empty());
    EXPECT_TRUE(write_whole(folder / "file", "short").empty());
    EXPECT_EQ(files::bytes_of(folder / "file"), "short");
    EXPECT_EQ(file_count(folder), 1);
}

TEST(OutputFileInContainers, WritersWithTheSameProcessIdHaveDifferentFiles) {
    const files::TemporaryFolder folder;
    const Channel channel;
    std::array<pid_t, 2> writers{};
    for (pid_t& writer : writers) {
        writer = start_writer_in_container(folder / "file", channel);
    }
    close(channel.from_writers[1]);  // A writer that dies leaves an end, not silence.
    const bool both = channel.answer() == '+' && channel.answer() == '+';
    const auto open_files = file_count(folder);
    channel.tell_writers();
    for (const pid_t writer : writers) {
        waitpid(writer, nullptr, 0);
    }
    if (!both) {
        GTEST_SKIP() << "this system makes no containers for us";
    }
    EXPECT_EQ(open_files, 2);
}

TEST(OutputFile, LeavesNothingIfItIsNotCommitted) {
    const files::TemporaryFolder folder;
    {
        OutputFile output(folder / "file");
        output.stream() << "half";
        EXPECT_EQ(file_count(folder), 1);
    }
    EXPECT_EQ(file_count(folder), 0);
}

TEST(OutputFile, WhatAKilledWriterLeftIsRemoved) {
    const files::TemporaryFolder folder;
    if (const pid_t killed = fork(); killed == 0) {
        const OutputFile left(folder / "file");
        const OutputFile left_of_another(folder / "file.png");
        _exit(0);
    } else {
        waitpid(killed, nullptr, 0);
    }
    ASSERT_EQ(file_count(folder), 2);
    {
        const OutputFile first(folder / "file");
        EXPECT_EQ(file_count(folder), 2) << "what was left of another file stays";
        const OutputFile second(folder / "file");
        EXPECT_EQ(file_count(folder), 3) << "the first is in use";
        EXPECT_TRUE(fs::exists(first.beside()));
    }
    EXPECT_EQ(file_count(folder), 1);
}

TEST(OutputFile, ANewFileHasThePermissionsThatTheUserAllows) {
    const files::TemporaryFolder folder;
    const mode_t before = umask(0027);
    EXPECT_TRUE(write_whole(folder / "file", "x").empty());
    umask(before);
    EXPECT_EQ(fs::status(folder / "file").permissions(), fs::perms(0640));
}

TEST(WriteWhole, ReportsWhyAFileCannotBeWritten) {
    const Diagnostics said = write_whole("/nonexistent/folder/file.glb", "x");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].message.find("/nonexistent/folder/file.glb"), std::string::npos);
    EXPECT_NE(said[0].message.find("No such file"), std::string::npos);
}

TEST(WriteWhole, KeepsThePermissionsOfTheFileItReplaces) {
    const files::TemporaryFolder folder;
    const fs::path file = folder / "file";
    ASSERT_TRUE(write_whole(file, "before").empty());
    constexpr auto permissions = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(file, permissions);
    EXPECT_TRUE(write_whole(file, "after").empty());
    EXPECT_EQ(fs::status(file).permissions(), permissions);
}

TEST(WriteWhole, DoesNotReplaceDevicesOrPipes) {
    const files::TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const Diagnostics said = write_whole(pipe, "x");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].message.find("is not a regular file"), std::string::npos);
    EXPECT_EQ(said[0].kind, Kind::environment);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace balcony::output_file_test
