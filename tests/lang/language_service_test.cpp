// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Questions of editors about small texts. ^ is the place.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "../files/temporary_folder.hpp"
#include "balcony/language_service.hpp"
#include "lang/syntax/parser.hpp"
#include "lang/syntax/statement_rows.hpp"
#include "support.hpp"

namespace balcony::lang::language_service_test {
namespace {

struct Marked {
    explicit Marked(std::string written) : offset(written.find('^')) {
        written.erase(offset, 1);
        text = std::make_shared<const SourceText>("test.cam", std::move(written));
    }
    std::size_t offset;
    std::shared_ptr<const SourceText> text;
};

std::vector<std::string> completed(const std::string& written) {
    const Marked marked(written);
    std::vector<std::string> labels;
    for (const Completion& one : EditedText(marked.text).complete(marked.offset).items) {
        labels.push_back(one.label);
    }
    return labels;
}

std::string hovered(const std::string& written) {
    const Marked marked(written);
    const auto told = EditedText(marked.text).hover(marked.offset);
    return told ? told->signature : "";
}

// "line:column", from 1.
std::string place_of(const SourceSpan& span) {
    const LineColumn at = span.source->locate(span.begin);
    return fmt::format("{}:{}", at.line, at.column);
}

struct CompletionCase {
    const char* name;
    const char* text;
    std::vector<std::string> has;
    std::vector<std::string> lacks;
};

class CompletionAt : public testing::TestWithParam<CompletionCase> {};

}  // namespace

TEST_P(CompletionAt, KnowsWhatCanStandThere) {
    const std::vector<std::string> labels = completed(GetParam().text);
    const std::set<std::string> known(labels.begin(), labels.end());
    EXPECT_EQ(known.size(), labels.size());
    for (const std::string& word : GetParam().has) {
        EXPECT_TRUE(known.contains(word)) << word << fmt::format(" in {}", labels);
    }
    for (const std::string& word : GetParam().lacks) {
        EXPECT_FALSE(known.contains(word)) << word;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Places, CompletionAt,
    testing::Values(
        CompletionCase{"File", "^", {"camera", "picture", "let", "import"}, {"eye", "sin"}},
        CompletionCase{"FileAfterCamera", "camera a { eye point }\n^", {"camera", "let"}, {"eye"}},
        CompletionCase{"Statement",
                       "camera a {\n    ^\n}",
                       {"eye", "map", "look", "move"},
                       {"layer", "object", "sphere", "clip"}},
        CompletionCase{"StatementAfterOne",
                       "camera a {\n    eye sphere(1)\n    ^\n}",
                       {"eye", "map", "look"},
                       {"sphere"}},
        CompletionCase{"BegunStatement", "camera a {\n    ey^\n}", {"eye"}, {"sphere"}},
        CompletionCase{
            "Path", "camera a {\n    eye {\n ^ } }", {"object", "warp", "move"}, {"eye"}},
        CompletionCase{"Layer",
                       "picture p {\n layer pinhole {\n ^ }\n}",
                       {"clip", "show", "alpha", "place"},
                       {"eye", "layer"}},
        CompletionCase{"Loop", "picture p {\n for i in 0 .. 3 {\n ^", {"layer", "let"}, {"eye"}},
        CompletionCase{"Object", "camera a {\n eye ^", {"sphere", "product"}, {"normal", "eye"}},
        CompletionCase{"BegunObject", "camera a {\n eye sph^\n look normal }", {"sphere"}, {}},
        CompletionCase{"Rule", "camera a {\n look ^ }", {"normal", "along"}, {"sphere"}},
        CompletionCase{"Mover", "camera a { move scale(2), ^ }", {"translate"}, {"sphere"}},
        CompletionCase{"Curve", "camera a { eye product(^", {"circle"}, {"sphere"}},
        CompletionCase{"SecondCurve", "camera a { eye product(circle(1), ^) }", {"circle"}, {}},
        CompletionCase{"Parameters",
                       "camera a { eye product(superellipse(^), circle(1)) }",
                       {"a", "b", "by", "pi"},
                       {"circle"}},
        CompletionCase{"GivenParameter",
                       "camera a { eye product(superellipse(a = 1, ^), circle(1)) }",
                       {"b"},
                       {"a"}},
        CompletionCase{"Choice",
                       "camera a { eye product(superellipse(1, 1, 1, by = ^",
                       {"arc_length"},
                       {"sin", "a"}},
        CompletionCase{"WordOfRule", "camera a { look normal ^", {"inward", "outward"}, {}},
        CompletionCase{"Value",
                       "let w = 1\ncamera a(fov = 60deg) { let h = ^ }\ncamera b(c = 1) {}",
                       {"w", "fov", "pi", "sin", "t"},
                       {"c", "sphere", "scene_center"}},
        CompletionCase{"Fit", "camera a(r = 1) {\n fit r = ^\n}", {"scene_radius"}, {}},
        CompletionCase{
            "Formula", "camera a { eye surface(p, q) = [^, 0, 0] }", {"p", "q", "sin"}, {"u"}},
        CompletionCase{
            "LoopVariable", "picture p { for i in 0 .. 3 { layer pinhole(yaw = ^) } }", {"i"}, {}},
        CompletionCase{"LayerCamera",
                       "camera mine { eye point }\npicture p { layer ^ }",
                       {"mine", "pinhole", "fisheye"},
                       {"sphere", "p"}},
        CompletionCase{"Base", "camera wide = ^", {"fisheye"}, {"wide"}},
        CompletionCase{"CameraParameter",
                       "camera mine(fov = 1, gain = 2) { eye point }\n"
                       "picture p { layer mine(fov = 2, ^) }",
                       {"gain"},
                       {"fov"}},
        CompletionCase{"BuiltInParameter", "camera wide = superelliptic(^)", {"gamma"}, {}},
        CompletionCase{"Coordinate", "camera a { map ^", {"u", "v"}, {"pi"}},
        CompletionCase{"Comment", "camera a { // eye ^\n}", {}, {"eye", "sphere"}},
        CompletionCase{"Number", "camera a { aspect 1^ }", {}, {"pi"}},
        CompletionCase{"FileName", "import \"^\"", {}, {"camera"}},
        CompletionCase{
            "UnclosedCall", "camera a {\n    eye sphere(1\n    look ^\n}", {"normal"}, {"sphere"}},
        CompletionCase{"UnclosedCamera",
                       "camera a {\n    eye sphere(1)\ncamera b {\n    look ^\n}",
                       {"normal"},
                       {}}),
    [](const auto& one) { return one.param.name; });

TEST(LanguageService, CompletesWholeCalls) {
    const Marked marked("camera a { eye product(supere^, circle(1)) }");
    const Completions made = EditedText(marked.text).complete(marked.offset);
    EXPECT_EQ(marked.text->text().substr(made.begin, made.end - made.begin), "supere");
    const auto found =
        std::find_if(made.items.begin(), made.items.end(),
                     [](const Completion& one) { return one.label == "superellipse"; });
    ASSERT_NE(found, made.items.end());
    EXPECT_TRUE(found->text.starts_with("superellipse(a = ")) << found->text;
    ASSERT_FALSE(found->blanks.empty());
    for (const Completion::Blank& blank : found->blanks) {
        EXPECT_LT(blank.begin, blank.end);
        EXPECT_LE(blank.end, found->text.size());
    }
}

TEST(LanguageService, KeepsTheArgumentsOfACall) {
    const Marked marked("camera a { eye sph^(1) }");
    const Completions made = EditedText(marked.text).complete(marked.offset);
    for (const Completion& one : made.items) {
        EXPECT_EQ(one.text, one.label);
    }
}

// Each stage's call as it is inserted can be read, and has a hover and a signature.
TEST(LanguageService, KnowsEveryStage) {
    std::size_t known = 0;
    for (const camera::StageEntry& row : camera::catalogue()) {
        const auto statement =
            std::find_if(statement_rows().begin(), statement_rows().end(),
                         [&row](const StatementRow& one) { return one.stage_kind == row.kind; });
        if (statement == statement_rows().end() || statement->shape == Shape::ranges ||
            row.name == "place") {
            continue;  // An argument of others alone, or written in another form.
        }
        const bool is_keyword = statement->keyword == row.name;
        const std::string before =
            fmt::format("{} {}{}",
                        row.kind == camera::StageKind::clip_shape ? "picture p { layer pinhole {"
                                                                  : "camera a { eye point\n",
                        is_keyword ? "" : statement->keyword, is_keyword ? "" : " ");
        const std::string after = row.kind == camera::StageKind::clip_shape ? "\n} }" : "\n}";
        const Marked marked(before + "^" + after);
        const Completions made = EditedText(marked.text).complete(marked.offset);
        const auto found =
            std::find_if(made.items.begin(), made.items.end(),
                         [&row](const Completion& one) { return one.label == row.name; });
        ASSERT_NE(found, made.items.end()) << row.name << " after " << statement->keyword;
        EXPECT_EQ(found->meaning, row.meaning);
        const std::string whole = test::joined({before, found->text, after});
        Reporter reporter;
        (void)parse(std::make_shared<const SourceText>("test.cam", whole), camera::catalogue(),
                    reporter);
        EXPECT_EQ(to_text(reporter.take()), "") << whole;

        const EditedText text(std::make_shared<const SourceText>("test.cam", whole));
        const auto told = text.hover(before.size());
        ASSERT_TRUE(told) << whole;
        EXPECT_TRUE(told->signature.starts_with(row.name)) << told->signature;
        EXPECT_NE(row.example.find(told->example), std::string_view::npos);
        EXPECT_EQ(told->example.empty(), row.example.empty());
        if (!row.parameters.empty() && found->text.size() > row.name.size()) {
            const auto called = text.signature(before.size() + row.name.size() + 1);
            ASSERT_TRUE(called) << whole;
            EXPECT_EQ(called->parameters.size(), row.parameters.size()) << row.name;
        }
        ++known;
    }
    EXPECT_GT(known, 100U);
}

TEST(LanguageService, CompletesWhatRepeats) {
    const Marked marked("camera a { map u = 0 .. 1, v = 0 .. 1\n eye sphere(1)\n warp ^\n}");
    const Completions made = EditedText(marked.text).complete(marked.offset);
    const auto found = std::find_if(made.items.begin(), made.items.end(),
                                    [](const Completion& one) { return one.label == "repeat"; });
    ASSERT_NE(found, made.items.end());
    const auto result = test::make(
        test::edited(std::string(marked.text->text()), {{made.begin, made.end, found->text}}));
    EXPECT_TRUE(result) << to_text(result.diagnostics);
}

// Calls that name no file make cameras.
TEST(LanguageService, CompletesObjectsThatWork) {
    for (const camera::StageEntry& row : camera::catalogue()) {
        if (row.kind != camera::StageKind::object_generator) {
            continue;
        }
        const Marked marked("camera a { map u = 0 .. 1, v = 0 .. 1\n look along(x)\n eye ^\n}");
        const Completions made = EditedText(marked.text).complete(marked.offset);
        const auto found =
            std::find_if(made.items.begin(), made.items.end(),
                         [&row](const Completion& one) { return one.label == row.name; });
        ASSERT_NE(found, made.items.end());
        if (found->text.find('"') != std::string::npos) {
            continue;
        }
        const std::string whole =
            test::edited(std::string(marked.text->text()), {{made.begin, made.end, found->text}});
        const auto result = test::make(whole);
        EXPECT_FALSE(has_errors(result.diagnostics)) << whole << to_text(result.diagnostics);
    }
}

TEST(LanguageService, TellsWhatWordsMean) {
    EXPECT_EQ(hovered("camera a { e^ye sphere(1) }"), "eye");
    EXPECT_EQ(hovered("camera a { eye sph^ere(1) }"), "sphere(radius, by)");
    EXPECT_EQ(hovered("camera a { eye sphere(rad^ius = 1) }").substr(0, 6), "radius");
    EXPECT_EQ(hovered("camera a(fov = 60deg from 1deg to 179deg) { aspect fo^v/1deg }"),
              "fov = 60deg from 1deg to 179deg");
    EXPECT_EQ(hovered("let half = 1/2\ncamera a { aspect ha^lf }"), "let half = 1/2");
    EXPECT_EQ(hovered("camera a { aspect si^n(1) }"), "sin(a)");
    EXPECT_EQ(hovered("camera a { aspect p^i }"), "pi");
    EXPECT_TRUE(hovered("camera a = super^elliptic").starts_with("camera superelliptic(a = 45"));
    EXPECT_EQ(hovered("camera a = superelliptic(gam^ma = 1)"), "gamma = 1/4 from 0.05 to 2");
    EXPECT_EQ(hovered("camera a { look normal out^ward }").substr(0, 4), "side");
    EXPECT_EQ(hovered("camera a { aspect 1^6/9 }"), "");
    EXPECT_EQ(hovered("camera a { aspect nob^ody }"), "");
}

TEST(LanguageService, TellsTheCommentOfADeclaration) {
    const Marked marked("// Wide.\ncamera a { eye point }\npicture p { layer ^a }");
    EXPECT_EQ(EditedText(marked.text).hover(marked.offset)->meaning, "Wide.");
}

TEST(LanguageService, FindsTheActiveParameter) {
    const auto active = [](const std::string& written) {
        const Marked marked(written);
        const auto found = EditedText(marked.text).signature(marked.offset);
        if (!found || found->active == found->parameters.size()) {
            return std::string("none");
        }
        const Signature::Parameter& one = found->parameters[found->active];
        return found->label.substr(one.begin, one.end - one.begin);
    };
    EXPECT_EQ(active("camera a { eye product(superellipse(1, ^"), "b = 1");
    EXPECT_EQ(active("camera a { eye product(superellipse(b = ^"), "b = 1");
    EXPECT_EQ(active("camera a { eye product(superellipse(1), ^)}"), "h");
    EXPECT_EQ(active("camera a { aspect atan2(1, ^) }"), "b");
    EXPECT_EQ(active("let ratio(x, y) = x/y\ncamera a { aspect ratio(1, ^) }"), "y");
    EXPECT_EQ(active("camera a = superelliptic(gamma = ^"), "gamma = 1/4 from 0.05 to 2");
    EXPECT_EQ(active("camera a { aspect (1 + ^2) }"), "none");
}

TEST(LanguageService, FindsDeclarationsAndUses) {
    struct Case {
        const char* text;
        const char* declared;
        std::vector<std::string> uses;
    };
    const std::vector<Case> cases{
        {"let w = 1\ncamera a { aspect ^w }\ncamera b(w = 2) { aspect w }", "1:5", {"1:5", "2:19"}},
        {"let w = 1\ncamera b(w = 2) { aspect ^w }", "2:10", {"2:10", "2:26"}},
        {"camera b(w = 2) { eye point }\npicture p { layer b(^w = 3) }", "1:10", {"1:10", "2:21"}},
        {"camera b(w = 2) {\n fit ^w = scene_radius\n eye sphere(w) }",
         "1:10",
         {"1:10", "2:6", "3:13"}},
        {"camera b { eye point }\npicture p { layer ^b }\ncamera c = b",
         "1:8",
         {"1:8", "2:19", "3:12"}},
        {"picture p { for i in 0 .. 2 { layer pinhole(yaw = ^i*1deg) } }",
         "1:17",
         {"1:17", "1:51"}},
        {"let f(x) = ^x/2\nlet x = 1", "1:7", {"1:7", "1:12"}},
        {"let u = 1\ncamera a { eye surface(u, v) = [^u, v, u] }",
         "2:24",
         {"2:24", "2:33", "2:39"}},
        // In a text with a mistake.
        {"let w = 1\ncamera a {\n eye sphere(^w\n look normal }", "1:5", {"1:5", "3:13"}},
    };
    for (const Case& one : cases) {
        const Marked marked(one.text);
        const EditedText text(marked.text);
        const auto declared = text.definition(marked.offset);
        ASSERT_TRUE(declared) << one.text;
        EXPECT_EQ(place_of(*declared), one.declared) << one.text;
        std::vector<std::string> uses;
        for (const SourceSpan& use : text.references(marked.offset)) {
            uses.push_back(place_of(use));
        }
        EXPECT_EQ(uses, one.uses) << one.text;
    }
}

TEST(LanguageService, FindsDeclarationsInImports) {
    const files::TemporaryFolder folder;
    folder.write("shared.cam", "let w = 2\ncamera near(gain = 1) { eye point(0, gain, 0) }\n");
    const auto declared = [&](const std::string& written) {
        const Marked marked("import \"shared.cam\"\n" + written);
        const auto found = EditedText(marked.text, folder.path()).definition(marked.offset);
        return found ? std::filesystem::path(found->source->name()).filename().string() + ":" +
                           place_of(*found)
                     : "";
    };
    EXPECT_EQ(declared("camera a { aspect ^w eye point }"), "shared.cam:1:5");
    EXPECT_EQ(declared("camera a = ^near"), "shared.cam:2:8");
    EXPECT_EQ(declared("camera a = near(^gain = 2)"), "shared.cam:2:13");
    EXPECT_EQ(declared("camera a = ^fisheye"), "");
}

TEST(LanguageService, Renames) {
    const auto renamed = [](const std::string& written, std::string_view name) {
        const Marked marked(written);
        const auto made = EditedText(marked.text).rename(marked.offset, name);
        return made ? test::edited(std::string(marked.text->text()), *made)
                    : made.diagnostics.front().message;
    };
    EXPECT_EQ(renamed("let w = 1 // w\ncamera a { aspect ^w eye sphere(w) }", "width"),
              "let width = 1 // w\ncamera a { aspect width eye sphere(width) }");
    EXPECT_EQ(renamed("camera b(w = 2) { eye point }\npicture p { layer ^b(w = 3) }", "c"),
              "camera c(w = 2) { eye point }\npicture p { layer c(w = 3) }");
    EXPECT_EQ(renamed("camera a { eye ^sphere(1) }", "ball"),
              "this name is not declared in this file");
    EXPECT_EQ(renamed("let ^w = 1", "2w"), "'2w' is not a name");
    EXPECT_EQ(renamed("let ^w = 1", "eye"), "'eye' is reserved");
    EXPECT_EQ(renamed("let ^w = 1\nlet h = 2", "h"), "'h' is the name of something else here");
    EXPECT_EQ(renamed("let ^w = 1\ncamera a { eye surface(u, v) = [u, v, w] }", "v"),
              "'v' is the name of something else here");
}

TEST(LanguageService, KnowsValues) {
    const std::string text =
        "let half = 90deg/2\nlet plain = -3\nlet moves = 2*t\n"
        "camera a(fov = 2*half, n = 4) {\n    let wide = n*3\n    eye sphere(wide)\n}\n";
    std::vector<std::string> found;
    for (const KnownValue& one :
         EditedText(std::make_shared<const SourceText>("test.cam", text)).values()) {
        found.push_back(fmt::format("{} = {}", text.substr(one.offset - 4, 4), one.text));
    }
    EXPECT_EQ(found, (std::vector<std::string>{"eg/2 = 45deg", "half = 90deg", " n*3 = 12"}));
}

TEST(LanguageService, OutlinesAText) {
    const std::string text =
        "let w = 1\ncamera a(fov = 2) {\n let h = 3\n}\npicture p {\n}\nlet f(x) = x";
    std::vector<std::string> found;
    for (const DeclaredName& one :
         EditedText(std::make_shared<const SourceText>("test.cam", text)).declared()) {
        found.push_back(fmt::format("{} {}", one.detail, one.name));
        for (const DeclaredName& inner : one.inside) {
            found.push_back(fmt::format("  {} {}", inner.detail, inner.name));
        }
    }
    EXPECT_EQ(found, (std::vector<std::string>{"let w", "camera a", "  parameter fov", "  let h",
                                               "picture p", "function f"}));
}

// A fix makes its error go away.
TEST(LanguageService, FixesRemedyTheirErrors) {
    std::size_t fixes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(BALCONY_BAD_FILES)) {
        if (entry.path().extension() != ".cam") {
            continue;
        }
        const std::string text = test::read_file(entry.path());
        const auto source = std::make_shared<const SourceText>("bad.cam", text);
        const CameraSource place(source, entry.path().parent_path());
        for (const Diagnostic& one : test::check(place)) {
            if (one.span.source != source) {
                continue;
            }
            for (const Fix& fix : fixes_of(one)) {
                ++fixes;
                const auto fixed = std::make_shared<const SourceText>(
                    "bad.cam", test::edited(std::string(source->text()), {fix.edit}));
                for (const Diagnostic& left :
                     test::check(CameraSource(fixed, entry.path().parent_path()))) {
                    EXPECT_FALSE(left.message == one.message && left.span.begin == one.span.begin)
                        << to_text({one}) << fix.title;
                }
            }
        }
    }
    EXPECT_GE(fixes, 20U);
}

// No question fails at any place of any of these texts, whole or cut off.
TEST(LanguageService, AnswersEverywhere) {
    for (const auto& entry : std::filesystem::directory_iterator(BALCONY_BAD_FILES)) {
        if (entry.path().extension() != ".cam" || entry.file_size() > 2000) {
            continue;
        }
        const std::string whole = test::read_file(entry.path());
        for (const std::size_t end : {whole.size(), whole.size() / 2}) {
            const EditedText text(
                std::make_shared<const SourceText>("bad.cam", whole.substr(0, end)));
            const std::size_t size = text.text()->text().size();
            (void)text.values();
            (void)text.declared();
            for (std::size_t offset = 0; offset <= size + 1; offset += 3) {
                const Completions made = text.complete(offset);
                EXPECT_LE(made.begin, made.end);
                EXPECT_LE(made.end, size);
                (void)text.hover(offset);
                (void)text.signature(offset);
                (void)text.references(offset);
            }
        }
    }
}

}  // namespace balcony::lang::language_service_test
