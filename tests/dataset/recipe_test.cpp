// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "support.hpp"

#include <numbers>

namespace balcony::dataset::recipe_test {
namespace {

class RecipeFile : public test::RoomTest {
protected:
    // What is said of a recipe whose last lines are these, all of it.
    [[nodiscard]] std::string said_of(const std::string& more) const {
        const auto made = read("scenes = [\"room.obj\"]\ncameras = [\"fisheye\"]\n" + more);
        EXPECT_FALSE(made);
        return to_text(made.diagnostics);
    }
};

TEST_F(RecipeFile, SaysAllOfADataSet) {
    const auto made = read(R"(
seed = 7
axes = "opengl"
layers = ["depth", "rgb"]
layouts = "nerfstudio"
[render]
size = [64, 48]
samples = 4
denoise = true
[[scenes]]
scene = "room.obj"
name = "hall"
[[cameras]]
camera = "fisheye"
set = {fov = "120deg", roll = 0.5}
[[poses]]
random = 3
clearance = 0.25
box = [[-1, 1, -1], [1, 2, 1]]
pitch = [-10, "20deg"]
[[poses]]
path = 4
keys = [{at = [0, 1, 0], look_at = [1, 1, 0]}, {at = [0, 1, 1], direction = [1, 0, 0], time = 3}]
[[poses]]
axes = "balcony"
list = [[[1, 0, 0, 4], [0, 1, 0, 5], [0, 0, 1, 6]]]
)");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->seed, 7U);
    EXPECT_EQ(made->axes, "opengl");
    EXPECT_EQ(made->layers, (std::vector<std::string>{"rgb", "depth"}));
    EXPECT_EQ(made->picture.size.width, 64U);
    EXPECT_EQ(made->picture.samples, 4U);
    EXPECT_TRUE(made->picture.denoise);
    EXPECT_EQ(made->scenes[0].name, "hall");
    EXPECT_EQ(made->scenes[0].file, (folder() / "room.obj").string());
    EXPECT_EQ(made->cameras[0].set, (std::vector<std::string>{"fov=120deg", "roll=0.5"}));
    const auto& random = std::get<RandomPoses>(made->groups[0].poses);
    EXPECT_EQ(random.clearance, 0.25);
    EXPECT_EQ((*random.box)[1], V3d(1, 2, 1));
    EXPECT_NEAR(random.pitch.least, -std::numbers::pi / 18.0, 1e-15);
    EXPECT_NEAR(random.pitch.most, std::numbers::pi / 9.0, 1e-15);
    const auto& path = std::get<PathPoses>(made->groups[1].poses);
    EXPECT_EQ(path.keys[1].look_at, V3d(1, 1, 1));
    EXPECT_EQ(path.keys[1].time, 3.0);
    EXPECT_EQ(std::get<ListedPoses>(made->groups[2].poses).matrices[0][2][3], 6.0);
}

TEST_F(RecipeFile, MistakesHavePlaces) {
    EXPECT_NE(said_of("[[poses]]\nrandom = 3\nclearence = 1\n")
                  .find("recipe.toml:5:1: error: a table of poses has no entry 'clearence'"),
              std::string::npos);
    EXPECT_NE(said_of("[[poses]]\nrandom = 3\nclearence = 1\n").find("did you mean 'clearance'"),
              std::string::npos);
    EXPECT_NE(said_of("[[poses]]\nrandom = 3\n[render]\nsamples = \"many\"\n")
                  .find("recipe.toml:6:11: error: --samples"),
              std::string::npos);
    EXPECT_NE(
        said_of("[[poses]]\nrandom = 3\n[render]\nsample = 4\n").find("did you mean 'samples'"),
        std::string::npos);
    EXPECT_NE(
        said_of("[[poses]]\nrandom = 3\n[render]\nlayers = \"all\"\n").find("recipe.toml:6:1"),
        std::string::npos);
    EXPECT_NE(said_of("layers = [\"dept\"]\n[[poses]]\nrandom = 3\n").find("did you mean 'depth'"),
              std::string::npos);
    EXPECT_NE(said_of("[[poses]]\nrandom = 3 4\n").find("recipe.toml:4:12"), std::string::npos);
    EXPECT_NE(said_of("[[poses]]\nrandom = 0\n").find("recipe.toml:4:10"), std::string::npos);
    EXPECT_NE(said_of("[[poses]]\nlist = [[[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]]]\n")
                  .find("recipe.toml:4:9: error: the matrix of a pose is not a rotation"),
              std::string::npos);
}

TEST_F(RecipeFile, AllMistakesAreReported) {
    const std::string said =
        said_of("axes = \"open\"\n[[poses]]\nrandom = -1\n[[poses]]\npath = 2\n");
    EXPECT_NE(said.find("recipe.toml:3:8: error: there are no axes 'open'"), std::string::npos);
    EXPECT_NE(said.find("recipe.toml:5:10"), std::string::npos);
    EXPECT_NE(said.find("needs the entry 'keys'"), std::string::npos);
}

// What is there twice would be written twice.
TEST_F(RecipeFile, NamesAreUnique) {
    const auto made = read(
        "scenes = [\"room.obj\", \"room.obj\"]\ncameras = [\"fisheye\"]\n"
        "[[poses]]\nrandom = 1\n");
    ASSERT_FALSE(made);
    EXPECT_NE(to_text(made.diagnostics).find("recipe.toml:1:23: error: the name 'room' is there"),
              std::string::npos);
}

}  // namespace
}  // namespace balcony::dataset::recipe_test
