// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/room/painted.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace balcony::plates::room {

namespace {

using std::numbers::pi;

// A capital letter of height 1 as pen strokes, and its width.
struct Letter {
    std::vector<Path> strokes;
    double width;
};

// One stroke for each side, so that corners are round.
void add_sides(Letter& letter, const Path& corners) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        letter.strokes.push_back({corners[i], corners[i + 1]});
    }
}

// From a stem at x = 0 to the right and back to it.
void add_bowl(Letter& letter, double low, double high, double straight) {
    const double radius = (high - low) / 2.0;
    Path bowl{{0.0, high}};
    const Path round = arc(V2d(straight, low + radius), radius, pi / 2.0, -pi / 2.0);
    bowl.insert(bowl.end(), round.begin(), round.end());
    bowl.emplace_back(0.0, low);
    letter.strokes.push_back(bowl);
}

Letter letter_of(char name) {
    Letter letter;
    const auto sides = [&](const Path& corners, double width) {
        add_sides(letter, corners);
        letter.width = width;
    };
    switch (name) {
        case 'A':
            sides({{0.0, 0.0}, {0.4, 1.0}, {0.8, 0.0}}, 0.8);
            sides({{0.13, 0.33}, {0.67, 0.33}}, 0.8);
            break;
        case 'B':
            sides({{0.0, 0.0}, {0.0, 1.0}}, 0.58);
            add_bowl(letter, 0.54, 1.0, 0.3);
            add_bowl(letter, 0.0, 0.54, 0.31);
            break;
        case 'C':
            letter.strokes.push_back(arc(V2d(0.5, 0.5), 0.5, 0.27 * pi, 1.73 * pi));
            letter.width = 0.84;
            break;
        case 'L': sides({{0.0, 1.0}, {0.0, 0.0}, {0.5, 0.0}}, 0.5); break;
        case 'M':
            sides({{0.0, 0.0}, {0.06, 1.0}, {0.45, 0.25}, {0.84, 1.0}, {0.9, 0.0}}, 0.9);
            break;
        case 'N': sides({{0.0, 0.0}, {0.0, 1.0}, {0.66, 0.0}, {0.66, 1.0}}, 0.66); break;
        case 'O':
            letter.strokes.push_back(arc(V2d(0.5, 0.5), 0.5, 0.0, 2.0 * pi));
            letter.width = 1.0;
            break;
        case 'R':
            sides({{0.0, 0.0}, {0.0, 1.0}}, 0.6);
            add_bowl(letter, 0.46, 1.0, 0.3);
            sides({{0.3, 0.46}, {0.6, 0.0}}, 0.6);
            break;
        case 'Y':
            sides({{0.0, 1.0}, {0.38, 0.46}, {0.76, 1.0}}, 0.76);
            sides({{0.38, 0.46}, {0.38, 0.0}}, 0.76);
            break;
        default: letter.width = 0.4; break;
    }
    return letter;
}

constexpr double letter_gap = 0.42;

// A word between two edges; its height follows from its width.
void write(Drawing& drawing, std::string_view word, const V2d& low_left, double width,
           const Color& color) {
    double natural = -letter_gap;
    for (const char name : word) {
        natural += letter_of(name).width + letter_gap;
    }
    const double size = width / natural;
    V2d at = low_left;
    for (const char name : word) {
        const Letter letter = letter_of(name);
        for (const Path& stroke : letter.strokes) {
            drawing.fill(line(placed(stroke, {.scale = V2d(size), .offset = at}), 0.19 * size),
                         color);
        }
        at.x += (letter.width + letter_gap) * size;
    }
}

void fill_box(Drawing& drawing, const V2d& low, const V2d& high, const Color& color) {
    drawing.fill({low, {high.x, low.y}, high, {low.x, high.y}}, color);
}

