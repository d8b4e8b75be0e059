#!/usr/bin/env python3
# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Writes drone.cameramodel: a wide lens whose splines follow no formula. Needs python3-mrcal."""
import numpy as np

import mrcal

COLUMNS, ROWS = 10, 8
model = f"LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx={COLUMNS}_Ny={ROWS}_fov_x_deg=130"
x, y = np.meshgrid(*mrcal.knots_for_splined_models(model))
square = x * x + y * y
along_x = -0.07 * x * square + 0.004 * np.sin(3 * y) + 0.003 * x * y
along_y = -0.07 * y * square + 0.003 * np.cos(2 * x + y)
points = np.stack((along_x, along_y), axis=-1).ravel().round(5)
mrcal.cameramodel(
    intrinsics=(model, np.concatenate(([812.4, 811.7, 803.2, 596.1], points))),
    imagersize=(1600, 1200),
    extrinsics_rt_fromref=np.array([0.1, -0.2, 0.05, 1.0, 2.0, -0.5])).write("drone.cameramodel")
