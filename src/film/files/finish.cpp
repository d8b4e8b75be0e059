// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/finish.hpp"

namespace balcony::render {

const DisplayFormat* Finish::display_format() const {
    return render::display_format(output == "-" ? "picture.png" : output);
}

double Finish::exposure_of(const Film& film) const {
    return exposure ? *exposure : display_format() != nullptr ? automatic_exposure(film) : 0.0;
}

}  // namespace balcony::render
