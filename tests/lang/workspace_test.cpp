// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// A workspace reads each file once, and knows the stages that a program adds.

#include <algorithm>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::workspace_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* mesh_text =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

/// A camera that is made of files of every kind.
fs::path write_camera(const files::TemporaryFolder& folder) {
    folder.write("lengths.cam", "let far = 3\n");
    folder.write("path.csv", "0, 0\n1, 1\n2, 0\n");
    folder.write("wall.obj", mesh_text);
    return folder.write("a.cam", R"(import "lengths.cam"
camera c(height = 1) {
    map    u = 0 .. 1, v = 0 .. height
    eye    product(polyline("path.csv"), circle(far))
    toward mesh("wall.obj")
})");
}

double height_of(const camera::Camera& camera) {
    const test::Ray bottom = test::ray(camera, 0.5, 1.0, 1.0, 1.0);
    const test::Ray top = test::ray(camera, 0.5, 0.0, 1.0, 1.0);
    return top.origin[2] - bottom.origin[2];
}

TEST(Workspace, ReadsEachFileOnce) {
    const files::TemporaryFolder folder;
    const fs::path file = write_camera(folder);
    Workspace workspace;
    const auto first = workspace.make_camera(file);
    ASSERT_TRUE(first) << to_text(first.diagnostics);
    for (const char* name : {"a.cam", "lengths.cam", "path.csv", "wall.obj"}) {
        fs::remove(folder.path() / name);
    }
    const auto second = workspace.make_camera(file, "c", {{"height", "0.5"}});
    ASSERT_TRUE(second) << to_text(second.diagnostics);
    EXPECT_NE(height_of(*first), height_of(*second));
    workspace.reload();
    EXPECT_FALSE(workspace.make_camera(file));
}

// Also those that do not exist, so that one sees them appear.
TEST(Workspace, NamesTheFilesThatItReads) {
    const files::TemporaryFolder folder;
    const fs::path file = write_camera(folder);
    fs::remove(folder.path() / "lengths.cam");
    Workspace workspace;
    EXPECT_FALSE(workspace.make_camera(file));
    const auto has = [&](const char* name) {
        const std::vector<fs::path> files = workspace.files();
        return std::any_of(files.begin(), files.end(),
                           [&](const fs::path& one) { return one == folder.path() / name; });
    };
    EXPECT_TRUE(has("a.cam"));
    EXPECT_TRUE(has("lengths.cam"));
    folder.write("lengths.cam", "let far = 3\n");
    workspace.reload();
    EXPECT_FALSE(has("a.cam"));
    EXPECT_TRUE(workspace.make_camera(file));
    for (const char* name : {"a.cam", "lengths.cam", "path.csv", "wall.obj"}) {
        EXPECT_TRUE(has(name)) << name;
    }
}

TEST(Workspace, NoticesChangesWhenAskedTo) {
    const files::TemporaryFolder folder;
    const auto camera = [](const char* radius) {
        return test::joined({"camera c { map u = 0deg .. 90deg, v = 0 .. 1  eye circle(", radius,
                             ") look tangent }"});
    };
    const fs::path file = folder.write("a.cam", camera("2"));
    Workspace workspace;
    const auto radius = [&] {
        return test::ray(*workspace.make_camera(file), 0, 0, 1, 1).origin[0];
    };
    EXPECT_EQ(radius(), 2.0);
    folder.write("a.cam", camera("3"));
    EXPECT_EQ(radius(), 2.0);
    workspace.reload();
    EXPECT_EQ(radius(), 3.0);
}

TEST(Workspace, ReportsTheSameErrorsAgain) {
    const files::TemporaryFolder folder;
    const fs::path file = folder.write("a.cam", "camera c { eye spere(1) map u = 0 .. 1 = }");
    Workspace workspace;
    const std::string first = to_text(workspace.make_picture(file).diagnostics);
    EXPECT_NE(first, "");
    EXPECT_EQ(to_text(workspace.make_picture(file).diagnostics), first);
}

