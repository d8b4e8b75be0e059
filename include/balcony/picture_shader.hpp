// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Picture shader: the rays of a picture and how its layers are composited, as functions of GLSL
// ES 3.00, for a fragment shader that knows a scene.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/export.hpp"
#include "balcony/picture.hpp"

namespace balcony::bridge {

/// The text defines
///
///     const int picture_layers;          // how many cameras it shows, from the back
///     struct PictureLayer { vec3 origin; vec3 direction; float ray; float share; };
///     struct PictureColor { vec4 light; vec4 display; float presence; };
///     void picture_rays(float x, float y, float t, float lens_x, float lens_y);
///     PictureLayer picture_layer[picture_layers];     // set by picture_rays()
///     PictureColor picture_seen[picture_layers];      // set by the caller
///     PictureColor picture_color();
///
/// and expects `uniform float picture_parameters[]`, if there are any, and `float
/// picture_number(int)`, which gives the numbers of the tables. x and y are in pixels of the size
/// from the top left corner; lens_x and lens_y are from -1 to 1, and 0 for the middle of a lens. A
/// layer's `ray` is 1 where there is one, -1 where a lens lets no light through, otherwise 0; its
/// `share` is 0 where nothing of it can be seen. The caller sets what each layer shows: linear
/// light, premultiplied, and a presence of 1 where there is a ray, of 0 where there is none.
struct PictureShader {
    std::string text;
    std::vector<float> table_numbers;
    std::size_t layers = 0;
    bool has_time = false;  ///< The rays or the layers depend on t.
    bool has_lens = false;  ///< The rays depend on the point of the lens.
};

/// The shader of a picture of a size in pixels, with rays in some axes. Its numbers are single
/// precision; a warning says where that moves rays visibly. It is an error if a stage has no
/// formula, if rays are bent, and if layers are composited by depth, show some objects only or have
/// a blend mode.
[[nodiscard]] Result<PictureShader> export_picture_shader(
    const camera::Picture& picture, const std::vector<ExportParameter>& parameters, Axes axes,
    const std::array<std::size_t, 2>& size);

/// What single precision changes, if that is visible. The remedy is what helps besides moving the
/// camera.
[[nodiscard]] Diagnostics single_precision_warnings(const SinglePrecision& found,
                                                    std::string_view remedy = {});

}  // namespace balcony::bridge
