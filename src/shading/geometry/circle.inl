// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// The point of the unit circle at a part of a full turn, from 0 to 1: (cos 2πu, sin 2πu) with
/// errors below 2e-7. Quicker than the library's functions, which take any angle, and the same on
/// all machines.
BALCONY_FORMULA Float2 on_circle(Float part) {
    constexpr float turn = 2.0F * std::numbers::pi_v<float>;
    const Int quarter = truncated(4.0F * part + 0.5F);
    const Float angle = turn * (part - 0.25F * as_float(quarter));
    // Taylor's series: at an eighth of a turn, what is left out is below 3e-8.
    const Float s = angle * angle;
    const Float sine =
        angle *
        (1.0F + s * (-1.0F / 6.0F + s * (1.0F / 120.0F + s * (-1.0F / 5040.0F + s / 362880.0F))));
    const Float cosine =
        1.0F + s * (-0.5F + s * (1.0F / 24.0F + s * (-1.0F / 720.0F + s / 40320.0F)));
    const Where odd = has_bit(quarter, 1);
    return {negated_if(has_bit(quarter + 1, 2), select(odd, sine, cosine)),
            negated_if(has_bit(quarter, 2), select(odd, cosine, sine))};
}
