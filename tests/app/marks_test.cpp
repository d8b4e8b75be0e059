// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Files of marks: what is read of them, and what is said of each mistake and where.

#include <gtest/gtest.h>

#include "balcony/solving.hpp"

namespace balcony::app::marks_test {
namespace {

using solve::ConstraintKind;
using solve::V2d;
using solve::V3d;

Result<Marks> read(const std::string& text) {
    return read_marks(std::make_shared<const SourceText>("marks.yml", text));
}

const std::string whole = R"(# What the photo shows.
size: [640, 480]
axes: y_up
unknowns:
  fov: {start: 50deg, range: [20deg, 1.5rad], deviation: 5deg}
  px:
fixed: [roll]
targets:
  box: {start: {rotation: [0, 0, 1], translation: [1, 2, 3]}}
  board:
marks:
  gable: [20, 4, -1.6]
  east: {direction: [0, 1, 0], near: [600, 100]}
  lid: {point: [0, 0, 1], target: box}
constraints:
  - {at: gable, position: [155, 347], deviation: 0.5, weight: 4}
  - level: [gable, lid]
    tolerance: 3
  - {inside: east}
  - {ratio: [gable, lid, gable, east], value: 2}
  - {magnification: [320, 240], value: 500, distance: 3}
  - {isotropic: [100, 50]}
boards:
  - {columns: 2, rows: 2, square: 0.5, corners: [[1, 2], null, [3, 4], [5, 6]], deviation: 0.2}
)";

/// A file with one mistake: what is said of it, with the place as line:column.
struct Mistake {
    std::string text;
    std::string place;
    std::string message;
    std::string remedy;
};

std::string replaced(const std::string& old, const std::string& by) {
    std::string text = whole;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
}

void check(const Mistake& mistake) {
    const auto marks = read(mistake.text);
    ASSERT_FALSE(marks) << mistake.text;
    const Diagnostic& said = marks.diagnostics.front();
    SCOPED_TRACE(to_text(said));
    EXPECT_EQ(said.message, mistake.message);
    EXPECT_EQ(said.remedy, mistake.remedy);
    ASSERT_TRUE(said.span.source);
    const LineColumn place = said.span.source->locate(said.span.begin);
    EXPECT_EQ(std::to_string(place.line) + ":" + std::to_string(place.column), mistake.place);
}

}  // namespace

TEST(Marks, AFileHasAllOfAProblem) {
    const auto marks = read(whole);
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    EXPECT_TRUE(marks.diagnostics.empty());
    EXPECT_EQ(marks->width, 640U);
    EXPECT_EQ(marks->height, 480U);
    EXPECT_EQ(marks->axes, Axes::y_up);
    ASSERT_TRUE(marks->unknowns && marks->fixed);
    ASSERT_EQ(marks->unknowns->size(), 2U);
    const Marks::Parameter& fov = marks->unknowns->front();
    EXPECT_EQ(fov.name, "fov");
    EXPECT_NEAR(fov.start->value, 0.8726646259971648, 1e-15);
    EXPECT_TRUE(fov.start->is_angle);
    EXPECT_EQ((*fov.range)[1].value, 1.5);
    EXPECT_NEAR(fov.deviation->value, 0.08726646259971647, 1e-16);
    EXPECT_FALSE((*marks->unknowns)[1].start);
    EXPECT_EQ(marks->fixed->front().name, "roll");

    const solve::Problem& problem = marks->problem;
    ASSERT_EQ(problem.targets.size(), 3U);
    EXPECT_EQ(problem.targets[0].start->translation, V3d(1, 2, 3));
    EXPECT_FALSE(problem.targets[1].start);
    EXPECT_EQ(problem.targets[2].name, "board 1");
    ASSERT_EQ(problem.marks.size(), 6U);
    EXPECT_EQ(problem.marks[0].place, V3d(20, 4, -1.6));
    EXPECT_TRUE(problem.marks[1].at_infinity);
    EXPECT_EQ(problem.marks[1].near, V2d(600, 100));
    EXPECT_EQ(problem.marks[2].target, 0U);
    EXPECT_EQ(problem.marks[5].place, V3d(0.5, 0.5, 0));
    EXPECT_EQ(problem.marks[5].target, 2U);

    ASSERT_EQ(problem.constraints.size(), 9U);
    EXPECT_EQ(problem.constraints[0].kind, ConstraintKind::at);
    EXPECT_EQ(problem.constraints[0].position, V2d(155, 347));
    EXPECT_EQ(problem.constraints[0].deviation, 0.25);
    EXPECT_EQ(problem.constraints[1].tolerance, 3.0);
    EXPECT_EQ(problem.constraints[3].marks, (std::vector<std::size_t>{0, 2, 0, 1}));
    EXPECT_EQ(problem.constraints[4].distance, 3.0);
    EXPECT_EQ(problem.constraints[5].position, V2d(100, 50));
    EXPECT_EQ(problem.constraints[7].position, V2d(3, 4));
    EXPECT_EQ(problem.constraints[8].deviation, 0.2);
    EXPECT_EQ(marks->labels[1], "level gable, lid");
    EXPECT_EQ(marks->labels[8], "corner 4 of board 1");
}

