// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// Where a value lies between the nodes of a table.
struct TablePosition {
    Index node;      ///< The lower one.
    Float fraction;  ///< From it to the next.
};

/// `position` counts nodes from the first of `count`; beyond them it is moved to the nearest.
BALCONY_FORMULA TablePosition table_position(Float position, std::size_t count) {
    const float last = static_cast<float>(count - 1);
    const Float inside = or_zero(position > 0.0F, smaller(position, last));
    const Int node = truncated(smaller(inside, last - 1.0F));
    return {as_index(node), inside - as_float(node)};
}

/// The cosines of the tables: narrow where they are small, since there the masking of a smooth
/// layer changes within its width.
inline constexpr std::size_t cosine_count = 48;

BALCONY_FORMULA TablePosition position_of_cosine(Float cosine) {
    return table_position(root(root(larger(0.0F, cosine))) * static_cast<float>(cosine_count - 1),
                          cosine_count);
}
