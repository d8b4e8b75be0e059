// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../files/temporary_folder.hpp"
#include "balcony/dataset.hpp"
#include "balcony/npy.hpp"

namespace balcony::dataset::test {

/// A room of 6 x 2.5 x 4 with y up, open nowhere, with a closed box of 1 x 2 x 1 that stands in it.
inline constexpr const char* room = R"(
v -3 0 2
v 3 0 2
v 3 0 -2
v -3 0 -2
v -3 2.5 2
v 3 2.5 2
v 3 2.5 -2
v -3 2.5 -2
v 0.5 0 0.5
v 1.5 0 0.5
v 1.5 0 -0.5
v 0.5 0 -0.5
v 0.5 2 0.5
v 1.5 2 0.5
v 1.5 2 -0.5
v 0.5 2 -0.5
o floor
f 1 2 3 4
o ceiling
f 8 7 6 5
o walls
f 1 5 6 2
f 2 6 7 3
f 3 7 8 4
f 4 8 5 1
o box
f 9 10 14 13
f 10 11 15 14
f 11 12 16 15
f 12 9 13 16
f 13 14 15 16
)";

/// A test with a folder of its own, in which the room is.
class RoomTest : public testing::Test {
protected:
    void SetUp() override { write("room.obj", room); }

    void write(const std::string& name, std::string_view text) const { folder_.write(name, text); }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

    [[nodiscard]] Result<Recipe> read(std::string text) const {
        return read_recipe(std::make_shared<const SourceText>("recipe.toml", std::move(text)),
                           folder_.path());
    }

private:
    const files::TemporaryFolder folder_;
};

/// The floats of an array of NumPy.
[[nodiscard]] inline std::vector<float> floats_of(const std::filesystem::path& file) {
    const std::string bytes = files::bytes_of(file);
    const auto header = NpyHeader::read(bytes, file.string());
    EXPECT_TRUE(header) << file;
    std::vector<float> numbers((bytes.size() - header->size) / sizeof(float));
    std::memcpy(numbers.data(), bytes.data() + header->size, numbers.size() * sizeof(float));
    return numbers;
}

}  // namespace balcony::dataset::test