// How far inside the rug a place is, from its edge; negative outside. Half its size is (1.4, 1).
double from_edge(const V2d& at) { return std::min(1.4 - std::abs(at.x), 1.0 - std::abs(at.y)); }

// Distance from the origin in a norm between circle and square.
double lozenge(const V2d& at, const V2d& half) {
    return std::abs(at.x) / half.x + std::abs(at.y) / half.y;
}

}  // namespace

Color oak_boards(const Sample& sample) {
    static const Gradient oak({0x6a4526, 0x8a5e37, 0xa47646, 0xb98c5a});
    constexpr int rows = 12;
    const double across = (sample.point.y + 1.0) * rows / 2.0;
    const int board = static_cast<int>(std::floor(across));
    const V2d in(std::fmod((sample.point.x + 1.0) / 2.0 + 0.382 * board, 1.0), across - board);
    const double grain =
        fractal_noise(V2d(in.x * 5.0 + board * 9.1, in.y * 7.0 + board * 3.0), 4, 91);
    const double rings = noise(V2d(in.x * 1.7 + board * 5.3, in.y * 26.0 + 3.0 * grain), 92);
    const double shade =
        0.5 + 0.5 * (lattice_noise(board, 1, 93) - 0.5) + 0.2 * grain + 0.14 * rings;
    const double joint = std::min(std::min(in.y, 1.0 - in.y), std::min(in.x, 1.0 - in.x) * rows);
    return oak(shade) * (0.4 + 0.6 * smooth_step(0.0, 0.03, joint));
}

Color wallpaper(const Sample& sample) {
    // Sprigs on a half-drop repeat, between thin stripes.
    const V2d at = sample.point;
    const double column = std::floor((at.x + 1.0));
    const double y = std::remainder(at.y + (column > 0.0 ? 1.0 : 0.0), 2.0);
    const V2d in(std::remainder(at.x - 0.5, 1.0), y);
    const double angle = std::atan2(in.y, in.x);
    const double petals = 0.16 + 0.09 * std::cos(6.0 * angle);
    const double flower = smooth_step(petals + 0.015, petals - 0.015, in.length());
    const double stripe = smooth_step(0.015, 0.005, std::abs(std::remainder(at.x, 1.0)));
    return mix(Color(0.86, 0.85, 0.79), Color(0.62, 0.66, 0.52), std::max(flower, 0.6 * stripe));
}

Color carpet(const Sample& sample) {
    const Color red = from_srgb(0x8e2a26);
    const Color navy = from_srgb(0x22304f);
    const Color cream = from_srgb(0xe4d3ae);
    const Color gold = from_srgb(0xc08a3c);
    const V2d at = sample.point;
    const double in = from_edge(at);
    const V2d folded(std::abs(at.x), std::abs(at.y));
    if (in < 0.03 || (in > 0.27 && in < 0.30)) {
        return cream;
    }
    if (in < 0.27) {
        // The border: a row of lozenges between two lines.
        const bool on_side = 1.4 - folded.x < 1.0 - folded.y;
        const double along = std::remainder(on_side ? at.y : at.x, 0.2);
        const double d = lozenge(V2d(along, in - 0.15), V2d(0.09, 0.085));
        return d < 0.45 ? gold : d < 1.0 ? cream : navy;
    }
    // The medallion with its lobes, and quarters of it in the corners.
    const double angle = std::atan2(at.y, at.x * 0.72);
    const double reach = V2d(at.x * 0.72, at.y).length();
    const double lobes = 0.46 + 0.045 * std::cos(16.0 * angle);
    if (reach < lobes) {
        const double rosette = 0.2 + 0.07 * std::cos(8.0 * angle);
        return reach < 0.08            ? gold
               : reach < rosette       ? cream
               : reach < rosette + .03 ? gold
               : reach < lobes - 0.035 ? navy
                                       : gold;
    }
    const double corner = V2d((1.1 - folded.x) * 0.8, 0.7 - folded.y).length();
    const double scallop = 0.3 + 0.03 * std::cos(20.0 * std::atan2(folded.y - 0.7, folded.x - 1.1));
    if (corner < scallop) {
        return corner > scallop - 0.03 ? gold : navy;
    }
    // Small flowers in the field.
    const V2d flower(std::remainder(at.x, 0.22), std::remainder(at.y + 0.11, 0.22));
    return flower.length() < 0.032 ? cream : flower.length() < 0.05 ? gold : red;
}

