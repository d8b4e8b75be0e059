// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/frame_record.hpp"

#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/input_file.hpp"
#include "balcony/output_file.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;
using Ticks = fs::file_time_type::duration;

std::string dumped(const nlohmann::json& json) {
    constexpr int indent = 1;
    constexpr bool ascii_only = true;
    return json.dump(indent, ' ', ascii_only, nlohmann::json::error_handler_t::replace) + "\n";
}

nlohmann::json json_of(const render::RenderFacts& facts) {
    nlohmann::json json = nlohmann::json::array();
    for (const render::RenderFact& fact : facts) {
        json.push_back({fact.name, fact.value});
    }
    return json;
}

render::RenderFacts facts_of(const nlohmann::json& json) {
    render::RenderFacts facts;
    for (const nlohmann::json& fact : json) {
        facts.push_back({fact.at(0).get<std::string>(), fact.at(1).get<std::string>()});
    }
    return facts;
}

Diagnostics write_record(const FramePattern& pattern, const FrameRecord& record) {
    return write_whole(record_file(pattern),
                       dumped({{"facts", json_of(record.facts)},
                               {"frames", text_of(record.frames)},
                               {"fps", {record.rate.frames, record.rate.seconds}},
                               {"crf", record.crf ? nlohmann::json(*record.crf) : nlohmann::json()},
                               {"since", record.since.time_since_epoch().count()}}));
}

}  // namespace

// Bytes that are not UTF-8 were replaced when the record was written.
std::string FrameRecord::difference_from(const render::RenderFacts& now) const {
    return render::difference(facts, facts_of(nlohmann::json::parse(dumped(json_of(now)))));
}

bool FrameRecord::is_finished(const fs::path& frame) const {
    std::error_code failed;
    const fs::file_time_type written = fs::last_write_time(frame, failed);
    return !failed && written >= since && fs::file_size(frame, failed) > 0 && !failed;
}

fs::path record_file(const FramePattern& pattern) { return pattern.text() + ".animation"; }

Result<std::optional<FrameRecord>> read_record(const FramePattern& pattern) {
    const fs::path file = record_file(pattern);
    std::error_code failed;
    if (!fs::exists(file, failed)) {
        return std::optional<FrameRecord>();
    }
    std::ifstream stream;
    if (!not_a_file(file, "")) {
        stream.open(file);
    }
    const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
    try {
        FrameRecord record;
        record.facts = facts_of(json.at("facts"));
        record.frames = frame_numbers_of(json.at("frames").get<std::string>()).value();
        record.rate = {json.at("fps").at(0).get<double>(), json.at("fps").at(1).get<double>()};
        if (json.at("crf").is_number()) {
            record.crf = json.at("crf").get<double>();
        }
        record.since = fs::file_time_type(Ticks(json.at("since").get<Ticks::rep>()));
        return std::optional(std::move(record));
    } catch (const std::exception&) {
        return error(Kind::input, fmt::format("'{}' is damaged", file.string()),
                     "remove it and render with --overwrite, or name another output");
    }
}

Diagnostics change_record(const FramePattern& pattern, const FrameRecord& record) {
    return write_record(pattern, record);
}

// The time is that of a file which is written there, by the clock of that file system. Until it is
// known, no frame is finished.
Diagnostics begin_record(const FramePattern& pattern, FrameRecord& record) {
    record.since = fs::file_time_type::max();
    if (Diagnostics found = write_record(pattern, record); has_errors(found)) {
        return found;
    }
    std::error_code failed;
    const fs::path file = record_file(pattern);
    record.since = fs::last_write_time(file, failed);
    return failed
               ? Diagnostics{error(Kind::environment, fmt::format("'{}' cannot be read: {}",
                                                                  file.string(), failed.message()))}
               : write_record(pattern, record);
}

}  // namespace balcony::app
