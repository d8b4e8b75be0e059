// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/messages.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace balcony::bridge::povray {

namespace {

constexpr std::string_view option_problem = "Problem with option setting";

/// The beginnings of messages in the output.
struct MessageKind {
    std::string_view begin;
    Severity severity;
};

constexpr std::array kinds{
    MessageKind{"Parse Error: ", Severity::error},
    MessageKind{"Possible Parse Error: ", Severity::warning},
    MessageKind{"Parse Warning: ", Severity::warning},
    MessageKind{"Possible Rendering Error: ", Severity::warning},
    MessageKind{"Render Warning: ", Severity::warning},
    MessageKind{"Fatal error in ", Severity::error},
    MessageKind{option_problem, Severity::error},
};

// POV-Ray breaks long lines and indents what follows.
std::vector<std::string> unbroken_lines(std::string_view output) {
    std::vector<std::string> lines;
    while (!output.empty()) {
        const std::size_t end = std::min(output.find_first_of("\r\n"), output.size());
        const std::string_view line = output.substr(0, end);
        if (line.starts_with(' ') && !lines.empty()) {
            lines.back() += line;
        } else {
            lines.emplace_back(line);
        }
        output.remove_prefix(std::min(end + 1, output.size()));
    }
    return lines;
}

/// A line such as "File 'scene.pov' line 7: Parse Error: ...", where the place may be missing.
struct Message {
    std::string file;
    std::size_t line = 0;
    MessageKind kind{};
    std::string text;
};

// Removes the place from a line.
void take_place(std::string_view& line, Message& message) {
    constexpr std::string_view file = "File '";
    constexpr std::string_view number = "' line ";
    const std::size_t end = line.find(number);
    if (!line.starts_with(file) || end == std::string_view::npos) {
        return;
    }
    const std::size_t colon = line.find(": ", end);
    if (colon == std::string_view::npos) {
        return;
    }
    message.file = line.substr(file.size(), end - file.size());
    const char* first = line.data() + end + number.size();
    std::from_chars(first, line.data() + colon, message.line);
    line.remove_prefix(colon + 2);
}

std::optional<Message> message_of(std::string_view line) {
    Message message;
    take_place(line, message);
    for (const MessageKind& kind : kinds) {
        if (line.starts_with(kind.begin)) {
            message.kind = kind;
            const bool is_label = kind.begin.ends_with(": ");
            message.text = line.substr(is_label ? kind.begin.size() : 0);
            while (message.text.ends_with('.') || message.text.ends_with(' ')) {
                message.text.pop_back();
            }
            return message;
        }
    }
    return std::nullopt;
}

// What is said about the camera that Balcony adds.
bool is_about_the_mesh_camera(const std::string& text) {
    return text.starts_with("More than one camera in scene") ||
           text.starts_with(
               "This rendering uses the following experimental feature(s): mesh camera.");
}

class MessageReader {
public:
    explicit MessageReader(const ScenePlaces& places) : places_(places) {}

    [[nodiscard]] Diagnostic operator()(const Message& message) const {
        const SourceSpan span = span_of(message);
        const std::string place = span.source || message.file.empty()
                                      ? ""
                                      : fmt::format(" ('{}' line {})", message.file, message.line);
        const std::string text = fmt::format("POV-Ray: {}{}", message.text, place);
        return message.kind.severity == Severity::error ? error(text, span, remedy_of(message))
                                                        : warning(text, span, remedy_of(message));
    }

private:
    // A line of the scene, or of a file that it includes.
    [[nodiscard]] SourceSpan span_of(const Message& message) const {
        std::shared_ptr<const SourceText> source;
        std::size_t line = message.line;
        if (message.file == places_.copy) {
            source = places_.scene;
            line = std::min(line, source->line_count());
        } else if (!message.file.empty()) {
            const std::filesystem::path file = places_.folder / message.file;
            std::ifstream in(file, std::ios::binary);
            if (in) {
                source = std::make_shared<const SourceText>(
                    message.file, std::string(std::istreambuf_iterator<char>(in), {}));
            }
        }
        if (!source || line == 0 || line > source->line_count()) {
            return {};
        }
        const auto begin =
            static_cast<std::size_t>(source->line(line).data() - source->text().data());
        return {source, begin, begin + source->line(line).size()};
    }

    [[nodiscard]] static std::string remedy_of(const Message& message) {
        if (message.text.find("IO Restrictions prohibit") != std::string::npos ||
            message.text.find("not permitted") != std::string::npos) {
            return "POV-Ray may read the folders that /etc/povray/3.7/povray.conf lists: add the "
                   "folder there, such as read* = /home/me/scenes";
        }
        return message.kind.begin == option_problem ? "check the options for POV-Ray after --" : "";
    }

    const ScenePlaces& places_;
};

}  // namespace

Diagnostics read_messages(std::string_view output, const ScenePlaces& places) {
    Diagnostics found;
    const MessageReader diagnostic_of(places);
    for (const std::string& line : unbroken_lines(output)) {
        const std::optional<Message> message = message_of(line);
        if (!message || is_about_the_mesh_camera(message->text)) {
            continue;
        }
        // The last words after a parse error add nothing to it.
        if (message->kind.begin == "Fatal error in " && has_errors(found)) {
            continue;
        }
        found.push_back(diagnostic_of(*message));
    }
    return found;
}

std::optional<double> read_progress(std::string_view output) {
    const std::size_t begin = output.rfind("Rendered ");
    if (begin == std::string_view::npos) {
        return std::nullopt;
    }
    constexpr std::string_view rendered = "Rendered ";
    constexpr std::string_view of = " of ";
    const std::string_view text = output.substr(begin + rendered.size());
    const std::size_t middle = text.find(of);
    if (middle == std::string_view::npos) {
        return std::nullopt;
    }
    double done = 0.0;
    double all = 0.0;
    std::from_chars(text.data(), text.data() + middle, done);
    std::from_chars(text.data() + middle + of.size(), text.data() + text.size(), all);
    return all > 0.0 ? std::optional(done / all) : std::nullopt;
}

}  // namespace balcony::bridge::povray
