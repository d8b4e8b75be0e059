// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/finish.hpp"

namespace balcony::render {

const DisplayFormat* Finish::display_format() const {
    return render::display_format(output == "-" ? "picture.png" : output);
}

}  // namespace balcony::render
