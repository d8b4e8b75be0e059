// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// plates/pictures: the renders that hang in the scenes, and the list that they are made from.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scenes/catalogue.hpp"

namespace balcony::plates::hung_pictures_test {

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(BALCONY_PLATES) / "pictures";

// NAME SCENE [--OPTION] CAMERA [OPTION...]
struct Row {
    std::string name, scene, camera;
};

std::vector<Row> rows() {
    std::ifstream list(folder / "list");
    std::vector<Row> all;
    for (std::string line; std::getline(list, line);) {
        if (line.starts_with('#')) {
            continue;
        }
        std::istringstream words(line);
        Row row;
        words >> row.name >> row.scene >> row.camera;
        while (row.camera.starts_with("--")) {
            words >> row.camera;
        }
        all.push_back(row);
    }
    return all;
}

TEST(HungPictures, AreListedAndThere) {
    std::set<std::string> listed;
    for (const Row& row : rows()) {
        EXPECT_TRUE(listed.insert(row.name).second) << row.name;
        std::ifstream file(folder / (row.name + ".jpg"), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_TRUE(bytes.starts_with("\xff\xd8")) << row.name;
        EXPECT_LT(bytes.size(), 300'000U) << row.name;
    }
    EXPECT_GE(listed.size(), 49U);
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".jpg") {
            EXPECT_TRUE(listed.contains(entry.path().stem().string())) << entry.path();
        }
    }
}

TEST(HungPictures, AreOfKnownScenesThroughCamerasThatExist) {
    for (const Row& row : rows()) {
        const auto scenes = scene_catalogue();
        EXPECT_TRUE(std::any_of(scenes.begin(), scenes.end(), [&](const SceneRow& scene) {
            return scene.name == row.scene;
        })) << row.name;
        const std::string file = row.camera.substr(0, row.camera.find(':'));
        EXPECT_TRUE(!file.ends_with(".cam") || fs::exists(folder / file)) << row.name;
    }
}

}  // namespace

}  // namespace balcony::plates::hung_pictures_test
