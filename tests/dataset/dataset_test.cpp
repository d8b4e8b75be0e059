// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../files/temporary_folder.hpp"
#include "balcony/ray_maps.hpp"
#include "support.hpp"

namespace balcony::dataset::dataset_test {
namespace {

namespace fs = std::filesystem;
using Imath::V2d;
using nlohmann::json;

constexpr std::size_t width = 48;
constexpr std::size_t height = 36;

// Its rays start on a line.
constexpr const char* slit = R"(camera slit {
    map u = 0.5 .. -0.5, v = square
    eye line((0, 0, 0), (0, 1, 0))
    toward surface(u, v) = [1, 1.1*u, v]
})";

class Dataset : public test::RoomTest {
protected:
    void SetUp() override {
        RoomTest::SetUp();
        write("slit.cam", slit);
    }

    // Of the layers and the cameras; two places near to each other, and two others.
    [[nodiscard]] Recipe recipe(const std::string& layers, const std::string& cameras,
                                std::size_t threads = 0) const {
        auto made = read(
            "scenes = [\"room.obj\"]\nlayers = [" + layers + "]\ncameras = [" + cameras +
            "]\n[render]\nsize = \"48x36\"\nsamples = 2\nthreads = " + std::to_string(threads) + R"(
[[poses]]
path = 2
keys = [
    {at = [-2, 1.5, 1], direction = [1, -0.1, -0.2]},
    {at = [-1.8, 1.4, 1.1], direction = [1, -0.1, -0.3]},
]
[[poses]]
random = 2
)");
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return *made;
    }

    DatasetReport make(const Recipe& recipe, const std::string& name,
                       std::optional<render::Shard> shard = {}) const {
        DatasetReport report =
            make_dataset({.recipe = recipe, .folder = folder() / name, .shard = shard});
        EXPECT_FALSE(has_errors(report.diagnostics)) << to_text(report.diagnostics);
        return report;
    }

    // The names and bytes of all files.
    [[nodiscard]] std::map<std::string, std::string> files(const std::string& name) const {
        std::map<std::string, std::string> found;
        for (const auto& one : fs::recursive_directory_iterator(folder() / name)) {
            if (one.is_regular_file()) {
                found[fs::relative(one.path(), folder() / name).string()] =
                    files::bytes_of(one.path());
            }
        }
        return found;
    }
};

constexpr const char* all_layers =
    R"("rgb", "radiance", "rays", "depth", "normal", "flow", "object", "material", "valid")";

TEST_F(Dataset, EachSceneIsLoadedOnceIfThereIsMemory) {
    write("hall.obj", test::room);
    Recipe both = recipe("\"rgb\"", "\"pinhole\"");
    both.scenes.push_back(
        {.name = "hall", .written = "hall.obj", .file = (folder() / "hall.obj").string()});
    const auto loads = [&](const std::string& name, double memory) {
        std::size_t count = 0;
        app::Observer observer;
        observer.step = [&, last = app::Step::reading](app::Step step, double) mutable {
            count += step == app::Step::building && last != step ? 1 : 0;
            last = step;
        };
        const DatasetReport report = make_dataset(
            {.recipe = both, .folder = folder() / name, .scene_memory = memory}, observer);
        EXPECT_TRUE(report.diagnostics.empty()) << to_text(report.diagnostics);
        EXPECT_EQ(report.rendered, 8U);
        return count;
    };
    EXPECT_EQ(loads("once", 1e18), 2U);
    EXPECT_EQ(loads("again", 0.0), 3U);
    EXPECT_EQ(files("once"), files("again"));
}

TEST_F(Dataset, IsTheSameForAnyThreadsAndShards) {
    const std::string cameras = R"("pinhole", "fisheye")";
    EXPECT_EQ(make(recipe(all_layers, cameras, 1), "one").rendered, 8U);
    make(recipe(all_layers, cameras, 8), "eight");
    const auto whole = files("one");
    EXPECT_EQ(whole.size(), 8U * 9U + 1U);
    EXPECT_EQ(whole, files("eight"));
    for (std::size_t i : {1U, 0U, 2U}) {
        const DatasetReport report =
            make(recipe(all_layers, cameras), "shards", render::Shard{i, 3});
        EXPECT_EQ(report.selected, i < 2 ? 3U : 2U);
        EXPECT_EQ(report.rendered, report.selected);
    }
    EXPECT_EQ(whole, files("shards"));
}

TEST_F(Dataset, ContinuesWithWhatIsMissing) {
    const Recipe wanted = recipe(R"("depth", "object")", R"("fisheye")");
    make(wanted, "set");
    const auto whole = files("set");
    fs::remove(folder() / "set/room/object/fisheye-00001.npy");
    std::ofstream(folder() / "set/room/depth/fisheye-00002.npy");
    const DatasetReport report = make(wanted, "set");
    EXPECT_EQ(report.rendered, 2U);
    EXPECT_EQ(report.skipped, 2U);
    EXPECT_EQ(whole, files("set"));
}

