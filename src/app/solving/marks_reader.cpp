// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Files of marks: docs/solve.md has their format.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "app/solving/constraint_entries.hpp"
#include "app/solving/contradictions.hpp"
#include "app/solving/parameter_entries.hpp"
#include "app/solving/rig_pictures.hpp"
#include "app/solving/yaml_entries.hpp"
#include "balcony/input_file.hpp"
#include "balcony/names.hpp"
#include "balcony/request.hpp"
#include "balcony/solving.hpp"
#include "data/files.hpp"
#include "data/yaml_places.hpp"

namespace balcony::app {

namespace {

using solve::Constraint;
using solve::ConstraintKind;
using solve::Mark;
using solve::V2d;
using solve::V3d;

constexpr std::string_view whole_remedy =
    "a file of marks has the entries size, marks and constraints, or boards";
constexpr std::string_view place_remedy =
    "write a point of space as [x, y, z], or as {point: [x, y, z]} or {direction: [x, y, z]} with "
    "more about it";
constexpr std::string_view outline_remedy =
    "write the name of an object of the scene, or {object: NAME} or {points: [[x, y, z], ...]} "
    "with more about it";

class MarksReader {
public:
    explicit MarksReader(const std::shared_ptr<const SourceText>& source)
        : source_(source), yaml_(source) {}

    Result<Marks> run() {
        try {
            read(YAML::Load(std::string(source_->text())));
        } catch (const YAML::Exception& problem) {
            yaml_.error(data::place_of(source_, problem.mark, 1),
                        fmt::format("this is not YAML: {}", problem.msg),
                        std::string(whole_remedy));
        }
        if (has_errors(yaml_.found())) {
            return std::move(yaml_.found());
        }
        return {std::move(made_), std::move(yaml_.found())};
    }

private:
    void read(const YAML::Node& file) {
        std::map<std::string, YamlEntry> entries;
        for (YamlEntry& one :
             yaml_.map(file, "the file", whole_remedy,
                       {"size", "pictures", "scene", "axes", "origin", "unknowns", "fixed",
                        "targets", "marks", "outlines", "constraints", "boards"})) {
            entries.emplace(one.name, one);
        }
        if (has_errors(yaml_.found()) && entries.empty()) {
            return;
        }
        // Names are read before they are used.
        const std::vector<std::pair<std::string, void (MarksReader::*)(const YamlEntry&)>> readers{
            {"size", &MarksReader::size},
            {"pictures", &MarksReader::pictures},
            {"scene", &MarksReader::scene},
            {"axes", &MarksReader::axes},
            {"origin", &MarksReader::origin},
            {"unknowns", &MarksReader::unknowns},
            {"fixed", &MarksReader::fixed},
            {"targets", &MarksReader::targets},
            {"marks", &MarksReader::marks},
            {"outlines", &MarksReader::outlines},
            {"constraints", &MarksReader::constraints},
            {"boards", &MarksReader::boards}};
        for (const auto& [name, reader] : readers) {
            if (const auto entry = entries.find(name); entry != entries.end()) {
                (this->*reader)(entry->second);
            }
        }
        if (!entries.contains("size")) {
            yaml_.error({source_, 0, 0}, "the size of the picture is missing",
                        "write its width and height in pixels: size: [1920, 1080]");
        }
        if (made_.problem.constraints.empty() && !has_errors(yaml_.found())) {
            yaml_.error({source_, 0, 0}, "there is no constraint",
                        "say what the picture is to show: constraints: [{at: MARK, position: [x, "
                        "y]}]");
        }
        pictures_.begin_in_pictures();
        const Diagnostics contradictions = contradictions_of(made_.problem);
        yaml_.found().insert(yaml_.found().end(), contradictions.begin(), contradictions.end());
    }

    void size(const YamlEntry& entry) {
        const auto read = yaml_.position(entry.value);
        const auto is_side = [](double side) {
            return side >= 1.0 && side <= static_cast<double>(max_side) && side == std::floor(side);
        };
        if (read && !(is_side(read->x) && is_side(read->y))) {
            yaml_.error(yaml_.at(entry.value),
                        fmt::format("a picture cannot have {} x {} pixels", read->x, read->y),
                        fmt::format("write two whole numbers from 1 to {}", max_side));
        } else if (read) {
            made_.width = static_cast<std::size_t>(read->x);
            made_.height = static_cast<std::size_t>(read->y);
        }
    }

    void pictures(const YamlEntry& entry) { pictures_.read(entry); }

    void scene(const YamlEntry& entry) {
        made_.scene = yaml_.word(entry.value, "write the name of a scene file").value_or("");
    }

