// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What all pages of a server share: the text, the view, and what was last told of it.
//
// Belongs to the thread of the server. What the view and the encoder tell is posted to it.

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "balcony/live.hpp"
#include "studio/serve.hpp"
#include "studio/session/camera_wall.hpp"
#include "studio/session/frame_encoder.hpp"
#include "studio/session/inspection.hpp"
#include "studio/session/renderings.hpp"
#include "studio/session/shared_text.hpp"
#include "studio/session/text_questions.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class PageClient;

class Studio {
public:
    Studio(Server& server, const Options& options, SharedText text);

    [[nodiscard]] Server& server() { return server_; }
    [[nodiscard]] const SharedText& text() const { return text_; }
    [[nodiscard]] const std::string& uri() const { return uri_; }
    /// That is asked for; empty for the last one of the text.
    [[nodiscard]] const std::string& camera() const { return camera_; }

    /// A page is there: it is told what there is.
    void join(PageClient& page);
    void leave(PageClient& page);

    /// What a page is told of all this at first.
    [[nodiscard]] nlohmann::json about() const;
    /// Another version of the text, which other pages are told. False if it was made of an older
    /// one.
    [[nodiscard]] bool take_text(int version, const std::string& text, const PageClient& by);
    [[nodiscard]] nlohmann::json text_message(const PageClient* by) const;
    /// The number of the change.
    std::uint64_t change_view(live::Change change);
    [[nodiscard]] TextQuestions& questions() { return questions_; }
    /// For quick answers, for those that may take seconds, and for checks of what is shown last.
    [[nodiscard]] Inspection& inspection() { return inspection_; }
    [[nodiscard]] Inspection& search() { return search_; }
    [[nodiscard]] Inspection& checks() { return checks_; }
    [[nodiscard]] CameraWall& wall() { return wall_; }
    [[nodiscard]] Renderings& renderings() { return renderings_; }
    /// What a shell renders the same by. Throws a Refusal.
    [[nodiscard]] std::string command() const;
    [[nodiscard]] const live::View& view() const { return *view_; }
    /// Writes the file, and tells the pages. Throws a Refusal.
    void save(bool replaces_changes);

private:
    [[nodiscard]] live::Observer observer();
    void tell_all(const nlohmann::json& message);
    void tell_all(nlohmann::json& last, std::string_view method, nlohmann::json told);
    void take_frame(const Bytes& frame);
    void take_rest(std::uint64_t change);

    Server& server_;
    Options options_;
    SharedText text_;
    std::string uri_;
    std::string session_;  ///< Another one for each start.
    std::string camera_;
    std::vector<lang::OpenParameter> parameters_;  ///< Of the camera that was last told.
    std::set<PageClient*> pages_;

    // What was last told; null if it was not.
    nlohmann::json scene_told_;
    nlohmann::json camera_told_;
    nlohmann::json rest_told_;
    Bytes frame_;

    TextQuestions questions_;
    FrameEncoder encoder_;
    std::unique_ptr<live::View> view_;  ///< Its thread uses the members before it.
    // Their threads use the view.
    Inspection inspection_;
    Inspection search_;
    Inspection checks_;
    CameraWall wall_;
    Renderings renderings_;
};

}  // namespace balcony::studio
