// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// Between the values at the corners of a triangle, by the shares of the second and the third one.
template <class Share, class Value>
BALCONY_FORMULA Value interpolated(const Share& u, const Share& v, const Value& first,
                                   const Value& second, const Value& third) {
    return (1.0F - u - v) * first + u * second + v * third;
}

/// A point of a triangle, or its place in an image, by the edges from the first corner.
template <class Point>
BALCONY_FORMULA Point point_on(const Point& first, Float u, Float v, const Point& edge_1,
                               const Point& edge_2) {
    return first + u * edge_1 + v * edge_2;
}

// ------------------------------------------------------------------------------------- normals

BALCONY_FORMULA Where has_length(const Float3& v) { return dot(v, v) > 0.0F; }

/// A vector that has a length, at length 1.
BALCONY_FORMULA Float3 unit_of(const Float3& v) {
    const Float square = dot(v, v);
    return v / root(select(square > 0.0F, square, Float(1.0F)));
}

/// -1 if a normal of the mesh is on the other side of the triangle than the viewer, otherwise 1.
/// `flat` is perpendicular to the triangle, of any length and on any side.
BALCONY_FORMULA Float side_to_viewer(const Float3& normal, const Float3& flat,
                                     const Float3& to_viewer) {
    const Float above = negated_if(dot(flat, to_viewer) < 0.0F, dot(flat, normal));
    return select(above < 0.0F, Float(-1.0F), Float(1.0F));
}

/// A unit normal that faces away from the viewer, bent until it is just above the horizon.
BALCONY_FORMULA Float3 bent_to_viewer(const Float3& normal, const Float3& to_viewer) {
    const Float min_cosine = 1e-3F;
    const Float cosine = dot(normal, to_viewer);
    const Where bends = !(cosine >= min_cosine);
    return any(bends) ? select(bends, unit_of(normal + (min_cosine - cosine) * to_viewer), normal)
                      : normal;
}

/// The unit normal of a mesh, for shading: on the side of the viewer, who sees it.
BALCONY_FORMULA Float3 shading_normal(const Float3& normal, const Float3& flat,
                                      const Float3& to_viewer) {
    return bent_to_viewer(side_to_viewer(normal, flat, to_viewer) * normal, to_viewer);
}

// ---------------------------------------------------------------------------------- footprints

/// How the point where a ray meets a plane changes with the ray, whose length is that to the plane.
/// The normal has any length; `cosine` is its product with the direction.
BALCONY_FORMULA Float3 moved_on_plane(const Float3& origin_by, const Float3& direction_by,
                                      Float length, const Float3& direction, const Float3& normal,
                                      Float cosine) {
    const Float3 moved = origin_by + length * direction_by;
    return moved - dot(moved, normal) / cosine * direction;
}

/// A vector in the plane of a triangle, in shares of its edges.
BALCONY_FORMULA Float2 in_triangle(const Float3& vector, const Float3& edge_1,
                                   const Float3& edge_2) {
    const Float3 across = cross(edge_1, edge_2);
    const Float square = dot(across, across);
    return {dot(vector, cross(edge_2, across)) / square,
            dot(vector, cross(across, edge_1)) / square};
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
