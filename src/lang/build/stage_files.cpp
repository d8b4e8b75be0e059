// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Arguments that are files: tables of points, images, meshes.

#include <fmt/format.h>

#include "lang/build/stages.hpp"

namespace balcony::lang {

namespace {

using camera::PointList;
using camera::StageEntry;
using camera::StageParameter;

}  // namespace

void StageBuilder::error(SourceSpan place, std::string message, std::string remedy) {
    Diagnostics diagnostics{
        balcony::error(std::move(message), std::move(place), std::move(remedy))};
    if (named_) {
        report_file(std::move(diagnostics), *named_);
    } else {
        reporter_.add(std::move(diagnostics.front()));
    }
}

// A diagnostic without a position gets that of the name in the camera file. A diagnostic in another
// file gets a note that shows where the file is used.
void StageBuilder::report_file(Diagnostics diagnostics, Span named) {
    for (Diagnostic& diagnostic : diagnostics) {
        if (!diagnostic.span.source) {
            diagnostic.span = tree_.at(named);
        } else if (diagnostic.span.source != tree_.source || diagnostic.span.begin < named.begin ||
                   diagnostic.span.end > named.end) {
            diagnostic.notes.push_back({tree_.at(named), "used here"});
        }
        reporter_.add(std::move(diagnostic));
    }
}

std::optional<data::File> StageBuilder::file(const StageEntry& row, const StageParameter& parameter,
                                             ExpressionId given, std::string_view what,
                                             std::string_view example) {
    const Expression& node = tree_[given];
    if (node.kind != ExpressionKind::text) {
        error(node.span, fmt::format("'{}' of '{}' takes {}", parameter.name, row.name, what),
              fmt::format("write a file name in quotation marks, for example \"{}\"", example));
        return std::nullopt;
    }
    const auto folder = module_.built_in ? std::nullopt : std::optional(module_.folder);
    Result<data::File> found = data::find_file(node.name.text, folder);
    report_file(std::move(found.diagnostics), node.span);
    return std::move(found.value);
}

// Two stages that name the same file share its contents.
template <class Data>
std::shared_ptr<const Data> StageBuilder::read_once(
    std::map<std::string, std::shared_ptr<const Data>>& known, const data::File& file,
    Result<std::shared_ptr<const Data>> (*read)(const data::File&), ExpressionId given) {
    const auto found = known.find(file.name);
    if (found != known.end()) {
        return found->second;
    }
    Result<std::shared_ptr<const Data>> made = read(file);
    report_file(std::move(made.diagnostics), tree_[given].span);
    return made ? known[file.name] = *made : nullptr;
}

std::shared_ptr<const camera::GreyImage> StageBuilder::image(const StageEntry& row,
                                                             const StageParameter& parameter,
                                                             ExpressionId given) {
    const auto found = file(row, parameter, given, "an image", "mask.png");
    return found ? read_once(session_.images(), *found, data::read_grey_image, given) : nullptr;
}

std::shared_ptr<const camera::TexturedMesh> StageBuilder::mesh(const StageEntry& row,
                                                               const StageParameter& parameter,
                                                               ExpressionId given) {
    const auto found = file(row, parameter, given, "a mesh", "vase.obj");
    return found ? read_once(session_.meshes(), *found, data::read_mesh, given) : nullptr;
}

// One point per line; a list of numbers may be in one line or in several.
std::optional<PointList> StageBuilder::table(const StageEntry& row, const StageParameter& parameter,
                                             ExpressionId given) {
    const auto found = file(row, parameter, given, "a table", "table.csv");
    if (!found) {
        return std::nullopt;
    }
    Result<data::NumberTable> read = data::read_table(*found);
    const Naming naming(*this, tree_[given]);
    if (!read) {
        report_file(std::move(read.diagnostics), tree_[given].span);
        return std::nullopt;
    }
    const bool numbers = parameter.coordinates == std::vector<std::size_t>{1};
    PointList made;
    bool good = true;
    for (const auto& line : read->rows) {
        std::vector<Element> point;
        for (const data::NumberTable::Number& number : line) {
            const Dimension dimension = number.angle ? Dimension::angle : Dimension::number;
            point.push_back({{graph_->constant(number.value), dimension}, read->at(number)});
        }
        const std::size_t step = numbers ? 1 : point.size();
        for (std::size_t i = 0; i < point.size(); i += step) {
            const std::span<const Element> one = std::span(point).subspan(i, step);
            good =
                add_point(row, parameter, join(one.front().place, one.back().place), one, made) &&
                good;
        }
        if (reporter_.full()) {
            return std::nullopt;
        }
    }
    return good && enough_points(row, parameter, made.size(), tree_[given].span)
               ? std::optional(std::move(made))
               : std::nullopt;
}

}  // namespace balcony::lang
