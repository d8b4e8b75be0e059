// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <set>

#include "balcony/export.hpp"

namespace balcony::bridge::targets_test {
namespace {

TEST(ExportTargets, HaveNamesOfTheirOwnAndFileEndings) {
    std::set<std::string_view> names;
    for (const ExportTarget& target : export_targets()) {
        EXPECT_TRUE(names.insert(target.name).second) << target.name;
        EXPECT_FALSE(target.meaning.empty()) << target.name;
        EXPECT_TRUE(target.ending.starts_with('.')) << target.name;
    }
    EXPECT_FALSE(names.empty());
}

}  // namespace
}  // namespace balcony::bridge::targets_test
