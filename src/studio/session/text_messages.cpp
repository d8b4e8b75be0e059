// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/text_messages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/exports/parameter_json.hpp"
#include "lsp/answers.hpp"
#include "lsp/rpc.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

json told_of_range(const SourceText& text, std::size_t begin, std::size_t end) {
    return begin < end ? lsp::range_in(text, begin, end) : json(nullptr);
}

json told_of_number(const SourceText& text, const lang::HandleNumber& one) {
    json made{{"value", one.value},
              {"angle", one.is_angle},
              {"moves", one.moves},
              {"range", told_of_range(text, one.begin, one.end)}};
    app::tell_limits(one.limits, made);
    if (!one.parameter.empty()) {
        made["parameter"] = one.parameter;
    }
    return made;
}

json told_of_handle(const SourceText& text, const lang::Handle& one) {
    json numbers = json::array();
    for (const lang::HandleNumber& number : one.numbers) {
        numbers.push_back(told_of_number(text, number));
    }
    return {{"kind", lang::name_of(one.kind)},
            {"statement", one.statement},
            {"stage", one.stage},
            {"parameter", one.parameter},
            {"index", one.index},
            {"meaning", one.meaning},
            {"range", told_of_range(text, one.begin, one.end)},
            {"numbers", std::move(numbers)}};
}

bool is_same(const json& one, const json& other) {
    constexpr std::array names{"statement", "stage", "parameter", "index", "range"};
    return std::all_of(names.begin(), names.end(),
                       [&](const char* name) { return one.at(name) == other.at(name); });
}

json edits_answer(const lang::EditedText& text, const Result<std::vector<lang::TextEdit>>& made) {
    if (!made) {
        throw lsp::Refusal{lsp::request_failed, to_text(made.diagnostics)};
    }
    json edits = json::array();
    for (const lang::TextEdit& edit : *made) {
        edits.push_back(lsp::edit_in(*text.text(), edit));
    }
    return {{"edits", std::move(edits)}};
}

}  // namespace

json handles_answer(const lang::EditedText& text, const std::string& camera) {
    json handles = json::array();
    for (const lang::Handle& one : text.handles(camera)) {
        handles.push_back(told_of_handle(*text.text(), one));
    }
    return {{"handles", std::move(handles)}};
}

json moved_answer(const lang::EditedText& text, const std::string& camera, const json& asked) {
    std::vector<lang::HandleMove> moves;
    for (const json& one : asked.at("moves")) {
        moves.push_back(
            {index_of(one.at("number")), one.at("value").get<double>(), one.value("step", 0.0)});
    }
    for (const lang::Handle& one : text.handles(camera)) {
        if (is_same(told_of_handle(*text.text(), one), asked.at("handle"))) {
            return edits_answer(text, text.moved(camera, one, moves));
        }
    }
    throw lsp::Refusal{lsp::request_failed,
                       "the text has no such handle: ask for its handles again"};
}

namespace {

// The frame is that of films.
lang::KeyTime key_time_of(const json& asked) {
    return {.time = asked.value("time", 0.0),
            .frame = asked.value("frame", lang::KeyTime().frame),
            .begins_keys = asked.value("keys", false)};
}

}  // namespace

json keys_answer(const lang::EditedText& text, const std::string& camera) {
    json keys = json::array();
    for (const lang::ParameterKeys& one : text.keys(camera)) {
        keys.push_back({{"parameter", one.parameter}, {"times", one.times}});
    }
    return {{"keys", std::move(keys)}};
}

json without_keys_answer(const lang::EditedText& text, const std::string& camera,
                         const json& asked) {
    return edits_answer(text, text.without_keys(camera, key_time_of(asked)));
}

json values_answer(const lang::EditedText& text, const std::string& camera, const json& asked) {
    std::vector<lang::ParameterMove> moves;
    for (const json& one : asked.at("values")) {
        moves.push_back({one.at("parameter").get<std::string>(), one.at("value").get<double>(),
                         one.value("step", 0.0)});
    }
    return edits_answer(text, text.with_values(camera, moves, key_time_of(asked)));
}

}  // namespace balcony::studio
