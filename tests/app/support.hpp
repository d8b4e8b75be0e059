// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace balcony::app::test {

/// A test with an empty folder for its files.
class FolderTest : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }

    /// The path of a file in the folder, which has this text, if there is one.
    std::string file(const char* name, const char* text = nullptr) const {
        if (text != nullptr) {
            std::ofstream(folder_ / name) << text;
        }
        return (folder_ / name).string();
    }

private:
    std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
};

}  // namespace balcony::app::test
