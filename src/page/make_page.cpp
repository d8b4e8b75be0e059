// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exports/parameter_json.hpp"
#include "balcony/camera_export.hpp"
#include "balcony/inputs.hpp"
#include "balcony/lang.hpp"
#include "balcony/page.hpp"
#include "balcony/picture_shader.hpp"
#include "balcony/prepared_scene.hpp"
#include "base/markup.hpp"
#include "page/blob.hpp"
#include "page/scene_data.hpp"
#include "page/textures.hpp"
#include "page/viewer.hpp"

namespace balcony::page {

namespace {

using nlohmann::json;

/// The values of open parameters as they are, so that none of them depends on another one, as those
/// of a `fit` statement may.
std::vector<lang::Override> literal_values(std::vector<lang::Override> given,
                                           const std::vector<lang::OpenParameter>& open) {
    for (const lang::OpenParameter& parameter : open) {
        given.push_back({parameter.name, lang::literal(parameter.value, parameter.is_angle)});
    }
    return given;
}

/// The picture with its parameters; a camera of the scene, or the default one, has none.
Result<lang::OpenPicture> picture_of(const PageRequest& request, app::PreparedScene& scene,
                                     const std::stop_token& stop) {
    const app::Request& wanted = request.picture;
    if (!wanted.camera.empty() && !app::is_of_scene(wanted.camera)) {
        const Result<app::CameraArgument> camera = app::read_camera(wanted.camera, wanted.set);
        if (!camera) {
            return camera.diagnostics;
        }
        const auto make = [&](const std::vector<lang::Override>& values) {
            return scene.picture(camera->file, camera->name, values, stop, request.open);
        };
        Result<lang::OpenPicture> made = make(camera->overrides);
        return made && wanted.placement.places(wanted.camera)
                   ? make(literal_values(camera->overrides, made->open))
                   : made;
    }
    Result<camera::Picture> made =
        wanted.camera.empty() ? app::default_picture(*scene.scene(), scene.renderer(), stop)
                              : app::load_picture(wanted.camera, wanted.set, *scene.scene(), stop);
    if (!made) {
        return std::move(made.diagnostics);
    }
    return {lang::OpenPicture{made->with_fit(wanted.size.fit), {}, {}, {}},
            std::move(made.diagnostics)};
}

std::string title_of(const PageRequest& request, const camera::Picture& picture) {
    return !request.title.empty()
               ? request.title
               : fmt::format("{}: {}", std::filesystem::path(request.picture.scene).stem().string(),
                             picture.name());
}

/// JSON that is the contents of an element: no text in it ends the element or begins a comment.
std::string as_element(const json& data) {
    std::string made;
    for (const char c : data.dump(-1, ' ', true, json::error_handler_t::replace)) {
        made += c == '<' ? "\\u003c" : std::string(1, c);
    }
    return made;
}

std::string page_of(const std::string& title, const json& data, const Blob& blob) {
    const std::string_view frame = viewer();
    const std::size_t title_at = frame.find(title_mark);
    const std::size_t data_at = frame.find(data_mark);
    std::string html;
    html += frame.substr(0, title_at);
    html += markup_of(printable(title));
    html += frame.substr(title_at + title_mark.size(), data_at - title_at - title_mark.size());
    html += "<script type=\"application/json\" id=\"data\">" + as_element(data) + "</script>\n";
    html += "<script type=\"text/plain\" id=\"bytes\">" + blob.base64() + "</script>";
    html += frame.substr(data_at + data_mark.size());
    return html;
}

Diagnostics too_large(const scene::Scene& scene, std::size_t triangles) {
    if (triangles <= max_triangles) {
        return {};
    }
    return {error(fmt::format("scene '{}' has {} triangles, and a page at most {}", scene.name,
                              triangles, max_triangles),
                  {},
                  "leave objects out, or make their meshes coarser, as Blender's modifier Decimate "
                  "does")};
}

Diagnostics heavy(std::size_t bytes) {
    if (bytes <= heavy_page_bytes) {
        return {};
    }
    return {warning(
        fmt::format("the page has {} MB, which phones may not open", (bytes + 500'000) / 1'000'000),
        {}, "make its images smaller, --texture-side 512, or its meshes coarser")};
}

void add(Diagnostics& all, const Diagnostics& found) {
    all.insert(all.end(), found.begin(), found.end());
}

}  // namespace

Result<Page> make_page(const PageRequest& request, const app::Observer& observer,
                       const std::stop_token& stop) {
    if (viewer().empty()) {
        return error(Kind::environment, "this Balcony was built without the viewer of pages",
                     "get its packages with 'scripts/studio --setup' and build again");
    }
    Result<app::PreparedScene> prepared = app::PreparedScene::make(request.picture, observer, stop);
    if (!prepared) {
        return std::move(prepared.diagnostics);
    }
    const Result<lang::OpenPicture> opened = picture_of(request, *prepared, stop);
    if (!opened) {
        return opened.diagnostics;
    }
    Diagnostics found = std::move(prepared.diagnostics);
    add(found, opened.diagnostics);
    const scene::Scene& scene = *prepared->scene();
    Page made;
    made.triangles = scene.triangle_count();
    Diagnostics large = too_large(scene, made.triangles);
    if (!large.empty()) {
        return large;
    }
    const camera::Picture& picture = opened->picture;
    const auto [width, height] =
        request.picture.size.resolve(picture.aspect(), picture.parts().size);
    made.size = {width, height};
    Result<bridge::PictureShader> shader = bridge::export_picture_shader(
        picture, app::export_parameters(opened->open), scene.axes, made.size);
    add(found, shader.diagnostics);
    if (!shader) {
        return found;
    }
    const Result<double> exposure = prepared->exposure(picture, "preview", stop);
    if (!exposure) {
        return exposure.diagnostics;
    }

    Blob blob;
    const std::set<scene::TextureIndex> textures = shown_textures(scene);
    made.textures = textures.size();
    json data = scene_data(scene, textures, blob);
    const Result<json> images = add_textures(scene, textures, request.texture_side, blob);
    add(found, images.diagnostics);
    data["textures"] = *images;
    data["parameters"] = json::array();
    for (const lang::OpenParameter& parameter : opened->open) {
        data["parameters"].push_back(app::told_of(parameter));
        made.open.push_back(parameter.name);
    }
    made.closed = opened->closed;
    const std::string title = title_of(request, picture);
    const auto& background = request.picture.settings.background;
    data["title"] = title;
    data["version"] = BALCONY_VERSION;
    data["size"] = made.size;
    data["time"] = request.picture.settings.time;
    data["hasTime"] = shader->has_time;
    data["hasLens"] = shader->has_lens;
    data["exposure"] = *exposure;
    data["background"] = background ? json({background->x, background->y, background->z}) : json();
    data["shader"] = shader->text;
    data["tables"] = {{"begin", blob.add(std::span<const float>(shader->table_numbers))},
                      {"count", shader->table_numbers.size()}};
    made.html = page_of(title, data, blob);
    add(found, heavy(made.html.size()));
    return {std::move(made), std::move(found)};
}

}  // namespace balcony::page