TEST(Marks, MayBeOnObjectsOfAScene) {
    std::string text = replaced("axes: y_up", "scene: room.glb");
    const std::string east = "{direction: [0, 1, 0], near: [600, 100]}";
    text.replace(text.find(east), east.size(), "{object: vase, part: [0, 1, 0.5]}");
    const auto marks = read(text);
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    EXPECT_EQ(marks->scene, "room.glb");
    ASSERT_EQ(marks->on_objects.size(), 1U);
    EXPECT_EQ(marks->on_objects[0].mark, 1U);
    EXPECT_EQ(marks->on_objects[0].object, "vase");
    EXPECT_EQ(marks->on_objects[0].part, V3d(0, 1, 0.5));
}

// A vanishing point is given by an edge, whose ends may follow.
TEST(Marks, ADirectionIsFromOneMarkToAnother) {
    const auto marks =
        read(replaced("{direction: [0, 1, 0], near: [600, 100]}",
                      "{direction: [door, gable], near: [600, 100]}\n  door: [20, 3, 0]"));
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    EXPECT_TRUE(marks->problem.marks[1].at_infinity);
    ASSERT_EQ(marks->directions.size(), 1U);
    EXPECT_EQ(marks->directions[0].mark, 1U);
    EXPECT_EQ(marks->directions[0].ends, (std::array<std::size_t, 2>{2, 0}));
}

TEST(Marks, AShapeMayBeDemandedAllOverABox) {
    const auto marks =
        read(replaced("{isotropic: [100, 50]}", "{unfolded: [[100, 50], [500, 450]], value: 0.2}"));
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    const auto& constraints = marks->problem.constraints;
    ASSERT_EQ(constraints.size(), 33U);
    for (const std::size_t i : {5U, 17U, 29U}) {
        EXPECT_EQ(constraints[i].kind, ConstraintKind::unfolded);
        EXPECT_EQ(constraints[i].value, 0.2);
    }
    EXPECT_EQ(constraints[5].position, V2d(100, 50));
    EXPECT_EQ(constraints[9].position, V2d(500, 50));
    EXPECT_EQ(constraints[10].position, V2d(100, 150));
    EXPECT_EQ(constraints[29].position, V2d(500, 450));
    EXPECT_EQ(marks->labels[10], "unfolded (100, 150)");
}

// `whole` with outlines and constraints on them.
std::string with_outlines(const std::string& outlines, const std::string& constraints) {
    std::string text = replaced("constraints:\n", "outlines:\n" + outlines + "constraints:\n");
    return text.replace(text.find("boards:"), 0, constraints);
}

