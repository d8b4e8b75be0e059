// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// Between the values at the corners of a triangle, by the shares of the second and the third one.
template <class Share, class Value>
BALCONY_FORMULA Value interpolated(const Share& u, const Share& v, const Value& first,
                                   const Value& second, const Value& third) {
    return (1.0F - u - v) * first + u * second + v * third;
}

/// A vector from a point of a ray, moved along the ray's direction onto a plane through the point.
/// The normal has any length; `cosine` is its product with the direction.
BALCONY_FORMULA Float3 onto_plane(const Float3& vector, const Float3& normal, Float cosine,
                                  const Float3& direction) {
    return vector - dot(vector, normal) / cosine * direction;
}

/// The point of a triangle in an image, by its edges from the first corner.
BALCONY_FORMULA Float2 point_in_image(const Float2& first, Float u, Float v, const Float2& edge_1,
                                      const Float2& edge_2) {
    return first + u * edge_1 + v * edge_2;
}

/// The change in the image by that in the triangle, of a limited size; 0 if it is not finite.
BALCONY_FORMULA Float2 slope_in_image(const Float2& along, const Float2& edge_1,
                                      const Float2& edge_2) {
    const Float2 slope = along.x * edge_1 + along.y * edge_2;
    const Float widest = MeshPoint::widest_footprint;
    const Float width = larger(absolute(slope.x), absolute(slope.y));
    return or_zero(both(is_finite(slope.x), is_finite(slope.y)),
                   slope * select(width > widest, widest / width, Float(1.0F)));
}
