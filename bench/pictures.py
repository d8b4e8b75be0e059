# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Pictures as arrays, for the scripts that compare them."""
import numpy as np


def light(file, layer=""):
    """Red, green and blue of an EXR file, or of one of its layers, such as "noisy."."""
    import OpenImageIO as oiio
    image = oiio.ImageBuf(str(file))
    names = list(image.spec().channelnames)
    pixels = image.get_pixels(oiio.FLOAT)
    return np.stack([pixels[:, :, names.index(layer + c)] for c in "RGB"], axis=2).astype(float)


def boxes(picture, side):
    """The means over boxes of side x side pixels; a rest at the right and the bottom is left out."""
    height, width = (length // side * side for length in picture.shape[:2])
    return picture[:height, :width].reshape(height // side, side, width // side, side, 3).mean(
        axis=(1, 3))