Color marble(const Sample& sample) {
    static const Gradient stone({0x8d8880, 0xd8d3c9, 0xece8e0, 0xf4f1ea});
    const double swirl = fractal_noise(sample.point * 1.5, 5, 61);
    const double vein = std::abs(noise(sample.point * 2.0 + V2d(2.0 * swirl, swirl), 62));
    return stone(0.35 + 0.65 * smooth_step(0.0, 0.22, vein) + 0.15 * swirl);
}

Color clock_dial(const Sample& sample) {
    const Color ink = from_srgb(0x1d1a17);
    const double radius = sample.point.length();
    if (radius > 0.97) {
        return from_srgb(0xc79a45);
    }
    // Hours clockwise from the top.
    const double turn = std::atan2(sample.point.x, sample.point.y) / (2.0 * pi);
    const auto hand = [&](double hours, double length, double width) {
        const double angle = hours / 12.0 * 2.0 * pi;
        const V2d way(std::sin(angle), std::cos(angle));
        const double along = sample.point.dot(way);
        const double off = std::abs(sample.point.x * way.y - sample.point.y * way.x);
        return along > -0.12 && along < length && off < width * (1.2 - along / length);
    };
    if (hand(4.0 + 5.0 / 60.0, 0.5, 0.055) || hand(1.0, 0.76, 0.04) || radius < 0.06) {
        return ink;
    }
    const double hour = std::abs(std::remainder(turn * 12.0, 1.0)) * radius;
    const bool quarter = std::abs(std::remainder(turn * 4.0, 1.0)) < 0.1;
    if (radius > (quarter ? 0.62 : 0.7) && radius < 0.9 && hour < (quarter ? 0.085 : 0.05)) {
        return ink;
    }
    return from_srgb(0xf2ead8);
}

Color globe_map(const Sample& sample) {
    // Two by one; noise on the sphere, so that it closes.
    const double longitude = sample.point.x / 2.0 * pi;
    const double latitude = sample.point.y * pi / 2.0;
    const double x = std::cos(latitude) * std::cos(longitude);
    const double y = std::cos(latitude) * std::sin(longitude);
    const double z = std::sin(latitude);
    const double land = fractal_noise(V2d(1.7 * x + 4.0, 1.7 * y + 1.3 * z), 5, 9) +
                        fractal_noise(V2d(1.9 * z + 9.0, 1.9 * x - y), 4, 10);
    static const Gradient soil({0xc9b06a, 0x8a9a58, 0x6f7f4a});
    const bool line = std::abs(std::remainder(latitude, pi / 6.0)) < 0.012 ||
                      std::abs(std::remainder(longitude, pi / 6.0)) * std::cos(latitude) < 0.012;
    return (land > 0.08 ? soil(land) : from_srgb(0x3f6f8f)) * (line ? 0.75 : 1.0);
}

