// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What has been changed while it was read.

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "app/inputs/file_watch.hpp"
#include "support.hpp"

namespace balcony::app::file_watch_test {
namespace {

using namespace std::chrono_literals;

class FileWatchTest : public test::FolderTest {};

// The time of a file is that of the last tick, so it may be before the clock's when it is written.
TEST_F(FileWatchTest, AFileOfTheTickInWhichReadingBeganHasChanged) {
    const std::filesystem::path path = file("a.obj", "v 0 0 0\n");
    const auto written = std::filesystem::last_write_time(path);
    EXPECT_TRUE(FileWatch({path}, written - 1ms).has_changed());
    EXPECT_TRUE(FileWatch({path}, written + 4ms).has_changed());
    EXPECT_FALSE(FileWatch({path}, written + 1s).has_changed());
}

}  // namespace
}  // namespace balcony::app::file_watch_test