    void axes(const YamlEntry& entry) {
        const auto word = yaml_.word(entry.value, "write y_up or z_up");
        if (word && *word != "y_up" && *word != "z_up") {
            yaml_.error(yaml_.at(entry.value), fmt::format("there are no axes '{}'", *word),
                        "write y_up or z_up");
        } else if (word) {
            made_.axes = *word == "y_up" ? Axes::y_up : Axes::z_up;
        }
    }

    /// As calibrated cameras have it.
    void origin(const YamlEntry& entry) {
        const auto word = yaml_.word(entry.value, "write pixel_center or pixel_corner");
        if (word && *word != "pixel_center" && *word != "pixel_corner") {
            yaml_.error(yaml_.at(entry.value), fmt::format("there is no origin '{}'", *word),
                        "write pixel_center, as OpenCV counts, or pixel_corner");
        } else if (word) {
            from_corner_ = *word == "pixel_center" ? V2d(0.5) : V2d(0.0);
        }
    }

    std::optional<V2d> position(const YAML::Node& node) {
        const auto read = yaml_.position(node);
        return read ? std::optional(*read + from_corner_) : std::nullopt;
    }

    void unknowns(const YamlEntry& entry) { made_.unknowns = read_unknowns(entry, yaml_); }
    void fixed(const YamlEntry& entry) { made_.fixed = read_fixed(entry, yaml_); }

    // ----------------------------------------------------------------------------------- marks
    void targets(const YamlEntry& entry) {
        constexpr std::string_view remedy =
            "write its name with null, or with {start: {rotation: [x, y, z], translation: [x, y, "
            "z]}}";
        for (const YamlEntry& one : yaml_.map(entry.value, "'targets'", remedy)) {
            solve::Target target;
            target.name = one.name;
            if (!one.value.IsNull()) {
                start(one, target, remedy);
            }
            targets_.push_back(one.name);
            made_.problem.targets.push_back(std::move(target));
        }
    }

    void start(const YamlEntry& entry, solve::Target& target, std::string_view remedy) {
        for (const YamlEntry& one :
             yaml_.map(entry.value, fmt::format("'{}'", entry.name), remedy, {"start"})) {
            solve::Pose pose;
            for (const YamlEntry& part :
                 yaml_.map(one.value, "'start'", remedy, {"rotation", "translation"})) {
                V3d& vector = part.name == "rotation" ? pose.rotation : pose.translation;
                vector = yaml_.vector(part.value, remedy).value_or(vector);
            }
            target.start = pose;
        }
    }

    void marks(const YamlEntry& entry) {
        for (const YamlEntry& one : yaml_.map(entry.value, "'marks'", place_remedy)) {
            Mark mark;
            mark.name = one.name;
            mark.written = one.written;
            if (one.value.IsMap()) {
                place(one, mark);
            } else {
                mark.place = yaml_.vector(one.value, place_remedy).value_or(mark.place);
            }
            marks_.push_back(one.name);
            made_.problem.marks.push_back(std::move(mark));
        }
        for (const auto& [mark, ends] : directions_) {
            direction(mark, ends);
        }
    }

    void direction(std::size_t mark, const YAML::Node& ends) {
        Marks::Direction made{mark, {}, yaml_.at(ends)};
        for (std::size_t i = 0; i < made.ends.size(); ++i) {
            const auto end = yaml_.index_of(ends[i], marks_, "mark");
            if (!end) {
                return;
            }
            made.ends[i] = *end;
            const Mark& point = made_.problem.marks[*end];
            if (point.at_infinity || point.target) {
                yaml_.error(yaml_.at(ends[i]),
                            fmt::format("the mark '{}' is {}", point.name,
                                        point.at_infinity ? "a direction" : "on a target"),
                            "write two marks that are points of space");
                return;
            }
        }
        made_.directions.push_back(made);
    }