Color countryside(const Sample& sample) {
    const double y = sample.point.y;
    const double x = sample.point.x;
    const double ridge =
        0.05 * noise(V2d(x * 2.2 + 7.0, 0.0), 31) + 0.03 * noise(V2d(x * 6.0, 1.0), 32);
    if (y > ridge + 0.07) {
        const double cloud =
            smooth_step(0.05, 0.5, fractal_noise(V2d(x * 1.4, y * 3.0 + 5.0), 5, 33));
        const Color sky = mix(Color(0.55, 0.72, 0.9), Color(0.34, 0.56, 0.95), y);
        return mix(sky, Color(0.95), 0.8 * cloud);
    }
    // Hills, a lake and meadows, much darker than the sky.
    if (y > -0.02) {
        return mix(Color(0.10, 0.14, 0.17), Color(0.06, 0.10, 0.07), (ridge + 0.07 - y) * 8.0);
    }
    if (y > -0.14) {
        const double glitter = noise(V2d(x * 3.0, y * 90.0), 34);
        return Color(0.10, 0.15, 0.19) * (1.0 + 0.25 * glitter);
    }
    const double shore = -0.14 - 0.05 * noise(V2d(x * 3.0, 4.0), 35);
    const double wood = fractal_noise(V2d(x * 7.0, y * 9.0), 4, 36);
    const Color meadow = mix(Color(0.055, 0.085, 0.02), Color(0.10, 0.11, 0.035), 0.5 + wood);
    const bool trees = wood > 0.12 - 0.4 * (y - shore) * (y - shore) && y > -0.75;
    return trees ? Color(0.018, 0.035, 0.012) * (1.3 + wood) : meadow;
}

Drawing paint_poster() {
    const Color night = from_srgb(0x1f3a5f);
    const Color cream = from_srgb(0xf3e6c8);
    Drawing drawing(448, 0.8, 1.15, cream);
    // A sunset over the sea.
    const V2d low(0.05, 0.05);
    const V2d high(0.75, 0.87);
    const std::array sky{0xe8a13aU, 0xe38a3cU, 0xd96f41U, 0xb9524aU, 0x7d3f58U, 0x4a3a63U};
    for (std::size_t k = 0; k < sky.size(); ++k) {
        const double from = 0.42 + 0.075 * static_cast<double>(k);
        fill_box(drawing, V2d(low.x, from), high, from_srgb(sky[k]));
    }
    drawing.fill(ellipse(V2d(0.47, 0.47), V2d(0.13)), from_srgb(0xf9d976));
    fill_box(drawing, low, V2d(high.x, 0.42), night);
    for (int k = 0; k < 7; ++k) {
        const double half = 0.13 - 0.014 * k;
        const double y = 0.405 - 0.028 * k;
        fill_box(drawing, V2d(0.47 - half, y), V2d(0.47 + half, y + 0.011), from_srgb(0xf0b95a));
    }
    // A balustrade before it.
    fill_box(drawing, V2d(low.x, 0.28), V2d(high.x, 0.32), cream);
    fill_box(drawing, low, V2d(high.x, 0.09), cream);
    const Path side{{0.010, 0.09}, {0.022, 0.13}, {0.030, 0.16}, {0.020, 0.20},
                    {0.011, 0.23}, {0.018, 0.26}, {0.018, 0.28}};
    for (int k = 0; k < 8; ++k) {
        const double x = 0.1 + 0.0857 * k;
        Path baluster;
        for (const V2d& p : side) {
            baluster.emplace_back(x + p.x, p.y);
        }
        for (auto p = side.rbegin(); p != side.rend(); ++p) {
            baluster.emplace_back(x - p->x, p->y);
        }
        drawing.fill(baluster, cream);
    }
    write(drawing, "BALCONY", V2d(0.07, 0.94), 0.66, night);
    return drawing;
}

Drawing paint_magazine() {
    Drawing drawing(160, 0.22, 0.30, from_srgb(0xd9e3dc));
    write(drawing, "ROOM", V2d(0.025, 0.235), 0.17, from_srgb(0xb3372c));
    fill_box(drawing, V2d(0.02, 0.02), V2d(0.2, 0.21), from_srgb(0x35616a));
    drawing.fill(ellipse(V2d(0.11, 0.115), V2d(0.06)), from_srgb(0xe9c46a));
    fill_box(drawing, V2d(0.02, 0.02), V2d(0.2, 0.07), from_srgb(0x7a4a2c));
    return drawing;
}

}  // namespace balcony::plates::room