TEST(Marks, OutlinesAreOfObjectsOrPoints) {
    const std::string outlines =
        "  tent: {points: [[1, 2, 3], [4, 5, 6]], near: [100, 50]}\n  vase: \"vase*\"\n";
    std::string text = with_outlines(
        outlines,
        "  - {left: tent, value: 30}\n  - {within: vase, box: [[10, 20], [600, 400]]}\n"
        "  - {within: tent}\n  - {touches: vase, line: [[0, 200], [640, 210]]}\n"
        "  - {high: vase, value: 90}\n");
    text.replace(text.find("axes: y_up"), 10, "scene: room.glb\norigin: pixel_center");
    const auto marks = read(text);
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    const solve::Problem& problem = marks->problem;
    ASSERT_EQ(problem.outlines.size(), 2U);
    EXPECT_EQ(problem.outlines[0].points, (std::vector<V3d>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(problem.outlines[0].near, V2d(100.5, 50.5));
    ASSERT_EQ(marks->outlines_of_objects.size(), 1U);
    EXPECT_EQ(marks->outlines_of_objects[0].outline, 1U);
    EXPECT_EQ(marks->outlines_of_objects[0].object, "vase*");
    // Positions and coordinates are from pixel centres, extents are not.
    EXPECT_EQ(problem.constraints[6].kind, ConstraintKind::left);
    EXPECT_EQ(problem.constraints[6].outline, 0U);
    EXPECT_EQ(problem.constraints[6].value, 30.5);
    EXPECT_EQ(problem.constraints[7].corners, (std::array{V2d(10.5, 20.5), V2d(600.5, 400.5)}));
    EXPECT_FALSE(problem.constraints[8].corners);
    EXPECT_EQ(problem.constraints[9].kind, ConstraintKind::touches);
    EXPECT_EQ(problem.constraints[10].value, 90.0);
    EXPECT_EQ(marks->labels[9], "touches vase");
}

TEST(Marks, MistakesOfOutlinesAreSaidWhereTheyAre) {
    const std::string tent = "  tent: {points: [[1, 2, 3], [4, 5, 6]]}\n";
    const std::string outline_remedy =
        "write the name of an object of the scene, or {object: NAME} or {points: [[x, y, z], ...]} "
        "with more about it";
    const std::vector<Mistake> mistakes{
        {with_outlines("  tent: vase\n", ""), "16:3",
         "'tent' is the outline of an object of no scene", "add the entry scene: FILE"},
        {with_outlines("  tent: {near: [1, 2]}\n", ""), "16:3", "the outline 'tent' has no points",
         outline_remedy},
        {with_outlines("  tent: {object: a, points: [[1, 2, 3]]}\n", ""), "16:3",
         "the outline 'tent' has an object and points", outline_remedy},
        {with_outlines(tent, "  - {left: tend, value: 3}\n"), "25:12", "there is no outline 'tend'",
         "did you mean 'tent'?"},
        {with_outlines(tent, "  - {left: gable, value: 3}\n"), "25:12",
         "'gable' is a mark, not an outline",
         "'left' means that an outline begins so many pixels from the left side"},
        {with_outlines(tent, "  - {inside: tent}\n"), "25:14", "'tent' is an outline",
         "'inside' means that a mark is in the picture, so many pixels from its border"},
        {with_outlines(tent, "  - {left: tent}\n"), "25:6", "'left' has no value",
         "add value: NUMBER; 'left' means that an outline begins so many pixels from the left "
         "side"},
        {with_outlines(tent, "  - {touches: tent}\n"), "25:6", "'touches' has no line",
         "add line: [[x, y], [x, y]]"},
        {with_outlines(tent, "  - {touches: tent, line: [[1, 2], [1, 2]]}\n"), "25:27",
         "this is no line", "write two positions on it: [[0, 240], [640, 200]]"},
        {with_outlines(tent, "  - {within: tent, box: [[9, 2], [1, 5]]}\n"), "25:25",
         "this is no box",
         "write the upper left and the lower right corner: [[100, 50], [540, 310]]"},
        {with_outlines(tent, "  - {within: tent, box: [9, 2, 1, 5]}\n"), "25:25", "this is no box",
         "write the upper left and the lower right corner: [[100, 50], [540, 310]]"},
        {with_outlines(tent, "  - {within: tent, line: [[9, 2], [1, 5]]}\n"), "25:20",
         "'within' has no line",
         "remove it; 'within' means that an outline is in a box or, without one, in the picture"},
        {with_outlines(tent, "  - {wide: tent, value: 90}\n  - {wide: tent, value: 50}\n"), "26:6",
         "'wide' of an outline is to be both 90 and 50",
         "remove one of the two rows, or give them a tolerance"},
    };
    for (const Mistake& mistake : mistakes) {
        check(mistake);
    }
}

TEST(Marks, AShapeAndAMagnificationAtOnePlaceDoNotContradict) {
    const auto marks = read(replaced("isotropic: [100, 50]", "isotropic: [320, 240], distance: 3"));
    EXPECT_TRUE(marks) << to_text(marks.diagnostics);
}

TEST(Marks, PixelCentersAreHalfAPixelFromCorners) {
    const auto marks = read(replaced("axes: y_up", "origin: pixel_center"));
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    EXPECT_EQ(marks->problem.constraints[0].position, V2d(155.5, 347.5));
    EXPECT_EQ(marks->problem.constraints[8].position, V2d(5.5, 6.5));
    EXPECT_EQ(marks->problem.marks[1].near, V2d(600.5, 100.5));
}

// ---------------------------------------------------------------------------------------- rigs

const std::string rig = R"(size: [640, 480]
pictures: [left, right]
origin: pixel_center
marks:
  gable: {point: [20, 4, -1.6], near: [100, 50]}
  door: [20, 3, 0]
  edge: {direction: [gable, door]}
constraints:
  - {at: gable, position: [155, 347], picture: left}
  - {at: gable, position: [10, 20], picture: right}
  - {level: [gable, door], picture: right}
  - {isotropic: [100, 50], picture: right}
  - {at: edge, position: [30, 40], picture: right}
boards:
  - columns: 2
    rows: 1
    square: 0.5
    corners: {right: [[1, 2], null], left: [[3, 4], [5, 6]]}
)";

std::string rig_with(const std::string& old, const std::string& by) {
    std::string text = rig;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
}

TEST(Marks, ARigHasPicturesSideBySide) {
    const auto marks = read(rig);
    ASSERT_TRUE(marks) << to_text(marks.diagnostics);
    EXPECT_EQ(marks->width, 1280U);
    EXPECT_EQ(marks->height, 480U);
    const auto& [unknowns, targets, all, constraints, outlines] = marks->problem;
    ASSERT_EQ(constraints.size(), 8U);
    EXPECT_EQ(constraints[0].position, V2d(155.5, 347.5));
    EXPECT_EQ(constraints[1].position, V2d(650.5, 20.5));
    EXPECT_EQ(constraints[3].position, V2d(740.5, 50.5));
    // A mark is seen in one place, so each picture has its own.
    EXPECT_EQ(constraints[0].marks.front(), 0U);
    const std::size_t gable = constraints[1].marks.front();
    EXPECT_EQ(constraints[2].marks.front(), gable);
    EXPECT_EQ(all[gable].name, "gable in right");
    EXPECT_EQ(all[gable].place, all[0].place);
    EXPECT_EQ(all[gable].near, V2d(650.5, 20.5));
    EXPECT_EQ(all[0].near, V2d(100.5, 50.5));
    // One without a position is searched from the middle of its picture.
    EXPECT_EQ(all[constraints[2].marks[1]].near, V2d(960.0, 240.0));
    // The direction of an edge is that of the same edge.
    ASSERT_EQ(marks->directions.size(), 2U);
    EXPECT_EQ(marks->directions[1].mark, constraints[4].marks.front());
    EXPECT_EQ(marks->directions[1].ends, marks->directions[0].ends);
    // A board is one target in all pictures.
    EXPECT_EQ(targets.size(), 1U);
    EXPECT_EQ(constraints[5].position, V2d(641.5, 2.5));
    EXPECT_EQ(constraints[7].position, V2d(5.5, 6.5));
    EXPECT_EQ(all[constraints[7].marks.front()].place, V3d(0.5, 0.0, 0.0));
    EXPECT_EQ(marks->labels[1], "at gable in right");
    EXPECT_EQ(marks->labels[5], "corner 1 of board 1 in right");
}

TEST(Marks, MistakesOfRigsAreSaidWhereTheyAre) {
    const std::vector<Mistake> mistakes{
        {rig_with("[left, right]", "[left, left]"), "2:18", "there are two pictures 'left'",
         "name the pictures of a rig from left to right: [left, right]"},
        {rig_with("size: [640, 480]", "size: [640000, 480]"), "2:1",
         "2 pictures of 640000 pixels side by side are too wide",
         "together they may have 1000000 pixels"},
        {rig_with("pictures: [left, right]\n", ""), "8:48",
         "there is one picture, which has no name", "add pictures: [left, right], or remove it"},
        {rig_with(", picture: left}", "}"), "9:5",
         "this row does not say which picture of the rig it is about",
         "add picture: 'left' or 'right'"},
        {rig_with("picture: left}", "picture: lift}"), "9:48", "there is no picture 'lift'",
         "did you mean 'left'?"},
        {rig_with("{level: [gable, door]", "{inside: door"), "11:6",
         "'inside' cannot be about one of several pictures", "demand positions of marks there"},
        {rig_with("[[3, 4], [5, 6]]", "[[3, 4]]"), "18:44",
         "board 1 needs columns x rows = 2 corners, but has 1",
         "write the positions of the inner corners row by row, with null for one that is not seen"},
        {rig_with("    corners: {right: [[1, 2], null], left: [[3, 4], [5, 6]]}\n", ""), "15:5",
         "board 1 needs columns x rows = 2 corners, but has 0",
         "write the positions of the inner corners row by row, with null for one that is not seen"},
        {rig_with("{right: [[1, 2], null], left:", "{rigth: [[1, 2], null], left:"), "18:15",
         "'corners' of board 1 has no entry 'rigth'", "did you mean 'right'?"},
    };
    for (const Mistake& mistake : mistakes) {
        check(mistake);
    }
}

TEST(Marks, EachMistakeIsSaidWhereItIs) {
    const std::vector<Mistake> mistakes{
        {replaced("size: [640, 480]", "sice: [640, 480]"), "2:1", "the file has no entry 'sice'",
         "did you mean 'size'?"},
        {replaced("size: [640, 480]\n", ""), "1:1", "the size of the picture is missing",
         "write its width and height in pixels: size: [1920, 1080]"},
        {replaced("[640, 480]", "[640, 0]"), "2:7", "a picture cannot have 640 x 0 pixels",
         "write two whole numbers from 1 to 1000000"},
        {replaced("y_up", "x_up"), "3:7", "there are no axes 'x_up'", "write y_up or z_up"},
        {replaced("axes: y_up", "origin: middle"), "3:9", "there is no origin 'middle'",
         "write pixel_center, as OpenCV counts, or pixel_corner"},
        {replaced("50deg", "fifty"), "5:16", "'fifty' is not a finite number",
         "write a number with the unit that the parameter has: 55deg"},
        {replaced("[20deg, 1.5rad]", "[90deg, 20deg]"), "5:30", "this range contains nothing",
         "write the smallest and the largest value: [20deg, 90deg]"},
        {replaced("deviation: 5deg", "deviation: 0deg"), "5:58",
         "a deviation of 0 is not between 1e-12 and 1e+12",
         "write a number in this range, or leave it out"},
        {replaced("deviation: 5deg", "sigma: 5deg"), "5:47", "'fov' has no entry 'sigma'",
         "its entries are 'start', 'range' and 'deviation'"},
        {replaced("  px:\n", "  fov:\n"), "6:3", "'fov' is given twice", "remove one of the two"},
        {replaced("gable: [20, 4, -1.6]", "gable: [20, 4]"), "12:10",
         "expected 3 numbers in brackets",
         "write a point of space as [x, y, z], or as {point: [x, y, z]} or {direction: [x, y, z]} "
         "with more about it"},
        {replaced("{direction: [0, 1, 0], near: [600, 100]}", "{near: [600, 100]}"), "13:3",
         "the mark 'east' is at no place",
         "write a point of space as [x, y, z], or as {point: [x, y, z]} or {direction: [x, y, z]} "
         "with more about it"},
        {replaced("direction: [0, 1, 0]", "direction: [0, 0, 0]"), "13:3",
         "the direction of the mark 'east' has no length", "write a direction such as [1, 0, 0]"},
        {replaced("direction: [0, 1, 0]", "direction: [gable, dor]"), "13:29",
         "there is no mark 'dor'", "the marks are 'gable', 'east' and 'lid'"},
        {replaced("direction: [0, 1, 0]", "direction: [lid, gable]"), "13:22",
         "the mark 'lid' is on a target", "write two marks that are points of space"},
        {replaced("direction: [0, 1, 0]", "direction: [gable, east]"), "13:29",
         "the mark 'east' is a direction", "write two marks that are points of space"},
        {replaced("{isotropic: [100, 50]}", "{isotropic: [[100, 50], [90, 60]]}"), "22:17",
         "this is no box",
         "write the upper left and the lower right corner: [[100, 50], [540, 310]]"},
        {replaced("{direction: [0, 1, 0], near: [600, 100]}", "{object: vase}"), "13:3",
         "the mark 'east' is on an object of no scene", "add the entry scene: FILE"},
        {replaced("direction: [0, 1, 0], near: [600, 100]", "point: [0, 1, 0], part: [0, 0, 1]"),
         "13:3", "the mark 'east' has a part of no object", "add object: NAME, or remove the part"},
        {replaced("target: box", "target: bos"), "14:35", "there is no target 'bos'",
         "did you mean 'box'?"},
        {replaced("point: [0, 0, 1], target", "direction: [0, 0, 1], target"), "14:3",
         "the mark 'lid' is a direction and belongs to a target",
         "remove the target, or write a point of it"},
        {replaced("at: gable", "at: gabel"), "16:10", "there is no mark 'gabel'",
         "did you mean 'gable'?"},
        {replaced("at: gable, position", "att: gable, position"), "16:6",
         "the constraint has no entry 'att'", "did you mean 'at'?"},
        {replaced(", position: [155, 347]", ""), "16:6", "'at' has no position",
         "add position: [x, y] in pixels"},
        {replaced("deviation: 0.5", "deviation: -1"), "16:50", "'deviation' must be above 0",
         "write a number above 0, such as deviation: 0.5"},
        {replaced("deviation: 0.5", "deviation: 1deg"), "16:50", "this number must have no unit",
         "write a number above 0, such as deviation: 0.5"},
        {replaced("deviation: 0.5, weight: 4", "deviation: 1e-300"), "16:50",
         "a deviation of 1e-300 is not between 1e-12 and 1e+12",
         "write another number; a weight divides the deviation by its square root"},
        {replaced("weight: 4", "weight: 1e300"), "16:63",
         "a deviation of 5e-151 is not between 1e-12 and 1e+12",
         "write another number; a weight divides the deviation by its square root"},
        {replaced("tolerance: 3", "tolerance: 1e-300"), "18:16",
         "a tolerance of 1e-300 is not between 1e-12 and 1e+12",
         "write a number in this range, or leave it out"},
        {replaced("level: [gable, lid]", "level: gable"), "17:12", "'level' takes 2 marks, not 1",
         "it means that two marks appear at one height"},
        {replaced("{inside: east}", "{inside: east, distance: 2}"), "19:20",
         "'inside' has no distance",
         "remove it; 'inside' means that a mark is in the picture, so many pixels from its border"},
        {replaced("{inside: east}", "{inside: east, outside: lid}"), "19:20",
         "a constraint is not both 'inside' and 'outside'", "write two rows"},
        {replaced("{inside: east}", "{deviation: 1}"), "19:5",
         "this constraint does not say what it demands",
         "begin it with one of 'at', 'together', 'inside', 'outside', 'straight', 'level', "
         "'upright', 'parallel', 'length', 'ratio', 'magnification', 'isotropic', 'unfolded', "
         "'left', 'right', 'top', 'bottom', 'wide', 'high', 'within' or 'touches'"},
        {replaced(", value: 2}", "}"), "20:6", "'ratio' has no value",
         "add value: NUMBER; 'ratio' means that the first two marks are so many times as far apart "
         "as the other two"},
        {replaced("value: 500", "value: 0"), "21:6", "a magnification must be above 0",
         "write value: 500"},
        {replaced("[1, 2], null,", "[1, 2],"), "24:49",
         "board 1 needs columns x rows = 4 corners, but has 3",
         "write the positions of the inner corners row by row, with null for one that is not seen"},
        {replaced("columns: 2", "columns: 0"), "24:15",
         "'columns' must be a whole number from 1 to 1000", "write columns: 9"},
        {replaced("{inside: east}", "{at: gable, position: [156, 357]}"), "19:6",
         "the mark 'gable' is to appear at two positions, 10 pixels apart",
         "remove one of the two rows, or give them a tolerance"},
        {replaced("{isotropic: [100, 50]}", "{outside: east}"), "22:6",
         "the mark 'east' is to be inside and outside the picture",
         "remove one of the two rows, or give them a tolerance"},
        {replaced("- {inside: east}",
                  "- {length: [gable, lid], value: 9}\n  - {length: [lid, gable], value: 30}"),
         "20:6", "the length between two marks is to be both 9 and 30",
         "remove one of the two rows, or give them a tolerance"},
        {replaced("- {inside: east}",
                  "- {length: [gable, lid], value: 20}\n  - {together: [lid, gable]}"),
         "20:6", "two marks are to appear together and 20 pixels apart",
         "remove one of the two rows, or give them a tolerance"},
        {replaced("{isotropic: [100, 50]}", "{magnification: [320, 240], value: 5e9, distance: 3}"),
         "22:6", "a magnification is to be both 500 and 5e+09",
         "remove one of the two rows, or give them a tolerance"},
        {"size: [640, 480]\nmarks: {a: [1, 2, 3]}\n", "1:1", "there is no constraint",
         "say what the picture is to show: constraints: [{at: MARK, position: [x, y]}]"},
        {"- 1", "1:1", "the file has no entries",
         "a file of marks has the entries size, marks and constraints, or boards"},
    };
    for (const Mistake& mistake : mistakes) {
        check(mistake);
    }
}

TEST(Marks, WhatIsNotYamlIsSaidSo) {
    const auto marks = read("size: [640");
    ASSERT_FALSE(marks);
    EXPECT_TRUE(marks.diagnostics.front().message.starts_with("this is not YAML: "));
    EXPECT_FALSE(read(""));
}

TEST(Marks, AllMistakesAreSaidAtOnceButNotTooMany) {
    std::string text = "size: [640, 480]\nconstraints:\n";
    for (int i = 0; i < 100; ++i) {
        text += "  - {at: nothing, position: [1, 2]}\n";
    }
    const auto marks = read(text);
    EXPECT_GE(marks.diagnostics.size(), 20U);
    EXPECT_LT(marks.diagnostics.size(), 25U);
}

}  // namespace balcony::app::marks_test
