// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/input_file.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../files/temporary_folder.hpp"
#include "balcony/content_hash.hpp"

namespace balcony::input_file_test {
namespace {

namespace fs = std::filesystem;

class InputFile : public ::testing::Test {
protected:
    const files::TemporaryFolder folder;

    static std::string said(const fs::path& file) {
        const auto fault = not_a_file(file, "'x'");
        EXPECT_TRUE(!fault || !fault->remedy.empty());
        return fault ? fault->message : "";
    }
};

TEST_F(InputFile, IsARegularFileOrALinkToOne) {
    folder.write("file", "bytes");
    fs::create_symlink("file", folder / "link");
    EXPECT_EQ(said(folder / "file"), "");
    EXPECT_EQ(said(folder / "link"), "");
}

TEST_F(InputFile, WhatIsNoneIsNamed) {
    fs::create_symlink("loop", folder / "loop");
    fs::create_symlink("nowhere", folder / "link");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), S_IRUSR | S_IWUSR), 0);
    EXPECT_EQ(said(folder.path()), "'x' is a folder, not a file");
    EXPECT_EQ(said(folder / "pipe"), "'x' is a pipe or a device, not a file");
    EXPECT_EQ(said("/dev/zero"), "'x' is a pipe or a device, not a file");
    EXPECT_EQ(said(folder / "loop"), "'x' is a link that leads to no file");
    EXPECT_EQ(said(folder / "link"), "'x' is a link that leads to no file");
    EXPECT_EQ(said(folder / "none"), "there is no file 'x'");
    EXPECT_EQ(said(folder / std::string(5000, 'a')), "there is no file 'x'");
    EXPECT_EQ(said(""), "there is no file 'x'");
    EXPECT_FALSE(content_hash(folder / "pipe")) << "does not wait for a writer";
    EXPECT_FALSE(content_hash("/dev/zero")) << "does not read on without an end";
}

}  // namespace
}  // namespace balcony::input_file_test
