// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/transforms/thin_plate_spline.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::camera {

namespace {

/// A pivot below this fraction of the matrix's largest element is a rounding error of 0.
constexpr double min_pivot = 1e-13;

/// Rows of equal length, one after another.
class Matrix {
public:
    Matrix(std::size_t rows, std::size_t columns)
        : rows_(rows), columns_(columns), elements_(rows * columns) {}
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::span<double> operator[](std::size_t row) {
        return std::span(elements_).subspan(row * columns_, columns_);
    }

private:
    std::size_t rows_, columns_;
    std::vector<double> elements_;
};

/// Solves in place by Gaussian elimination with partial pivoting: the matrix is square with the
/// right-hand sides as further columns, which become the solutions. False if it is singular.
bool solve(Matrix& m) {
    const std::size_t n = m.rows();
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        for (const double element : m[i].first(n)) {
            largest = std::max(largest, std::fabs(element));
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < n; ++k) {
            pivot = std::fabs(m[k][i]) > std::fabs(m[pivot][i]) ? k : pivot;
        }
        if (!(std::fabs(m[pivot][i]) > min_pivot * largest)) {
            return false;
        }
        std::swap_ranges(m[i].begin(), m[i].end(), m[pivot].begin());
        const std::span<double> own = m[i];
        for (std::size_t k = i + 1; k < n; ++k) {
            const std::span<double> row = m[k];
            const double factor = row[i] / own[i];
            for (std::size_t c = i; c < m.columns(); ++c) {
                row[c] -= factor * own[c];
            }
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t c = n; c < m.columns(); ++c) {
            double sum = m[i][c];
            for (std::size_t k = i + 1; k < n; ++k) {
                sum -= m[i][k] * m[k][c];
            }
            m[i][c] = sum / m[i][i];
        }
    }
    return true;
}

double squared_distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sum;
}

}  // namespace

double thin_plate_kernel(double squared_distance, std::size_t dimension) {
    if (squared_distance == 0.0) {
        return 0.0;
    }
    return dimension == 2 ? squared_distance * std::log(squared_distance)
                          : -std::sqrt(squared_distance);
}

std::optional<ThinPlateSpline> fit_thin_plate(std::span<const double> sites, std::size_t dimension,
                                              std::span<const double> values, std::size_t results,
                                              double smoothing) {
    const std::size_t n = sites.size() / dimension;
    const std::size_t affine = dimension + 1;
    const auto site = [&](std::size_t i) { return sites.subspan(i * dimension, dimension); };

    // (K + n smoothing 1) w + P a = values and P^T w = 0, where the rows of P are (1, site). P is
    // scaled to the size of the neighbouring block, and a by the inverse.
    const double scale = 1.0 + static_cast<double>(n) * smoothing;
    Matrix system(n + affine, n + affine + results);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) {
            system[i][k] = thin_plate_kernel(squared_distance(site(i), site(k)), dimension);
        }
        system[i][i] = static_cast<double>(n) * smoothing;
        for (std::size_t k = 0; k < affine; ++k) {
            system[i][n + k] = system[n + k][i] = scale * (k == 0 ? 1.0 : site(i)[k - 1]);
        }
        for (std::size_t k = 0; k < results; ++k) {
            system[i][n + affine + k] = values[i * results + k];
        }
    }
    if (!solve(system)) {
        return std::nullopt;
    }
    ThinPlateSpline spline{dimension, results, {}, {}};
    for (std::size_t i = 0; i < n + affine; ++i) {
        for (const double solution : system[i].last(results)) {
            if (i < n) {
                spline.weights.push_back(solution);
            } else {
                spline.affine.push_back(scale * solution);
            }
        }
    }
    return spline;
}

}  // namespace balcony::camera
