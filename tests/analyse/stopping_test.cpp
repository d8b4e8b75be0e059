// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Long work says how far it is, and ends when it is told to.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "balcony/diagnose.hpp"
#include "balcony/drawing.hpp"
#include "balcony/inverse.hpp"
#include "support.hpp"

namespace balcony::analyse::stopping_test {

namespace {

/// The diagnostics of some work; none if it has been done.
using Run = std::function<Diagnostics(const PartDone& progress, std::stop_token stop)>;

struct Case {
    std::string name;
    Run run;
};

template <class Made>
Diagnostics errors_of(const Result<Made>& made) {
    return made ? Diagnostics() : made.diagnostics;
}

camera::Camera fisheye() { return test::standard("fisheye"); }

Locator locator() { return *Locator::make(fisheye(), 300, 300); }

std::vector<V3d> points(int count) {
    std::vector<V3d> made;
    for (int i = 0; i < count; ++i) {
        made.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 0.001 * i);
    }
    return made;
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"diagnose",
         [](const PartDone& progress, std::stop_token stop) {
             return errors_of(diagnose(fisheye(), DiagnoseSettings(), progress, stop));
         }},
        {"Locator::make",
         [](const PartDone& progress, std::stop_token stop) {
             return errors_of(Locator::make(fisheye(), 300, 300, 0.0, {}, progress, stop));
         }},
        {"Locator::locate",
         [](const PartDone& progress, std::stop_token stop) {
             std::vector<std::size_t> in_part;
             return errors_of(locator().locate(points(2000), in_part, progress, stop));
         }},
        {"Locator::locate by all processors",
         [](const PartDone& progress, std::stop_token stop) {
             std::vector<std::size_t> in_part;
             return errors_of(locator().locate(points(20000), in_part, progress, stop));
         }},
        {"draw",
         [](const PartDone& progress, std::stop_token stop) {
             return errors_of(draw(fisheye(), {}, {}, progress, stop));
         }},
        {"model",
         [](const PartDone& progress, std::stop_token stop) {
             return errors_of(model(fisheye(), {}, progress, stop));
         }},
        {"rasterise", [](const PartDone& progress, std::stop_token stop) {
             return errors_of(rasterise(*draw(fisheye()), progress, stop));
         }}};
    return all;
}

}  // namespace

TEST(Stopping, SaysHowFarItIs) {
    for (const Case& one : cases()) {
        std::vector<double> parts;
        EXPECT_TRUE(one.run([&](double part) { parts.push_back(part); }, {}).empty()) << one.name;
        ASSERT_GE(parts.size(), 2U) << one.name;
        EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end())) << one.name;
        EXPECT_GE(parts.front(), 0.0) << one.name;
        EXPECT_LT(parts.front(), 0.5) << one.name;
        EXPECT_EQ(parts.back(), 1.0) << one.name;
    }
}

TEST(Stopping, EndsInTheMiddle) {
    for (const Case& one : cases()) {
        std::stop_source stop;
        double last = 0.0;
        const Diagnostics found = one.run(
            [&](double part) {
                last = part;
                stop.request_stop();
            },
            stop.get_token());
        EXPECT_EQ(kind_of_errors(found), Kind::interrupted) << one.name;
        EXPECT_LT(last, 0.5) << one.name;
    }
}

TEST(Stopping, DoesNotBeginAfterAStop) {
    for (const Case& one : cases()) {
        std::stop_source stop;
        stop.request_stop();
        bool began = false;
        const Diagnostics found = one.run([&](double) { began = true; }, stop.get_token());
        EXPECT_EQ(kind_of_errors(found), Kind::interrupted) << one.name;
        EXPECT_FALSE(began) << one.name;
    }
}

}  // namespace balcony::analyse::stopping_test
