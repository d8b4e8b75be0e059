// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a camera shader in OSL sees: OSL's types and functions as its specification defines them
// (Open Shading Language 1.12), and the attributes of Cycles. OSL has no infinities: it returns 0
// for a division by 0 and for functions outside their domain.

#include <cmath>

namespace osl {

struct Triple {
    float v[3] = {0.0F, 0.0F, 0.0F};
    Triple(float all) : v{all, all, all} {}
    Triple(float x, float y, float z) : v{x, y, z} {}
    float operator[](int i) const { return v[i]; }
    Triple operator-() const { return {-v[0], -v[1], -v[2]}; }
};
using point = Triple;
using vector = Triple;
using color = Triple;

inline float abs(float a) { return std::fabs(a); }
inline float floor(float a) { return std::floor(a); }
inline float sign(float a) { return a > 0.0F ? 1.0F : a < 0.0F ? -1.0F : 0.0F; }
inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
inline float sqrt(float a) { return a > 0.0F ? std::sqrt(a) : 0.0F; }
inline float exp(float a) { return std::exp(a); }
inline float log(float a) { return a > 0.0F ? std::log(a) : -3.4e38F; }
inline float pow(float a, float b) {
    const bool undefined = (a == 0.0F && b < 0.0F) || (a < 0.0F && b != std::floor(b));
    return undefined ? 0.0F : std::pow(a, b);
}
inline float clamped(float a) { return min(max(a, -1.0F), 1.0F); }
inline float sin(float a) { return std::sin(a); }
inline float cos(float a) { return std::cos(a); }
inline float tan(float a) { return std::tan(a); }
inline float asin(float a) { return std::asin(clamped(a)); }
inline float acos(float a) { return std::acos(clamped(a)); }
inline float atan(float a) { return std::atan(a); }
inline float atan2(float y, float x) { return std::atan2(y, x); }
inline float sinh(float a) { return std::sinh(a); }
inline float cosh(float a) { return std::cosh(a); }
inline float tanh(float a) { return std::tanh(a); }
inline float radians(float a) { return a * 0.017453292519943295F; }

/// What the host of the shader sets before it calls it.
struct Host {
    Triple resolution = 0.0F;
    Triple raster = 0.0F;
    Triple aperture = 0.0F;
    float focal_distance = 1.0F;
};
extern "C" Host host;

inline point camera_shader_raster_position() { return host.raster; }
inline bool same(const char* a, const char* b) {
    while (*a != '\0' && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}
inline int getattribute(const char* name, Triple& value) {
    if (same(name, "cam:image_resolution")) {
        value = host.resolution;
        return 1;
    }
    if (same(name, "cam:aperture_position")) {
        value = host.aperture;
        return 1;
    }
    return 0;
}
inline int getattribute(const char* name, float& value) {
    value = host.focal_distance;
    return same(name, "cam:focal_distance") ? 1 : 0;
}

}  // namespace osl
