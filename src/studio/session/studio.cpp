// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/studio.hpp"

#include <utility>

#include <fmt/format.h>

#include "balcony/animation.hpp"
#include "balcony/export.hpp"
#include "balcony/stereo.hpp"
#include "lsp/open_text.hpp"
#include "lsp/rpc.hpp"
#include "studio/session/command_line.hpp"
#include "studio/session/page_client.hpp"
#include "studio/session/view_messages.hpp"
#include "studio/web/access.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

constexpr int protocol = 1;

/// The error code of a file that somebody else has written.
constexpr auto file_changed = static_cast<lsp::Code>(-32001);

json version_of(const std::optional<int>& version) {
    return version ? json(*version) : json(nullptr);
}

}  // namespace

Studio::Studio(Server& server, const Options& options, SharedText text)
    : server_(server),
      options_(options),
      text_(std::move(text)),
      uri_(lsp::uri_of(text_.file())),
      session_(random_token()),
      camera_(options.camera),
      questions_(text_.file().parent_path()),
      encoder_(
          {.frame =
               [this](const Bytes& frame) { server_.post([this, frame] { take_frame(frame); }); },
           .rest =
               [this](std::uint64_t change) {
                   server_.post([this, change] { take_rest(change); });
               }}),
      view_(live::View::load(options.request, observer(), {}, text_.file().parent_path())),
      inspection_(*view_, text_.file().parent_path()),
      search_(*view_, text_.file().parent_path()),
      checks_(*view_, text_.file().parent_path(), Inspection::Answers::newest),
      wall_(server, options.request,
            {.picture =
                 [this](const Bytes& picture) {
                     for (PageClient* const page : pages_) {
                         page->tell(picture);
                     }
                 },
             .failure = [this](const json& message) { tell_all(message); }}),
      renderings_(server, *view_, options, [this](const json& message) { tell_all(message); }) {
    scene_told_ = lsp::notification("studio/scene", {{"state", "loading"}});
    view_->change({.text = text_.text(), .camera = camera_, .size = options.size});
}

// What it tells of the camera and the scene goes to the pages on the thread of the server.
live::Observer Studio::observer() {
    const auto told = [this](auto function) {
        return [this, function](const auto& state) {
            server_.post([function, state] { function(state); });
        };
    };
    return {.frame = [this](const live::Frame& frame) { encoder_.show(frame); },
            .scene = told([this](const live::SceneState& state) {
                tell_all(scene_told_, "studio/scene", told_of(state));
            }),
            .camera = told([this](const live::CameraState& state) {
                parameters_ = state.open;
                for (const auto* const more : {&state.closed, &state.moving}) {
                    parameters_.insert(parameters_.end(), more->begin(), more->end());
                }
                tell_all(camera_told_, "view/camera", told_of(state));
            }),
            .drag = told([this](const live::Dragged& dragged) {
                tell_all(lsp::notification("view/dragged", told_of(dragged)));
            }),
            .rest = [this](std::uint64_t change) { encoder_.rest(change); }};
}

void Studio::join(PageClient& page) {
    pages_.insert(&page);
    for (const json* const told : {&scene_told_, &camera_told_}) {
        if (!told->is_null()) {
            page.tell(*told);
        }
    }
    if (frame_) {
        page.show(frame_);
    }
    if (!rest_told_.is_null()) {
        page.rest(rest_told_);
    }
}

void Studio::leave(PageClient& page) { pages_.erase(&page); }

json Studio::about() const {
    return {{"protocol", protocol},
            {"version", BALCONY_VERSION},
            {"session", session_},
            {"uri", uri_},
            {"text", text_.text()},
            {"textVersion", text_.version()},
            {"savedVersion", version_of(text_.saved_version())},
            {"camera", camera_},
            {"scene", options_.request.scene},
            {"readOnly", options_.is_read_only},
            {"size", options_.size},
            {"languages", choices_of(bridge::export_targets())},
            {"films", app::film_extensions()},
            {"stereoFormats", choices_of(camera::stereo_formats())},
            {"time", options_.request.settings.time},
            {"frameRate", 1.0 / options_.request.shutter.rate.frame_time()}};
}

bool Studio::take_text(int version, const std::string& text, const PageClient& by) {
    if (!text_.take(version, text)) {
        return false;
    }
    // The text says what the values are, until a hand moves them again.
    change_view({.text = text, .values = std::vector<live::Value>(), .drag = live::Drag()});
    const json told = text_message(&by);
    for (PageClient* const page : pages_) {
        if (page != &by) {
            page->replace_text(told);
        }
    }
    return true;
}

json Studio::text_message(const PageClient* by) const {
    return lsp::notification("studio/text",
                             {{"version", text_.version()},
                              {"text", text_.text()},
                              {"by", by != nullptr ? json(by->number()) : json(nullptr)}});
}

std::uint64_t Studio::change_view(live::Change change) {
    camera_ = change.camera.value_or(camera_);
    rest_told_ = nullptr;
    checks_.stop();
    return view_->change(std::move(change));
}

std::string Studio::command() const {
    const std::optional<live::Shown> shown = view_->shown();
    if (!shown) {
        throw lsp::Refusal{lsp::request_failed, "no picture is shown yet: ask again later"};
    }
    return command_line(options_, *shown, parameters_);
}

void Studio::save(bool replaces_changes) {
    if (options_.is_read_only) {
        throw lsp::Refusal{lsp::request_failed,
                           "this studio shows only: start it without --read-only to save"};
    }
    if (!replaces_changes && text_.has_changed_on_disk()) {
        throw lsp::Refusal{file_changed,
                           fmt::format("'{}' has changed on the disk: save again to replace it, or "
                                       "copy your text and restart the studio to read it",
                                       text_.file().string())};
    }
    if (const Diagnostics found = text_.save(); has_errors(found)) {
        throw lsp::Refusal{lsp::request_failed, to_text(found)};
    }
    tell_all(lsp::notification("studio/saved",
                               {{"version", text_.version()}, {"file", text_.file().string()}}));
}

void Studio::tell_all(const json& message) {
    for (PageClient* const page : pages_) {
        page->tell(message);
    }
}

void Studio::tell_all(json& last, std::string_view method, json told) {
    last = lsp::notification(method, std::move(told));
    tell_all(last);
}

void Studio::take_frame(const Bytes& frame) {
    frame_ = frame;
    for (PageClient* const page : pages_) {
        page->show(frame);
    }
}

void Studio::take_rest(std::uint64_t change) {
    rest_told_ = lsp::notification("view/rest", {{"change", change}});
    for (PageClient* const page : pages_) {
        page->rest(rest_told_);
    }
}

Diagnostics serve(const Options& options, const std::stop_token& stop) {
    Result<SharedText> text = SharedText::open(options.file, options.new_text);
    if (!text) {
        return text.diagnostics;
    }
    const Result<std::string> token = options.token_file.empty()
                                          ? Result<std::string>(random_token())
                                          : token_of(options.token_file);
    if (!token) {
        return token.diagnostics;
    }
    const auto server = Server::listen(options.port, *token);
    if (!server) {
        return server.diagnostics;
    }
    Studio studio(**server, options, std::move(*text));
    if (options.on_ready) {
        options.on_ready(fmt::format("http://127.0.0.1:{}/?token={}", (*server)->port(), *token));
    }
    (*server)->run(
        [&studio](Socket& socket) { return std::make_unique<PageClient>(studio, socket); }, stop);
    return {};
}

}  // namespace balcony::studio