TEST(Workspace, ExplainsWhatItMakes) {
    Workspace workspace;
    const auto made = workspace.explain("pinhole", "", {{"fov", "90deg"}});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->picture.name(), "pinhole");
    EXPECT_EQ(made->explanation.parameters.front().value, "90deg");
}

// ------------------------------------------------------------------- stages of a program

class Saddle : public camera::ObjectGenerator {
public:
    explicit Saddle(camera::Scalar height) : height_(std::move(height)) {}
    int dimension() const override { return 2; }
    camera::ObjectPoint generate(const camera::ParameterPoint& p,
                                 camera::Emitter& emit) const override {
        return {p.u, p.v, emit(height_) * p.u * p.v};
    }

private:
    camera::Scalar height_;
};

camera::Catalogue with_saddle() {
    camera::Catalogue own;
    const Diagnostics found = own.add(
        {.kind = camera::StageKind::object_generator,
         .name = "saddle",
         .meaning = "a hyperbolic paraboloid",
         .parameters = {{.name = "height",
                         .type = camera::NumberParameter{.default_value = 1.0,
                                                         .range = {.minimum = 0.0}},
                         .meaning = "z at u = v = 1"}},
         .make = [](const camera::Arguments& a) -> Result<std::shared_ptr<const camera::Stage>> {
             return {std::make_shared<const Saddle>(a.number("height"))};
         },
         .dimension = 2});
    EXPECT_EQ(to_text(found), "");
    return own;
}

std::shared_ptr<const SourceText> text_of(std::string_view eye) {
    return std::make_shared<const SourceText>(
        "test.cam",
        test::joined({"camera c { map u = -1 .. 1, v = -1 .. 1  eye ", eye, " look normal }"}));
}

TEST(Workspace, KnowsStagesOfAProgram) {
    Workspace workspace(with_saddle());
    const auto made = workspace.make_camera(text_of("saddle(2)"));
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(test::ray(*made, 1.0, 0.0, 1.0, 1.0).origin[2], 2.0);
    EXPECT_FALSE(Workspace().make_camera(text_of("saddle(2)")))
        << "the built-in stages are its own";
    const auto explained = workspace.explain(text_of("saddle"));
    ASSERT_TRUE(explained);
    EXPECT_EQ(explained->explanation.steps[1].meanings.front(), "saddle: a hyperbolic paraboloid");
}

// Nothing that a graph refuses leaves the library as an exception.
TEST(Workspace, ReportsWhatDoesNotFitIntoAGraph) {
    camera::Catalogue own;
    ASSERT_TRUE(own.add({.kind = camera::StageKind::object_generator,
                         .name = "endless",
                         .make = [](const camera::Arguments&)
                             -> Result<std::shared_ptr<const camera::Stage>> {
                             throw expr::GraphTooLarge();
                         }})
                    .empty());
    const auto made = Workspace(own).make_camera(text_of("endless"));
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_TRUE(made.diagnostics.front().message.starts_with("'endless' is too large"));
    EXPECT_NE(made.diagnostics.front().span.source, nullptr);
}

TEST(Workspace, ChecksStagesOfAProgramAsItsOwn) {
    Workspace workspace(with_saddle());
    const auto refused = [&workspace](std::string_view eye) {
        const auto made = workspace.make_camera(text_of(eye));
        return made.diagnostics.empty() ? Diagnostic() : made.diagnostics.front();
    };
    EXPECT_EQ(refused("saddle(-1)").message, "'height' of 'saddle' must be at least 0, but is -1");
    EXPECT_EQ(refused("sadle(1)").remedy, "did you mean 'saddle'?");
    EXPECT_EQ(refused("product(saddle, circle)").message,
              "'g' of 'product' takes a curve, but this is a surface");
}

}  // namespace
}  // namespace balcony::lang::workspace_test
