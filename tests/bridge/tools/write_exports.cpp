// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Usage: write_exports FOLDER | --table PAGE
//
// Writes every example in every language into a folder, LANGUAGE/NAME.ENDING each, and
// exports.json: the picture, its points, and our own rays by example, for tests that run other
// programs. With --table, writes into a page of the documentation which cameras can be exported to
// what.

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/inverse.hpp"
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

// Every tenth point of the picture, at a distance of 2.7 on its ray, and where the camera shows it;
// for cameras whose text is not too long.
json located_json(const Example& example, const json& rays) {
    json all = json::array();
    if (example.camera.operations() >= 3000) {
        return all;
    }
    const auto locator =
        analyse::Locator::make(camera::Picture(example.camera).with_fit(camera::Fit::stretch),
                               bridge::test::width, bridge::test::height);
    for (std::size_t i = 0; locator && i < rays.size(); i += 10) {
        if (rays[i].is_null()) {
            continue;
        }
        analyse::V3d point;
        for (int k = 0; k < 3; ++k) {
            point[k] = rays[i]["origin"][static_cast<std::size_t>(k)].get<double>() +
                       2.7 * rays[i]["direction"][static_cast<std::size_t>(k)].get<double>();
        }
        json entry{{"point", vector_json(point)}, {"sightings", json::array()}};
        for (const analyse::Sighting& one : locator->locate(point)) {
            entry["sightings"].push_back({one.position.x, one.position.y, one.distance});
        }
        all.push_back(std::move(entry));
    }
    return all;
}

// The table: the built-in cameras and those of the plates, and the examples of stages that some
// language cannot express.
std::string table() {
    std::string header = "| camera |";
    std::string line = "|---|";
    for (const bridge::ExportTarget& target : bridge::export_targets()) {
        header += fmt::format(" {} |", target.name);
        line += "---|";
    }
    std::string rows;
    std::size_t everywhere = 0;
    for (const Example& example : bridge::test::examples()) {
        std::string row;
        bool all = true;
        for (const bridge::ExportTarget& target : bridge::export_targets()) {
            const bool made = export_camera(target, {example.camera}).value.has_value();
            row += made ? " yes |" : " no |";
            all = all && made;
        }
        if (!all || !example.of_stage) {
            rows += fmt::format("| {} |{}\n", example.shown, row);
        } else {
            ++everywhere;
        }
    }
    return fmt::format(
        "{}\n{}\n{}\nThe examples of the other {} stages can be exported to all of these.\n",
        header, line, rows, everywhere);
}

int write_table(const std::filesystem::path& page) {
    std::stringstream read;
    read << std::ifstream(page).rdbuf();
    std::string text = read.str();
    constexpr std::string_view begin = "<!-- exports -->\n";
    constexpr std::string_view end = "<!-- end of exports -->";
    const std::size_t first = text.find(begin);
    const std::size_t last = text.find(end);
    if (first == std::string::npos || last == std::string::npos) {
        std::cerr << page << " has no place for the table\n";
        return 1;
    }
    text.replace(first + begin.size(), last - first - begin.size(), table());
    std::ofstream(page) << text;
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "--table") {
        return write_table(argv[2]);
    }
    if (argc != 2) {
        std::cerr << "usage: write_exports FOLDER | --table PAGE\n";
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
        entry["located"] = located_json(example, entry["rays"]);
        entry["lens"] = example.camera.parts().lens != nullptr;
        entry["y_up"] = example.camera.parts().axes == Axes::y_up;
        for (const bridge::ExportTarget& target : bridge::export_targets()) {
            const auto text =
                export_camera(target, {example.camera}, {.inverse = !entry["located"].empty()});
            if (text) {
                std::filesystem::create_directories(folder / target.name);
                std::ofstream(folder / target.name / (example.name + std::string(target.ending)))
                    << text->text;
                entry["languages"].push_back(target.name);
            } else {
                entry["refused"][std::string(target.name)] = to_text(text.diagnostics);
            }
        }
    }
    std::ofstream(folder / "exports.json") << document;
    return 0;
}