TEST_F(Dataset, AnotherRecipeIsRefused) {
    make(recipe(R"("depth")", R"("fisheye")"), "set");
    Recipe other = recipe(R"("depth")", R"("fisheye")");
    other.seed = 1;
    const DatasetReport refused = make_dataset({.recipe = other, .folder = folder() / "set"});
    EXPECT_EQ(kind_of_errors(refused.diagnostics), Kind::usage);
    EXPECT_NE(to_text(refused.diagnostics).find("seed: 0 there, 1 now"), std::string::npos)
        << to_text(refused.diagnostics);
    const DatasetReport made =
        make_dataset({.recipe = other, .folder = folder() / "set", .overwrite = true});
    EXPECT_EQ(made.rendered, 4U);
}

// By the manifest alone: the text of the camera in the pose of a frame has the rays of its map.
TEST_F(Dataset, TheManifestHasTheRays) {
    make(recipe(R"("rays", "valid")", R"("pinhole", "fisheye", "slit.cam")"), "set");
    const json manifest = json::parse(files::bytes_of(folder() / "set/manifest.json"));
    std::map<std::string, std::string> texts;
    for (const json& camera : manifest["scenes"][0]["cameras"]) {
        texts[camera["name"]] = camera["text"];
    }
    EXPECT_EQ(manifest["axes"]["cameras"], "opencv");
    EXPECT_EQ(manifest["frames"].size(), 12U);
    for (const json& frame : manifest["frames"]) {
        lang::Workspace workspace;
        const auto picture = workspace.make_picture(
            lang::CameraSource(std::make_shared<const SourceText>("text", texts[frame["camera"]]),
                               folder()),
            frame["camera"].get<std::string>());
        ASSERT_TRUE(picture) << to_text(picture.diagnostics);
        app::PoseMatrix matrix;
        for (std::size_t i = 0; i < 3; ++i) {
            matrix[i] = frame["matrix"][i].get<std::array<double, 4>>();
        }
        const auto pose = app::pose_of(matrix, "opencv", Axes::y_up);
        ASSERT_TRUE(pose);
        const auto grid = bridge::RayGrid::make(
            picture->with_pose(*pose),
            {.width = width, .height = height, .layer = {}, .axes = Axes::y_up});
        ASSERT_TRUE(grid);
        rays::Scratch scratch;
        rays::RayBatch rays;
        grid->run(0, 0, width, height, scratch, rays);
        const auto map = test::floats_of(folder() / "set" / frame["files"]["rays"]);
        ASSERT_EQ(map.size(), 6 * width * height);
        for (std::size_t i = 0; i < width * height; ++i) {
            if (rays.valid(i)) {
                for (int k = 0; k < 3; ++k) {  // Floats, whose half step below 4 is 1.2e-7.
                    const auto at = 6 * i + static_cast<std::size_t>(k);
                    EXPECT_NEAR(map[at], rays.origin(i)[k], 5e-7);
                    EXPECT_NEAR(map[at + 3], rays.direction(i)[k], 5e-7);
                }
            }
        }
    }
}

// Of a pinhole, by its numbers in the manifest: the flow leads to where the point of the depth is
// projected in the next pose; and where the depth of the next frame says that it is hidden, there
// is none.
TEST_F(Dataset, FlowAgreesWithReprojectedDepth) {
    make(recipe(R"("rays", "depth", "flow")", R"("pinhole")"), "set");
    const json manifest = json::parse(files::bytes_of(folder() / "set/manifest.json"));
    const json& lens = manifest["scenes"][0]["cameras"][0]["intrinsics"];
    const json& frame = manifest["frames"][0];
    const json& next = manifest["frames"][frame["next"].get<std::size_t>()];
    const auto of = [&](const json& which, const char* layer) {
        return test::floats_of(folder() / "set" / which["files"][layer].get<std::string>());
    };
    const auto rays = of(frame, "rays");
    const auto depth = of(frame, "depth");
    const auto flow = of(frame, "flow");
    const auto next_depth = of(next, "depth");
    const auto m = next["matrix"].get<std::array<std::array<double, 4>, 4>>();
    std::size_t shown = 0;
    std::size_t hidden = 0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < width * height; ++i) {
        V3d own(0.0);
        for (std::size_t row = 0; row < 3; ++row) {
            const double place = rays[6 * i + row] + double{depth[i]} * rays[6 * i + 3 + row];
            for (std::size_t k = 0; k < 3; ++k) {
                own[static_cast<int>(k)] += m[row][k] * (place - m[row][3]);
            }
        }
        const double x = lens["fx"].get<double>() * own.x / own.z + lens["cx"].get<double>();
        const double y = lens["fy"].get<double>() * own.y / own.z + lens["cy"].get<double>();
        const bool is_inside = own.z > 0.0 && x >= 0.0 && y >= 0.0 && x < width && y < height;
        const V2d to(static_cast<double>(i % width) + 0.5 + double{flow[2 * i]},
                     static_cast<double>(i / width) + 0.5 + double{flow[2 * i + 1]});
        if (!is_inside) {
            ++outside;
            EXPECT_TRUE(std::isnan(flow[2 * i])) << i;
            continue;
        }
        if (!std::isnan(flow[2 * i])) {
            ++shown;
            EXPECT_NEAR(to.x, x, 1e-3);  // Floats at 40 pixels a unit.
            EXPECT_NEAR(to.y, y, 1e-3);
        }
        // Where the depths around the place agree on what is there, they say whether it is shown.
        const auto column = static_cast<std::size_t>(x);
        const auto line = static_cast<std::size_t>(y);
        if (column < 1 || line < 1 || column + 1 >= width || line + 1 >= height) {
            continue;
        }
        float nearest = next_depth[line * width + column];
        float farthest = nearest;
        for (const std::size_t at : {line * width + column - 1, line * width + column + 1,
                                     (line - 1) * width + column, (line + 1) * width + column}) {
            nearest = std::min(nearest, next_depth[at]);
            farthest = std::max(farthest, next_depth[at]);
        }
        if (own.length() > 1.3 * farthest) {
            ++hidden;
            EXPECT_TRUE(std::isnan(flow[2 * i])) << i;
        } else if (own.length() > nearest && own.length() < farthest && farthest < 1.1F * nearest) {
            EXPECT_FALSE(std::isnan(flow[2 * i])) << i;
        }
    }
    EXPECT_GT(shown, width * height / 2);
    EXPECT_GT(hidden, 5U);
    EXPECT_GT(outside, 20U);
    for (const float number : of(next, "flow")) {
        EXPECT_TRUE(std::isnan(number));  // The last pose of its group.
    }
}

