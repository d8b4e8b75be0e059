// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/work_file.hpp"

#include <filesystem>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../files/temporary_folder.hpp"

namespace balcony::work_file_test {

namespace {

namespace fs = std::filesystem;

bool put(const WorkFile& file, const std::string& text) {
    return ::write(file.descriptor(), text.data(), text.size()) ==
           static_cast<ssize_t>(text.size());
}

bool refused(const Result<WorkFile>& opened, const std::string& message,
             Kind kind = Kind::environment) {
    return !opened && opened.diagnostics.front().kind == kind &&
           opened.diagnostics.front().message.find(message) != std::string::npos;
}

}  // namespace

TEST(WorkFileTest, IsEmptyWhenCreatedAndKeepsItsContentsWhenReopened) {
    const files::TemporaryFolder folder;
    const fs::path file = folder / "picture.part";
    folder.write("picture.part", "of an earlier run");
    {
        const auto made = WorkFile::create(file);
        ASSERT_TRUE(made);
        EXPECT_TRUE(put(*made, "new"));
    }
    EXPECT_EQ(files::bytes_of(file), "new");
    EXPECT_TRUE(WorkFile::reopen(file));
    EXPECT_EQ(files::bytes_of(file), "new");
}

TEST(WorkFileTest, NeverFollowsALink) {
    const files::TemporaryFolder folder;
    folder.write("precious", "precious");
    fs::create_symlink("precious", folder / "link");
    fs::create_symlink("nothing", folder / "dangling");
    for (const char* name : {"link", "dangling"}) {
        EXPECT_TRUE(refused(WorkFile::create(folder / name), "is not a regular file")) << name;
        EXPECT_TRUE(refused(WorkFile::reopen(folder / name), "is not a regular file")) << name;
    }
    EXPECT_EQ(files::bytes_of(folder / "precious"), "precious");
    EXPECT_FALSE(fs::exists(folder / "nothing"));
}

TEST(WorkFileTest, DoesNotWriteToAFileThatHasAnotherName) {
    const files::TemporaryFolder folder;
    folder.write("precious", "precious");
    fs::create_hard_link(folder / "precious", folder / "picture.part");
    const auto made = WorkFile::create(folder / "picture.part");
    ASSERT_TRUE(made);
    EXPECT_TRUE(put(*made, "x"));
    EXPECT_EQ(files::bytes_of(folder / "precious"), "precious");
}

// Opening a pipe would wait for its reader.
TEST(WorkFileTest, NeverOpensAPipeOrADevice) {
    const files::TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_TRUE(refused(WorkFile::create(folder / "pipe"), "is not a regular file"));
    EXPECT_TRUE(refused(WorkFile::reopen(folder / "pipe"), "is not a regular file"));
    EXPECT_TRUE(refused(WorkFile::create("/dev/null"), "is not a regular file"));
}

TEST(WorkFileTest, IsOpenOnce) {
    const files::TemporaryFolder folder;
    const fs::path file = folder / "picture.part";
    {
        const auto first = WorkFile::create(file);
        ASSERT_TRUE(first);
        EXPECT_TRUE(refused(WorkFile::create(file), "another process is writing", Kind::usage));
        EXPECT_TRUE(refused(WorkFile::reopen(file), "another process is writing", Kind::usage));
    }
    EXPECT_TRUE(WorkFile::create(file));
}

TEST(WorkFileTest, WithoutAFolderTheMachineIsAtFault) {
    const files::TemporaryFolder folder;
    const auto made = WorkFile::create(folder / "none" / "picture.part");
    ASSERT_FALSE(made);
    EXPECT_EQ(made.diagnostics.front().kind, Kind::environment);
}

}  // namespace balcony::work_file_test