    void place(const YamlEntry& entry, Mark& mark) {
        std::size_t places = 0;
        Marks::OnObject on{made_.problem.marks.size(), {}, V3d(0.0), entry.written};
        std::optional<V3d> part;
        for (const YamlEntry& one :
             yaml_.map(entry.value, fmt::format("the mark '{}'", entry.name), place_remedy,
                       {"point", "direction", "object", "part", "target", "near"})) {
            if (one.name == "target") {
                mark.target = yaml_.index_of(one.value, targets_, "target");
            } else if (one.name == "near") {
                mark.near = position(one.value);
            } else if (one.name == "part") {
                part = yaml_.vector(one.value, "write where in the box of the object: [-1, 0, 1]");
            } else if (one.name == "object") {
                ++places;
                on.object = yaml_.word(one.value, "write the name of an object").value_or("");
            } else if (one.name == "direction" && one.value.IsSequence() && one.value.size() == 2) {
                ++places;
                mark.at_infinity = true;
                mark.place = V3d(1.0);
                directions_.emplace_back(made_.problem.marks.size(), one.value);
            } else {
                ++places;
                mark.at_infinity = one.name == "direction";
                mark.place = yaml_.vector(one.value, place_remedy).value_or(V3d(1.0));
            }
        }
        if (places != 1) {
            yaml_.error(entry.written,
                        fmt::format("the mark '{}' is at {} place", entry.name,
                                    places == 0 ? "no" : "more than one"),
                        std::string(place_remedy));
        } else if (mark.at_infinity && !(mark.place.length2() > 0.0)) {
            yaml_.error(entry.written,
                        fmt::format("the direction of the mark '{}' has no length", entry.name),
                        "write a direction such as [1, 0, 0]");
        } else if (mark.at_infinity && mark.target) {
            yaml_.error(
                entry.written,
                fmt::format("the mark '{}' is a direction and belongs to a target", entry.name),
                "remove the target, or write a point of it");
        } else if (part && on.object.empty()) {
            yaml_.error(entry.written,
                        fmt::format("the mark '{}' has a part of no object", entry.name),
                        "add object: NAME, or remove the part");
        } else if (!on.object.empty() && (made_.scene.empty() || mark.target)) {
            yaml_.error(entry.written,
                        fmt::format("the mark '{}' is on an object of no scene", entry.name),
                        mark.target ? "remove the target" : "add the entry scene: FILE");
        } else if (!on.object.empty()) {
            on.part = part.value_or(V3d(0.0));
            made_.on_objects.push_back(std::move(on));
        }
    }

    // -------------------------------------------------------------------------------- outlines
    void outlines(const YamlEntry& entry) {
        for (const YamlEntry& one : yaml_.map(entry.value, "'outlines'", outline_remedy)) {
            solve::Outline outline;
            outline.name = one.name;
            outline.written = one.written;
            std::optional<std::string> object;
            if (one.value.IsMap()) {
                object = points(one, outline);
            } else {
                object = yaml_.word(one.value, outline_remedy);
            }
            if (object && made_.scene.empty()) {
                yaml_.error(one.written,
                            fmt::format("'{}' is the outline of an object of no scene", one.name),
                            "add the entry scene: FILE");
            } else if (object) {
                made_.outlines_of_objects.push_back(
                    {outlines_.size(), std::move(*object), one.written});
            }
            outlines_.push_back(one.name);
            made_.problem.outlines.push_back(std::move(outline));
        }
    }

    /// The object, if the outline is of one.
    std::optional<std::string> points(const YamlEntry& entry, solve::Outline& outline) {
        std::optional<std::string> object;
        for (const YamlEntry& one :
             yaml_.map(entry.value, fmt::format("the outline '{}'", entry.name), outline_remedy,
                       {"object", "points", "near"})) {
            if (one.name == "object") {
                object = yaml_.word(one.value, outline_remedy);
            } else if (one.name == "near") {
                outline.near = position(one.value);
            } else {
                for (const YAML::Node& point : yaml_.list(one.value)) {
                    if (const auto read = yaml_.vector(point, outline_remedy)) {
                        outline.points.push_back(*read);
                    }
                }
            }
        }
        if (object.has_value() != outline.points.empty() && !has_errors(yaml_.found())) {
            yaml_.error(entry.written,
                        fmt::format("the outline '{}' has {}", entry.name,
                                    object ? "an object and points" : "no points"),
                        std::string(outline_remedy));
        }
        return object;
    }

    // ----------------------------------------------------------------------------- constraints
    void constraints(const YamlEntry& entry) {
        if (!entry.value.IsSequence()) {
            yaml_.error(yaml_.at(entry.value), "'constraints' is not a list",
                        std::string(ConstraintReader::remedy));
            return;
        }
        for (const YAML::Node& row : entry.value) {
            if (yaml_.goes_on()) {
                constraint(row);
            }
        }
    }

    void constraint(const YAML::Node& row) {
        const std::optional<std::size_t> picture = pictures_.of_row(row);
        if (!picture) {
            return;
        }
        const V2d from_corner = from_corner_ + pictures_.corner_of(*picture);
        const ConstraintReader reader(yaml_, marks_, outlines_, from_corner);
        for (auto& [constraint, label] : reader.read(row)) {
            if (pictures_.show(constraint, *picture)) {
                add(std::move(constraint), label + pictures_.words_for(*picture));
            }
        }
    }

    void add(Constraint constraint, std::string label) {
        made_.problem.constraints.push_back(std::move(constraint));
        made_.labels.push_back(std::move(label));
    }

