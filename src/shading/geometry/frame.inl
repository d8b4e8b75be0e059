// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// Axes x and y that make a right-handed frame with a unit z: Duff et al., "Building an Orthonormal
/// Basis, Revisited" (2017).
struct Frame {
    BALCONY_FORMULA explicit Frame(const Float3& normal) : z(normal) {
        const Float sign = sign_of(z.z);
        const Float a = -1.0F / (sign + z.z);
        const Float b = z.x * z.y * a;
        x = {1.0F + sign * z.x * z.x * a, sign * b, -sign * z.x};
        y = {b, sign + z.y * z.y * a, -z.y};
    }

    BALCONY_FORMULA Float3 to_local(const Float3& v) const {
        return {dot(v, x), dot(v, y), dot(v, z)};
    }
    BALCONY_FORMULA Float3 to_world(const Float3& v) const { return v.x * x + v.y * y + v.z * z; }

    Float3 x, y, z;
};

/// On the unit hemisphere about z, with density cosine over pi: from a number in [0, 1), and
/// on_circle() of another one.
BALCONY_FORMULA Float3 cosine_direction(Float u, const Float2& around) {
    const Float radius = root(u);
    return {radius * around.x, radius * around.y, root(1.0F - u)};
}
