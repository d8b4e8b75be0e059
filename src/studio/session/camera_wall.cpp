// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/camera_wall.hpp"

#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/lang.hpp"
#include "balcony/language_service.hpp"
#include "balcony/studies.hpp"
#include "lsp/rpc.hpp"
#include "studio/session/frame_message.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

constexpr std::size_t largest_thumbnail = 512;

// No other file is read.
void require_built_in(const std::string& name) {
    if (lang::family_of(name).empty()) {
        throw lsp::Refusal{lsp::invalid_params, fmt::format("there is no built-in camera '{}': {}",
                                                            name, lang::instead_of_camera(name))};
    }
}

std::vector<std::string> names_of(const json& asked) {
    auto names = asked.get<std::vector<std::string>>();
    for (const std::string& name : names) {
        require_built_in(name);
    }
    return names;
}

}  // namespace

CameraWall::CameraWall(Server& server, const app::Request& request, Told told)
    : server_(server), request_(request), told_(std::move(told)) {}

const json& CameraWall::list() {
    if (!list_) {
        json cameras = json::array();
        const Result<std::vector<lang::Description>> described = app::describe_built_in();
        if (!described) {
            throw lsp::Refusal{lsp::request_failed, to_text(described.diagnostics)};
        }
        for (const lang::Description& one : *described) {
            cameras.push_back({{"name", one.name},
                               {"family", lang::family_of(one.name)},
                               {"about", one.comment},
                               {"keywords", one.keywords}});
        }
        list_ = std::make_unique<json>(json{{"cameras", std::move(cameras)}});
    }
    return *list_;
}

void CameraWall::show(const live::View& view, const json& asked) {
    const std::vector<std::string> names = names_of(asked.at("names"));
    const std::array size{
        count_of(asked.at("width"), largest_thumbnail, "the width of a thumbnail"),
        count_of(asked.at("height"), largest_thumbnail, "the height of a thumbnail")};
    if (!thumbnails_) {
        const std::optional<app::PreparedScene> scene = view.scene();
        if (!scene) {
            throw lsp::Refusal{lsp::request_failed, "no scene is loaded yet: ask again later"};
        }
        const auto made = [this](const live::Thumbnail& one) {
            const Bytes bytes =
                one.width > 0
                    ? std::make_shared<const std::vector<std::uint8_t>>(thumbnail_message(one))
                    : nullptr;
            server_.post([this, one, bytes] { take(one, bytes); });
        };
        thumbnails_ = std::make_unique<live::Thumbnails>(*scene, request_, made);
    }
    if (size != size_) {
        made_.clear();
        size_ = size;
    }
    std::vector<std::string> missing;
    for (const std::string& name : names) {
        if (const auto known = made_.find(name); known != made_.end()) {
            told_.picture(known->second);
        } else {
            missing.push_back(name);
        }
    }
    thumbnails_->show(missing, size);
}

void CameraWall::take(const live::Thumbnail& made, const Bytes& bytes) {
    if (made.room != size_) {
        return;
    }
    if (!bytes) {
        told_.failure(lsp::notification(
            "cameras/failed", {{"name", made.camera}, {"message", to_text(made.diagnostics)}}));
        return;
    }
    made_[made.camera] = bytes;
    told_.picture(bytes);
}

std::string camera_text(const std::string& built_in_camera) {
    require_built_in(built_in_camera);
    return std::string(lang::built_in_text(built_in_camera));
}

}  // namespace balcony::studio
