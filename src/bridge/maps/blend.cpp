// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/blend.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "balcony/display_file.hpp"
#include "balcony/output_file.hpp"
#include "balcony/progress.hpp"
#include "bridge/maps/in_order.hpp"

namespace balcony::bridge {

namespace {

/// For each element of a line, the least sum of a value of the line and the squared distance to
/// it: the lower envelope of parabolas (P. Felzenszwalb and D. Huttenlocher, "Distance Transforms
/// of Sampled Functions", 2012).
class LineTransform {
public:
    void operator()(std::vector<double>& line) {
        const auto size = static_cast<std::ptrdiff_t>(line.size());
        parabolas_.assign(line.size(), 0);
        borders_.assign(line.size() + 1, 0.0);
        std::ptrdiff_t last = 0;
        borders_[0] = -std::numeric_limits<double>::infinity();
        borders_[1] = -borders_[0];
        const auto height = [&line](std::ptrdiff_t i) {
            return line[static_cast<std::size_t>(i)] + static_cast<double>(i * i);
        };
        for (std::ptrdiff_t q = 1; q < size; ++q) {
            double crossing = 0.0;
            while (true) {
                const std::ptrdiff_t p = parabola(last);
                crossing = (height(q) - height(p)) / static_cast<double>(2 * (q - p));
                if (crossing > borders_[static_cast<std::size_t>(last)]) {
                    break;
                }
                --last;
            }
            ++last;
            parabolas_[static_cast<std::size_t>(last)] = q;
            borders_[static_cast<std::size_t>(last)] = crossing;
            borders_[static_cast<std::size_t>(last + 1)] = -borders_[0];
        }
        made_.resize(line.size());
        std::ptrdiff_t k = 0;
        for (std::ptrdiff_t q = 0; q < size; ++q) {
            while (borders_[static_cast<std::size_t>(k + 1)] < static_cast<double>(q)) {
                ++k;
            }
            const std::ptrdiff_t p = parabola(k);
            made_[static_cast<std::size_t>(q)] =
                line[static_cast<std::size_t>(p)] + static_cast<double>((q - p) * (q - p));
        }
        line.swap(made_);
    }

private:
    [[nodiscard]] std::ptrdiff_t parabola(std::ptrdiff_t k) const {
        return parabolas_[static_cast<std::size_t>(k)];
    }
    std::vector<std::ptrdiff_t> parabolas_;
    std::vector<double> borders_;
    std::vector<double> made_;
};

/// The distance of places in a picture from the border of what has rays, as a part of its shorter
/// side.
class BorderDistance {
public:
    explicit BorderDistance(const RayGrid& rays) : width_(rays.width()), height_(rays.height()) {
        distances_.resize(width_ * height_);
        rays::Scratch scratch;
        rays::RayBatch batch;
        constexpr double far = 1e12;  // Finite, so that parabolas cross.
        for (std::size_t y = 0; y < height_; ++y) {
            for (std::size_t x = 0; x < width_; x += program::max_tile_width) {
                const std::size_t count = std::min(program::max_tile_width, width_ - x);
                rays.run(x, y, count, 1, scratch, batch);
                for (std::size_t i = 0; i < count; ++i) {
                    distances_[y * width_ + x + i] = batch.valid(i) ? far : 0.0;
                }
            }
        }
        LineTransform transform;
        std::vector<double> line;
        for (std::size_t x = 0; x < width_; ++x) {
            line.clear();
            for (std::size_t y = 0; y < height_; ++y) {
                line.push_back(distances_[y * width_ + x]);
            }
            transform(line);
            for (std::size_t y = 0; y < height_; ++y) {
                distances_[y * width_ + x] = line[y];
            }
        }
        for (std::size_t y = 0; y < height_; ++y) {
            const auto row = distances_.begin() + static_cast<std::ptrdiff_t>(y * width_);
            line.assign(row, row + static_cast<std::ptrdiff_t>(width_));
            transform(line);
            // The border is halfway between a pixel with a ray and one without.
            std::transform(line.begin(), line.end(), row,
                           [](double squared) { return std::max(0.0, std::sqrt(squared) - 0.5); });
        }
    }

