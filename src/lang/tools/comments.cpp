// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/tools/comments.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace balcony::lang {

namespace {

// A comment as text: without its marks, and without the space behind // of each line.
std::string comment_text(std::string_view comment) {
    if (comment.starts_with("//")) {
        comment.remove_prefix(comment.starts_with("// ") ? 3 : 2);
        return std::string(comment);
    }
    comment.remove_prefix(2);
    comment.remove_suffix(2);
    const std::size_t begin = comment.find_first_not_of(" \t\r\n");
    const std::size_t end = comment.find_last_not_of(" \t\r\n");
    return begin == std::string_view::npos ? std::string()
                                           : std::string(comment.substr(begin, end + 1 - begin));
}

}  // namespace

std::string comment_above(const SyntaxTree& tree, std::size_t offset) {
    std::vector<std::string> lines;
    const std::string_view text = tree.source->text();
    const auto below =
        std::partition_point(tree.comments.begin(), tree.comments.end(),
                             [offset](const Span& comment) { return comment.end <= offset; });
    for (auto comment = std::make_reverse_iterator(below); comment != tree.comments.rend();
         ++comment) {
        const std::string_view between = text.substr(comment->end, offset - comment->end);
        const bool touches = between.find_first_not_of(" \t\r\n") == std::string_view::npos &&
                             std::count(between.begin(), between.end(), '\n') <= 1;
        if (!touches) {
            break;
        }
        lines.push_back(comment_text(text.substr(comment->begin, comment->end - comment->begin)));
        offset = comment->begin;
    }
    std::string joined;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        joined += (joined.empty() ? "" : "\n") + *line;
    }
    return joined;
}

}  // namespace balcony::lang
