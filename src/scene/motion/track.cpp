// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "balcony/motion.hpp"

namespace balcony::scene {

namespace {

// A time between two keys: that after the key `before`, by a part from 0 to 1 of the time to the
// next.
struct Place {
    std::size_t before = 0;
    double part = 0.0;
    double seconds = 0.0;  // From key to key; 0 beyond the first and the last.
};

Place place_of(const Track& track, double time) {
    const std::vector<double>& times = track.times;
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin()) {
        return {};
    }
    const auto before = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end()) {
        return {before, 0.0, 0.0};
    }
    const double seconds = *after - times[before];
    return {before, (time - times[before]) / seconds, seconds};
}

// A number of a key; those of a cubic spline stand between two derivatives.
class Key {
public:
    Key(const Track& track, std::size_t key)
        : values_(track.values.data() +
                  key * track.width * (track.interpolation == Interpolation::cubic_spline ? 3 : 1)),
          width_(track.width),
          value_(track.interpolation == Interpolation::cubic_spline ? width_ : 0) {}

    [[nodiscard]] double derivative_before(std::size_t i) const { return values_[i]; }
    [[nodiscard]] double value(std::size_t i) const { return values_[value_ + i]; }
    [[nodiscard]] double derivative_after(std::size_t i) const { return values_[2 * width_ + i]; }

private:
    const float* values_;
    std::size_t width_;
    std::size_t value_;
};

// The cubic Hermite spline of glTF 2.0, appendix C.5.
double hermite(const Key& a, const Key& b, std::size_t i, const Place& place) {
    const double t = place.part;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2.0 * t3 - 3.0 * t2 + 1.0) * a.value(i) +
           place.seconds * (t3 - 2.0 * t2 + t) * a.derivative_after(i) +
           (-2.0 * t3 + 3.0 * t2) * b.value(i) + place.seconds * (t3 - t2) * b.derivative_before(i);
}

Quatd unit_rotation(double x, double y, double z, double w) {
    const Quatd turn(w, x, y, z);
    const double length = turn.length();
    return length > 0.0 && std::isfinite(length) ? turn.normalized() : Quatd();
}

Quatd rotation_of(const Key& key) {
    return unit_rotation(key.value(0), key.value(1), key.value(2), key.value(3));
}

}  // namespace

void evaluate(const Track& track, double time, std::span<double> numbers) {
    assert(numbers.size() == track.width && !track.times.empty());
    const Place place = place_of(track, time);
    const Key a(track, place.before);
    const Key b(track, place.seconds > 0.0 ? place.before + 1 : place.before);
    for (std::size_t i = 0; i < track.width; ++i) {
        if (place.part == 0.0 || track.interpolation == Interpolation::step) {
            numbers[i] = a.value(i);
        } else if (track.interpolation == Interpolation::linear) {
            numbers[i] = (1.0 - place.part) * a.value(i) + place.part * b.value(i);
        } else {
            numbers[i] = hermite(a, b, i, place);
        }
    }
}

Quatd evaluate_rotation(const Track& track, double time) {
    if (track.interpolation == Interpolation::linear) {
        const Place place = place_of(track, time);
        const Quatd a = rotation_of(Key(track, place.before));
        return place.part == 0.0 ? a
                                 : Imath::slerpShortestArc(
                                       a, rotation_of(Key(track, place.before + 1)), place.part);
    }
    std::array<double, 4> q{};
    evaluate(track, time, q);
    return unit_rotation(q[0], q[1], q[2], q[3]);
}

}  // namespace balcony::scene