    [[nodiscard]] double operator()(const V2d& place) const {
        const auto w = static_cast<double>(width_);
        const auto h = static_cast<double>(height_);
        const V2d at(std::clamp(place.x - 0.5, 0.0, w - 1.0),
                     std::clamp(place.y - 0.5, 0.0, h - 1.0));
        const auto x = static_cast<std::size_t>(at.x);
        const auto y = static_cast<std::size_t>(at.y);
        const std::size_t right = std::min(x + 1, width_ - 1);
        const std::size_t below = std::min(y + 1, height_ - 1);
        const double fx = at.x - static_cast<double>(x);
        const double fy = at.y - static_cast<double>(y);
        const auto of = [this](std::size_t column, std::size_t row) {
            return distances_[row * width_ + column];
        };
        const double within = std::lerp(std::lerp(of(x, y), of(right, y), fx),
                                        std::lerp(of(x, below), of(right, below), fx), fy);
        const double sides = std::min({place.x, place.y, w - place.x, h - place.y});
        return std::max(0.0, std::min(within, sides)) / std::min(w, h);
    }

private:
    std::size_t width_, height_;
    std::vector<double> distances_;  ///< In pixels.
};

// All projectors are seen from one place.
Diagnostics check_viewpoints(const std::vector<SourceCamera>& projectors) {
    Diagnostics found;
    const V3d first = find_viewpoint(projectors.front().rays).point;
    for (const SourceCamera& each : projectors) {
        const V3d own = find_viewpoint(each.rays).point;
        constexpr double rounding = 1e-6;
        if ((own - first).length() > rounding * (1e-3 + std::max(own.length(), first.length()))) {
            found.push_back(error(
                fmt::format("the cameras '{}' and '{}' see from different places, ({:.4g}, {:.4g}, "
                            "{:.4g}) and ({:.4g}, {:.4g}, {:.4g})",
                            projectors.front().rays.name(), each.rays.name(), first.x, first.y,
                            first.z, own.x, own.y, own.z),
                {},
                "give them the audience's eye and project their light on the dome: eye "
                "point(seat), "
                "and move project(projector, onto = sphere(radius)) after toward"));
            return found;
        }
    }
    return found;
}

}  // namespace

class Blend::Index {
public:
    struct Projector {
        RayGrid rays;
        BorderDistance distance;
        /// From its pixels to the pictures of the others.
        std::vector<std::pair<std::size_t, StMap>> others{};
    };
    std::vector<Projector> projectors;

    // `places` are those in the picture of another projector, in the same order.
    void add_shares(const Projector& other, const std::vector<SourcePlace>& places,
                    std::vector<double>& others) const {
        const V2d size(static_cast<double>(other.rays.width()),
                       static_cast<double>(other.rays.height()));
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i].valid) {
                others[i] += other.distance(V2d(places[i].st.x, 1.0 - places[i].st.y) * size);
            }
        }
    }

    // At the border of the only projector there is no distance to divide by.
    [[nodiscard]] static double share(double own, double others) {
        return others > 0.0 ? own / (own + others) : 1.0;
    }
};

Result<Blend> Blend::make(const std::vector<SourceCamera>& projectors, Parallax parallax,
                          const std::stop_token& stop) {
    auto index = std::make_shared<Index>();
    Diagnostics found;
    for (const SourceCamera& each : projectors) {
        index->projectors.push_back({each.rays, BorderDistance(each.rays)});
    }
    if (parallax == Parallax::refuse) {
        found = check_viewpoints(projectors);
    }
    for (std::size_t i = 0; i < projectors.size() && !has_errors(found); ++i) {
        for (std::size_t j = 0; j < projectors.size(); ++j) {
            if (stop.stop_requested()) {
                return stopped();
            }
            if (i == j) {
                continue;
            }
            auto map = StMap::make(projectors[i].rays, projectors[j], parallax);
            if (!map) {
                return map.diagnostics;
            }
            index->projectors[i].others.emplace_back(j, std::move(*map));
        }
    }
    return has_errors(found) ? Result<Blend>(found) : Result<Blend>(Blend(std::move(index)), found);
}

std::size_t Blend::size() const { return index_->projectors.size(); }
const RayGrid& Blend::rays(std::size_t projector) const {
    return index_->projectors[projector].rays;
}

void Blend::run(std::size_t projector, std::size_t first_row, std::size_t rows,
                std::vector<double>& shares) const {
    const Index::Projector& own = index_->projectors[projector];
    const std::size_t width = own.rays.width();
    std::vector<double> others(rows * width, 0.0);
    std::vector<SourcePlace> places;
    for (const auto& [number, map] : own.others) {
        map.run(first_row, rows, places);
        index_->add_shares(index_->projectors[number], places, others);
    }
    shares.clear();
    for (std::size_t i = 0; i < others.size(); ++i) {
        const V2d place(static_cast<double>(i % width) + 0.5,
                        static_cast<double>(first_row + i / width) + 0.5);
        const double distance = own.distance(place);
        shares.push_back(distance > 0.0 ? Index::share(distance, others[i]) : 0.0);
    }
}

