// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: write_exports FOLDER
//
// Writes every example in every language into a folder, NAME.ENDING each, and exports.json: the
// picture, its points, and our own rays by example, for tests that run other programs.

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include "balcony/rays.hpp"
#include "examples.hpp"

namespace {

using namespace balcony;
using bridge::test::Example;
using nlohmann::json;

json vector_json(const rays::V3d& v) { return {v.x, v.y, v.z}; }

json rays_json(const Example& example) {
    const auto program = rays::compile(example.camera, bridge::test::width, bridge::test::height,
                                       {.footprints = true, .tiles = false, .points = true});
    std::vector<double> x;
    std::vector<double> y;
    for (const bridge::test::PicturePoint& point : bridge::test::points()) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    rays::Scratch scratch;
    rays::RayBatch batch;
    program->run({.x = x, .y = y}, scratch, batch);
    json all = json::array();
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const rays::Ray ray = batch[i];
        if (!ray.valid) {
            all.push_back(nullptr);
            continue;
        }
        all.push_back({{"origin", vector_json(ray.origin)},
                       {"direction", vector_json(ray.direction)},
                       {"origin_by_x", vector_json(ray.origin_by_x)},
                       {"origin_by_y", vector_json(ray.origin_by_y)},
                       {"direction_by_x", vector_json(ray.direction_by_x)},
                       {"direction_by_y", vector_json(ray.direction_by_y)}});
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: write_exports FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    json document{{"width", bridge::test::width}, {"height", bridge::test::height}};
    for (const bridge::test::PicturePoint& point : bridge::test::points()) {
        document["points"].push_back({point.x, point.y});
    }
    for (const Example& example : bridge::test::examples()) {
        json& entry = document["examples"][example.name];
        entry["rays"] = rays_json(example);
        entry["lens"] = example.camera.parts().lens != nullptr;
        entry["y_up"] = example.camera.parts().axes == Axes::y_up;
        for (const bridge::ExportTarget& target : bridge::export_targets()) {
            const auto text = target.write({example.camera}, {});
            if (text) {
                std::ofstream(folder / (example.name + std::string(target.ending))) << *text;
                entry["languages"].push_back(target.name);
            } else {
                entry["refused"][std::string(target.name)] = to_text(text.diagnostics);
            }
        }
    }
    std::ofstream(folder / "exports.json") << document;
    return 0;
}
