// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/output_file.hpp"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace balcony {

TEST(WriteWhole, ReplacesAFileAndLeavesNothingElse) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "balcony_write_whole";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    EXPECT_TRUE(write_whole(folder / "file", "a longer text").empty());
    EXPECT_TRUE(write_whole(folder / "file", "short").empty());
    std::ifstream stream(folder / "file", std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "short");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
    std::filesystem::remove_all(folder);
}

TEST(WriteWhole, SaysWhatCannotBeWrittenAndWhy) {
    const Diagnostics said = write_whole("/nonexistent/folder/file.glb", "x");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].message.find("/nonexistent/folder/file.glb"), std::string::npos);
    EXPECT_NE(said[0].message.find("No such file"), std::string::npos);
}

TEST(WriteWhole, KeepsThePermissionsOfTheFileItReplaces) {
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) / "balcony_permissions";
    ASSERT_TRUE(write_whole(file, "before").empty());
    constexpr auto permissions =
        std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
    std::filesystem::permissions(file, permissions);
    EXPECT_TRUE(write_whole(file, "after").empty());
    EXPECT_EQ(std::filesystem::status(file).permissions(), permissions);
    std::filesystem::remove(file);
}

TEST(WriteWhole, DoesNotReplaceWhatIsNoFile) {
    const std::filesystem::path pipe = std::filesystem::path(testing::TempDir()) / "balcony_pipe";
    std::filesystem::remove(pipe);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const Diagnostics said = write_whole(pipe, "x");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].message.find("is not a file"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    std::filesystem::remove(pipe);
}

}  // namespace balcony
