// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// A point of a mesh in the world. Imath's own product divides by the last coordinate, which is 1.
BALCONY_FORMULA Float3 placed(const Float3& point, const Imath::M44f& world_from_mesh) {
    const auto component = [&](int j) {
        return point.x * world_from_mesh[0][j] + point.y * world_from_mesh[1][j] +
               point.z * world_from_mesh[2][j] + world_from_mesh[3][j];
    };
    return {component(0), component(1), component(2)};
}

/// A normal of a mesh in the world, of any length.
BALCONY_FORMULA Float3 placed(const Float3& normal, const Imath::M33f& normal_from_mesh) {
    const auto component = [&](int j) {
        return normal.x * normal_from_mesh[0][j] + normal.y * normal_from_mesh[1][j] +
               normal.z * normal_from_mesh[2][j];
    };
    return {component(0), component(1), component(2)};
}
