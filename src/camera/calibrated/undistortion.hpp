// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/emitter.hpp"
#include "camera/calibrated/distortion.hpp"

namespace balcony::camera {

/// The inverse of a distortion as a formula: a polynomial guess and as many Newton steps as the
/// lens needs, which is measured when it is made.
///
/// It is defined in the largest disc about 0 where the distortion certainly has one inverse: where
/// the symmetric part of its Jacobian is positive definite. (A map with this property on a convex
/// set is one to one.) A radial distortion has it up to its fold, beyond which the lens would show
/// the same things again.
class Undistortion {
public:
    /// `needed` is how far from 0 its argument goes; `limit` is how far its result may go.
    Undistortion(Distortion distortion, double needed, double limit);

    /// Nothing if the distortion folds at once.
    [[nodiscard]] bool exists() const { return radius_ > 0.0; }
    /// The point that the distortion maps to p, to within 1e-13 of what is needed. Requires that
    /// there is one in the disc.
    [[nodiscard]] PlanePoint<Expr> emit(const PlanePoint<Expr>& p, Emitter& emit) const;
    /// The radius of the disc of results.
    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] std::size_t steps() const { return steps_; }

private:
    [[nodiscard]] bool is_monotone_at(double radius) const;
    void find_radius(double limit);
    void fit_guess();
    void count_steps();

    template <class Number>
    [[nodiscard]] Number guessed_ratio(const Number& squared_radius) const;
    template <class Number>
    [[nodiscard]] PlanePoint<Number> solved(const PlanePoint<Number>& p, std::size_t steps) const;

    Distortion distortion_;
    double needed_;
    double radius_ = 0.0;
    double squared_reach_ = 0.0;  ///< Of the radial part at the radius.
    bool folds_ = false;
    /// The ratio of a radius to its distorted one, as a polynomial from -1 to 1: in q, the square
    /// of the latter as a part of the squared reach, or in √(1 − q), which is smooth at a fold.
    std::vector<double> guess_;
    std::size_t steps_ = 0;
};

}  // namespace balcony::camera