    // ---------------------------------------------------------------------------------- boards
    void boards(const YamlEntry& entry) {
        std::size_t number = 0;
        for (const YAML::Node& one : yaml_.list(entry.value)) {
            if (yaml_.goes_on()) {
                board(one, ++number);
            }
        }
    }

    /// The corners of a chessboard, row by row, as OpenCV's findChessboardCorners gives them.
    void board(const YAML::Node& node, std::size_t number) {
        constexpr std::size_t most = 1000;
        const std::string what = fmt::format("board {}", number);
        std::size_t columns = 0;
        std::size_t rows = 0;
        double square = 1.0;
        YAML::Node corners;
        const std::vector<YamlEntry> entries = yaml_.map(
            node, what, "write {columns: 9, rows: 6, square: 0.025, corners: [[x, y], ...]}",
            {"columns", "rows", "square", "corners", "deviation", "weight", "tolerance"});
        for (const YamlEntry& one : entries) {
            if (one.name == "columns") {
                columns = yaml_.count(one, most).value_or(0);
            } else if (one.name == "rows") {
                rows = yaml_.count(one, most).value_or(0);
            } else if (one.name == "square") {
                square = yaml_.positive(one).value_or(1.0);
            } else if (one.name == "corners") {
                corners.reset(one.value);
            }
        }
        Constraint like;
        read_measure(entries, yaml_, like);
        solve::Target target;
        target.name = what;
        made_.problem.targets.push_back(target);
        const std::vector<std::string>& names = pictures_.names();
        if (names.empty() || corners.IsNull()) {
            add_corners(corners.IsSequence() ? corners : node, {columns, rows}, square, what, 0,
                        like);
            return;
        }
        for (const YamlEntry& one :
             yaml_.map(corners, fmt::format("'corners' of {}", what),
                       fmt::format("write the corners in each picture that shows the board: "
                                   "corners: {{{}: [[x, y], ...]}}",
                                   names.front()),
                       names)) {
            const auto picture = std::find(names.begin(), names.end(), one.name) - names.begin();
            add_corners(one.value, {columns, rows}, square, what, static_cast<std::size_t>(picture),
                        like);
        }
    }

    /// Those that one picture shows of the board that is the last target.
    void add_corners(const YAML::Node& corners, const std::array<std::size_t, 2>& sides,
                     double square, const std::string& what, std::size_t picture, Constraint like) {
        const std::size_t count = sides[0] * sides[1];
        if (count == 0 || !corners.IsSequence() || corners.size() != count) {
            yaml_.error(yaml_.at(corners),
                        fmt::format("{} needs columns x rows = {} corners, but has {}", what, count,
                                    corners.IsSequence() ? corners.size() : 0),
                        "write the positions of the inner corners row by row, with null for one "
                        "that is not seen");
            return;
        }
        for (std::size_t i = 0; i < count && yaml_.goes_on(); ++i) {
            const auto at = corners[i].IsNull() ? std::nullopt : position(corners[i]);
            if (at) {
                Mark mark;
                mark.place = square * V3d(static_cast<double>(i % sides[0]),
                                          static_cast<double>(i / sides[0]), 0.0);
                mark.target = made_.problem.targets.size() - 1;
                mark.name =
                    fmt::format("corner {} of {}{}", i + 1, what, pictures_.words_for(picture));
                mark.written = yaml_.at(corners[i]);
                mark.near = *at + pictures_.corner_of(picture);
                like.kind = ConstraintKind::at;
                like.written = mark.written;
                like.marks = {made_.problem.marks.size()};
                like.position = *mark.near;
                std::string label = mark.name;
                made_.problem.marks.push_back(std::move(mark));
                add(like, std::move(label));
            }
        }
    }

    std::shared_ptr<const SourceText> source_;
    YamlEntries yaml_;
    Marks made_;
    RigPictures pictures_{yaml_, made_};
    std::vector<std::string> marks_;  ///< Names, by index.
    /// Marks in the direction from one mark to another, which may follow.
    std::vector<std::pair<std::size_t, YAML::Node>> directions_;
    std::vector<std::string> targets_;  ///< The same.
    std::vector<std::string> outlines_;
    V2d from_corner_{0.0};  ///< Of the position [0, 0].
};

}  // namespace

Result<Marks> read_marks(const std::shared_ptr<const SourceText>& text) {
    return MarksReader(text).run();
}

Result<Marks> read_marks(const std::filesystem::path& file) {
    constexpr std::size_t largest = 16'000'000;
    if (const auto fault = not_a_file(file, fmt::format("'{}'", file.string()))) {
        return *fault;
    }
    const auto source =
        data::read_text(data::File::on_disk(file), largest, "write the marks as a text in YAML");
    return source ? read_marks(*source) : Result<Marks>(source.diagnostics);
}

}  // namespace balcony::app