// In place, nothing moves, and everything is shown, whatever the camera.
TEST_F(Dataset, FlowInPlaceIsZero) {
    auto made = read(R"(scenes = ["room.obj"]
layers = ["flow", "depth"]
cameras = ["fisheye", "slit.cam", "panorama"]
[render]
size = "48x36"
[[poses]]
axes = "balcony"
list = [
    [[1, 0, 0, -1], [0, 0, 1, 1.2], [0, -1, 0, 0.5]],
    [[1, 0, 0, -1], [0, 0, 1, 1.2], [0, -1, 0, 0.5]],
]
)");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    make(*made, "set");
    for (const char* camera : {"fisheye", "slit", "panorama"}) {
        const std::string name = std::string(camera) + "-00000.npy";
        const auto flow = test::floats_of(folder() / "set/room/flow" / name);
        const auto depth = test::floats_of(folder() / "set/room/depth" / name);
        std::size_t moved = 0;
        std::size_t hits = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const bool is_hit = std::isfinite(depth[i]) && depth[i] > 0.0F;
            hits += is_hit ? 1 : 0;
            const bool is_still =
                std::abs(flow[2 * i]) < 1e-2F && std::abs(flow[2 * i + 1]) < 1e-2F;
            moved += is_hit && !is_still ? 1 : 0;
        }
        EXPECT_GT(hits, depth.size() / 3) << camera;
        EXPECT_LE(moved, hits / 200) << camera;  // Seams and poles.
    }
}

TEST_F(Dataset, AStopKeepsWhatIsFinished) {
    std::stop_source stop;
    app::Observer observer;
    observer.frame = [&](std::size_t, std::size_t index, std::size_t) {
        if (index == 2) {
            stop.request_stop();
        }
    };
    const Recipe wanted = recipe(R"("depth")", R"("fisheye")");
    const DatasetReport report =
        make_dataset({.recipe = wanted, .folder = folder() / "set"}, observer, stop.get_token());
    EXPECT_TRUE(report.interrupted);
    EXPECT_EQ(report.rendered, 2U);
    const DatasetReport rest = make(wanted, "set");
    EXPECT_EQ(rest.skipped, 2U);
    EXPECT_EQ(rest.rendered, 2U);
}

TEST_F(Dataset, IdsAreThoseOfTheScene) {
    make(recipe(R"("object", "material")", R"("fisheye")"), "set");
    const json manifest = json::parse(files::bytes_of(folder() / "set/manifest.json"));
    EXPECT_EQ(manifest["scenes"][0]["objects"], (json{"floor", "ceiling", "walls", "box"}));
    const std::string bytes = files::bytes_of(folder() / "set/room/object/fisheye-00000.npy");
    const std::size_t begin = bytes.size() - 4 * width * height;
    std::set<std::uint32_t> ids;
    for (std::size_t i = begin; i < bytes.size(); i += 4) {
        std::uint32_t id = 0;
        std::memcpy(&id, bytes.data() + i, sizeof id);
        ids.insert(id);
    }
    EXPECT_LE(*ids.rbegin(), 4U);
    EXPECT_TRUE(ids.contains(4));  // The box, at which the path looks.
}

}  // namespace
}  // namespace balcony::dataset::dataset_test
