// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"

namespace balcony::app::test {

/// A test with an empty folder for its files.
class FolderTest : public testing::Test {
protected:
    /// The path of a file in the folder, which has this text, if there is one.
    std::string file(const char* name, const char* text = nullptr) const {
        return (text != nullptr ? folder_.write(name, text) : folder_ / name).string();
    }

private:
    files::TemporaryFolder folder_;
};

}  // namespace balcony::app::test
