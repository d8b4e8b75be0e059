// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/picture_facts.hpp"

#include <limits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace balcony::dataset {

// The camera, its place and the layers are elsewhere in a recipe, and all of a picture is rendered.
app::Options<app::Request> frame_options() {
    using app::Request;
    app::Options<Request> made = app::scene_options();
    made.rows.push_back(app::time_option(std::numeric_limits<double>::max(), &Request::settings,
                                         &render::Settings::time));
    made.add(&Request::shutter, app::shutter_options());
    made.add(&Request::size, app::size_options("size in pixels"));
    made.add(app::sampling_options());
    made.add(&Request::settings, app::integrator_options());
    made.add(&Request::light, app::light_options());
    made.add(&Request::light, app::lamp_options());
    made.add(app::look_options());
    made.add(app::film_options());
    made.add(app::thread_options());
    return made.leave_out({"--camera", "--set", "--solve", "--fit", "--no-fit", "--fit-to",
                           "--from", "--layers", "--dpi"});
}

nlohmann::json picture_facts(const app::Request& picture) {
    nlohmann::json facts = nlohmann::json::object();
    for (const auto& row : frame_options().rows) {
        if (row.effect == app::Effect::run) {
            continue;
        }
        const std::vector<std::string> words = row.write(picture);
        if (!words.empty() && words != row.write(app::Request{})) {
            facts[row.name.substr(2)] =
                words.size() == 1 ? nlohmann::json(words.front()) : nlohmann::json(words);
        }
    }
    return facts;
}

app::Request scene_request(const app::Request& picture, std::string scene_file) {
    app::Request request = picture;
    request.scene = std::move(scene_file);
    request.camera.clear();
    return request;
}

}  // namespace balcony::dataset
