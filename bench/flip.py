# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""How different two pictures look to someone who flips between them: FLIP for pictures of low dynamic
range (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020), with its
constants."""
import numpy as np

PIXELS_PER_DEGREE = 67.02  # A monitor of 0.7 m width and 3840 pixels, seen from 0.7 m.
XYZ_FROM_RGB = np.array([[0.41238656, 0.35759149, 0.18045049],
                         [0.21263682, 0.71518298, 0.07218020],
                         [0.01933062, 0.11919716, 0.95037259]])
WHITE = XYZ_FROM_RGB.sum(axis=1)


def convolved(image, kernel):
    """With the picture's border continued."""
    radius = len(kernel) // 2
    wide = np.pad(image, radius, mode="edge")
    height, width = image.shape
    return sum(kernel[y, x] * wide[y:y + height, x:x + width]
               for y in range(2 * radius + 1) for x in range(2 * radius + 1))


def grid(radius):
    return np.meshgrid(np.arange(-radius, radius + 1), np.arange(-radius, radius + 1))


def opponent(rgb):
    """YCxCz of linear colours."""
    x, y, z = np.moveaxis(rgb @ XYZ_FROM_RGB.T / WHITE, 2, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=2)


def as_the_eye_sees(image):
    """Linear colours of a picture in YCxCz, blurred by the contrast sensitivity of the eye."""
    gaussians = (((1, 0.0047),), ((1, 0.0053),), ((34.1, 0.04), (13.5, 0.025)))
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * PIXELS_PER_DEGREE))
    x, y = grid(radius)
    squares = (x ** 2 + y ** 2) / PIXELS_PER_DEGREE ** 2
    blurred = []
    for channel, terms in enumerate(gaussians):
        kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * squares / b) for a, b in terms)
        blurred.append(convolved(image[:, :, channel], kernel / kernel.sum()))
    white_y = (blurred[0] + 16) / 116
    xyz = np.stack([white_y + blurred[1] / 500, white_y, white_y - blurred[2] / 200], axis=2)
    return np.clip(xyz * WHITE @ np.linalg.inv(XYZ_FROM_RGB).T, 0, 1)


def hunt_lab(rgb):
    t = rgb @ XYZ_FROM_RGB.T / WHITE
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    lightness = 116 * f[..., 1] - 16
    return np.stack([lightness, 0.01 * lightness * 500 * (f[..., 0] - f[..., 1]),
                     0.01 * lightness * 200 * (f[..., 1] - f[..., 2])], axis=-1)


def color_distance(a, b):
    difference = np.abs(hunt_lab(a) - hunt_lab(b))
    return (difference[..., 0] + np.hypot(difference[..., 1], difference[..., 2])) ** 0.7


def color_difference(a, b):
    largest = color_distance(np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]))
    knee = 0.4 * largest
    distance = color_distance(a, b)
    return np.where(distance < knee, 0.95 * distance / knee,
                    0.95 + (distance - knee) / (largest - knee) * 0.05)


def features(lightness):
    """How strong edges and points are."""
    deviation = 0.5 * 0.082 * PIXELS_PER_DEGREE
    x, y = grid(int(np.ceil(3 * deviation)))
    bell = np.exp(-(x ** 2 + y ** 2) / (2 * deviation ** 2))
    found = []
    for kernel in -x * bell, (x ** 2 / deviation ** 2 - 1) * bell:
        kernel = np.where(kernel > 0, kernel / kernel[kernel > 0].sum(),
                          kernel / -kernel[kernel < 0].sum())
        found.append(np.hypot(convolved(lightness, kernel), convolved(lightness, kernel.T)))
    return found


def flip(a, b):
    """The mean over all pixels, 0 to 1, of two pictures of linear colours from 0 to 1."""
    a, b = opponent(a), opponent(b)
    color = color_difference(as_the_eye_sees(a), as_the_eye_sees(b))
    pairs = zip(*(features((image[:, :, 0] + 16) / 116) for image in (a, b)))
    feature = np.maximum(*(np.abs(one - other) for one, other in pairs))
    return (color ** (1 - np.sqrt(feature / np.sqrt(2)))).mean()