void Blend::at(std::size_t projector, std::span<const V2d> places,
               std::vector<double>& shares) const {
    const Index::Projector& own = index_->projectors[projector];
    std::vector<double> others(places.size(), 0.0);
    std::vector<SourcePlace> shown;
    for (const auto& [number, map] : own.others) {
        map.at(places, shown);
        index_->add_shares(index_->projectors[number], shown, others);
    }
    shares.clear();
    for (std::size_t i = 0; i < places.size(); ++i) {
        shares.push_back(Index::share(own.distance(places[i]), others[i]));
    }
}

// ----------------------------------------------------------------------------------------- files

namespace {

struct MaskRows {
    RowSpan span;
    std::vector<double> shares;
};

bool for_all_rows(const Blend& blend, std::size_t projector, const std::stop_token& stop,
                  const std::function<bool(const MaskRows&)>& use) {
    const RayGrid& rays = blend.rays(projector);
    return run_in_order<MaskRows>(
        rays.width(), rays.height(),
        [&](const RowSpan& span) {
            MaskRows made{span, {}};
            blend.run(projector, span.first, span.count, made.shares);
            return made;
        },
        use, stop);
}

}  // namespace

MaskWritten write_mask(const Blend& blend, std::size_t projector, double gamma,
                       const std::filesystem::path& file, const std::stop_token& stop) {
    const render::DisplayFormat* const format = render::display_format(file);
    if (format == nullptr || format->max_bits < 16) {
        return {.problems = {error(Kind::usage,
                                   fmt::format("'{}' is no name for a mask", file.string()),
                                   "use a file name that ends in .png or .tif")}};
    }
    MaskWritten written;
    const RayGrid& rays = blend.rays(projector);
    std::vector<std::uint16_t> samples;
    const bool complete = for_all_rows(blend, projector, stop, [&](const MaskRows& rows) {
        for (const double share : rows.shares) {
            written.overlap += share > 0.0 && share < 1.0 ? 1 : 0;
            const auto level =
                static_cast<std::uint16_t>(std::lround(65535.0 * std::pow(share, 1.0 / gamma)));
            samples.insert(samples.end(), 3, level);
        }
        return true;
    });
    if (!complete) {
        written.problems = {stopped()};
        return written;
    }
    const auto bytes = render::encode(samples, {rays.width(), rays.height(), 3}, *format);
    written.problems = bytes ? write_whole(file, *bytes) : bytes.diagnostics;
    return written;
}

WarpMesh warp_mesh(const Blend& blend, std::size_t projector, const StMap& picture,
                   std::size_t columns, std::size_t rows, std::optional<double> gamma) {
    const RayGrid& rays = blend.rays(projector);
    const V2d size(static_cast<double>(rays.width()), static_cast<double>(rays.height()));
    WarpMesh mesh{columns, rows, {}};
    std::vector<V2d> places;
    for (std::size_t i = 0; i < columns * rows; ++i) {
        const V2d part(static_cast<double>(i % columns) / static_cast<double>(columns - 1),
                       static_cast<double>(i / columns) / static_cast<double>(rows - 1));
        places.emplace_back(part.x * size.x, (1.0 - part.y) * size.y);
        mesh.nodes.push_back({V2d((2.0 * part.x - 1.0) * size.x / size.y, 2.0 * part.y - 1.0), {}});
    }
    std::vector<SourcePlace> shown;
    picture.at(places, shown);
    std::vector<double> shares;
    blend.at(projector, places, shares);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (shown[i].valid) {
            mesh.nodes[i].texture = shown[i].st;
            mesh.nodes[i].intensity = gamma ? std::pow(shares[i], 1.0 / *gamma) : 1.0;
        }
    }
    return mesh;
}

std::string to_text(const WarpMesh& mesh) {
    std::string text = fmt::format("2\n{} {}\n", mesh.columns, mesh.rows);
    for (const WarpMesh::Node& node : mesh.nodes) {
        text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", node.position.x,
                            node.position.y, node.texture.x, node.texture.y, node.intensity);
    }
    return text;
}

}  // namespace balcony::bridge
