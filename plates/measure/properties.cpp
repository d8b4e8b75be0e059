// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include "measure/property.hpp"

namespace balcony::plates {

// Each is defined in the property.cpp of its plate.
Property plate_01();
Property plate_02();
Property plate_03();
Property plate_04();
Property plate_05();
Property plate_06();
Property plate_07();
Property plate_08();
Property plate_09();
Property plate_10();
Property plate_11();
Property plate_12();
Property plate_13();
Property plate_14();
Property plate_15();
Property plate_16();
Property plate_17();
Property plate_18();
Property plate_19();
Property plate_20();
Property plate_21();
Property plate_22();
Property plate_23();

std::span<const Property> properties() {
    static const std::array all{plate_01(), plate_02(), plate_03(), plate_04(), plate_05(),
                                plate_06(), plate_07(), plate_08(), plate_09(), plate_10(),
                                plate_11(), plate_12(), plate_13(), plate_14(), plate_15(),
                                plate_16(), plate_17(), plate_18(), plate_19(), plate_20(),
                                plate_21(), plate_22(), plate_23()};
    return all;
}

bool all_met(const Measurements& measurements) {
    return std::all_of(measurements.begin(), measurements.end(),
                       [](const Measurement& measurement) { return measurement.met(); });
}

}  // namespace balcony::plates
