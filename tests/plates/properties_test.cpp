// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Every plate has the property that it must show, and loses it with other parameters. A suite a
// plate, so that they run side by side.

#include "measure/property.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace balcony::plates::properties_test {
namespace {

std::string text_of(const Measurements& measurements) {
    std::string text;
    for (const auto& [what, value, at_least, at_most] : measurements) {
        text += fmt::format("{}: {:.6g}, from {} to {}\n", what, value, at_least, at_most);
    }
    return text;
}

class PlateTest : public ::testing::Test {
public:
    explicit PlateTest(const Property& property) : property_(property) {}

protected:
    [[nodiscard]] const Property& property() const { return property_; }
    /// Scenes are kept from test to test.
    [[nodiscard]] static Studio& studio() {
        static Studio all;
        return all;
    }

private:
    const Property& property_;
};

class HasItsProperty : public PlateTest {
public:
    using PlateTest::PlateTest;
    void TestBody() override {
        const Measurements measured = property().measure(studio(), {});
        ASSERT_FALSE(measured.empty());
        EXPECT_TRUE(all_met(measured)) << text_of(measured);
        for (const Measurement& measurement : measured) {
            RecordProperty(measurement.what, fmt::format("{:.6g}", measurement.value));
        }
    }
};

class LosesItWithOtherParameters : public PlateTest {
public:
    using PlateTest::PlateTest;
    void TestBody() override {
        ASSERT_FALSE(property().wrong.empty());
        for (const Overrides& overrides : property().wrong) {
            const Measurements measured = property().measure(studio(), overrides);
            EXPECT_FALSE(all_met(measured))
                << overrides[0].name << " = " << overrides[0].expression << '\n'
                << text_of(measured);
        }
    }
};

template <class Test>
void add_test(const Property& property, const char* name) {
    ::testing::RegisterTest(fmt::format("Plate{}", property.plate).c_str(), name, nullptr, nullptr,
                            __FILE__, __LINE__,
                            [&property]() -> PlateTest* { return new Test(property); });
}

const bool registered = [] {
    for (const Property& property : properties()) {
        add_test<HasItsProperty>(property, "HasItsProperty");
        add_test<LosesItWithOtherParameters>(property, "LosesItWithOtherParameters");
    }
    return true;
}();

}  // namespace
}  // namespace balcony::plates::properties_test
