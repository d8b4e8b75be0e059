// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "analyse/measure/causes.hpp"
#include "analyse/measure/jacobian.hpp"
#include "analyse/measure/regions.hpp"

namespace balcony::analyse {

namespace {

// Smaller shares may occur where the picture only just grazes something.
constexpr double negligible_share = 0.001;
// Regions with fewer samples are too uncertain.
constexpr std::size_t fewest_samples = 4;

// A map with more turns is rarely intended. A field of view of 30 in radians has more.
constexpr double max_turns = 4.0;

constexpr std::array<std::string_view, 6> kind_names = {"no_ray", "fold",     "mirrored",
                                                        "seam",   "singular", "repeated"};

std::string percent(double share) {
    return share > 0.0 && share < 0.001 ? "less than 0.1 %"
                                        : fmt::format("{:.3g} %", 100.0 * share);
}

std::string in_regions(std::size_t count) {
    return count == 1 ? "in one region" : fmt::format("in {} regions", count);
}

/// Examines the evidence, one kind of finding after another.
class Finder {
public:
    explicit Finder(const Evidence& evidence)
        : evidence_(evidence), report_(evidence.report), grid_(evidence.report.grid) {
        for (const Crossing& crossing : evidence.crossings) {
            cuts_.insert(
                {crossing.sample, crossing.sample + (crossing.along_x ? 1 : grid_.columns)});
        }
    }

    std::vector<Finding> operator()() {
        find_many_turns();
        find_no_ray();
        find_orientation();
        find_seams();
        find_singular();
        find_repeated();
        std::stable_sort(found_.begin(), found_.end(),
                         [](const Finding& a, const Finding& b) { return a.defect && !b.defect; });
        return std::move(found_);
    }

private:
    [[nodiscard]] Place place(std::size_t sample) const {
        return {grid_.at(sample), evidence_.rays[sample].parameters};
    }

    [[nodiscard]] Place place(const V2d& point) const {
        return {point, evidence_.program.at(point).parameters};
    }

    [[nodiscard]] double share(std::size_t samples) const {
        return static_cast<double>(samples) / static_cast<double>(grid_.size());
    }

    [[nodiscard]] std::vector<SampleRegion> regions(const SampleTest& inside) const {
        return find_regions(grid_, inside, [this](std::size_t a, std::size_t b) {
            return !cuts_.contains({std::min(a, b), std::max(a, b)});
        });
    }

    [[nodiscard]] double share(const std::vector<SampleRegion>& regions) const {
        std::size_t samples = 0;
        for (const SampleRegion& region : regions) {
            samples += region.samples.size();
        }
        return share(samples);
    }

    Finding& add(FindingKind kind, const std::vector<SampleRegion>& regions) {
        Finding finding;
        finding.kind = kind;
        finding.count = regions.size();
        finding.share = share(regions);
        finding.place = place(regions.front().middle);
        for (const SampleRegion& region : regions) {
            finding.samples.insert(finding.samples.end(), region.samples.begin(),
                                   region.samples.end());
        }
        std::sort(finding.samples.begin(), finding.samples.end());
        return found_.emplace_back(std::move(finding));
    }

    [[nodiscard]] bool goes_round_often() const {
        return std::max(evidence_.turns.u, evidence_.turns.v) > max_turns;
    }

    void find_many_turns() {
        const auto all = regions([this](std::size_t i) { return report_.samples[i].valid; });
        if (!goes_round_often() || all.empty()) {
            return;
        }
        const auto round = [](char name, double turns) {
            return turns > max_turns ? fmt::format("{} covers {:.3g} turns", name, turns) : "";
        };
        const std::string u = round('u', evidence_.turns.u);
        const std::string v = round('v', evidence_.turns.v);
        Finding& finding = add(FindingKind::repeated, all);
        finding.message = fmt::format("{}{}{}", u, u.empty() || v.empty() ? "" : " and ", v);
        finding.remedy =
            "a number without a unit is an angle in radians; for degrees, append deg to "
            "it: a full turn is 360deg";
    }

    void find_no_ray() {
        const auto none = regions([this](std::size_t i) { return !report_.samples[i].valid; });
        if (none.empty()) {
            return;
        }
        Finding& finding = add(FindingKind::no_ray, none);
        finding.message = report_.valid_share == 0.0
                              ? "no point of the picture has a ray"
                              : fmt::format("{} of the picture has no ray, {}",
                                            percent(finding.share), in_regions(none.size()));
        finding.remedy =
            "if this is unintended, restrict map to the range in which the objects and formulas "
            "are defined";
    }

    [[nodiscard]] std::size_t count_orientation(int orientation) const {
        return static_cast<std::size_t>(
            std::count_if(report_.samples.begin(), report_.samples.end(),
                          [=](const Sample& s) { return s.orientation == orientation; }));
    }

    // Whether the orientation changes somewhere at the border of a region: at the
    // very next sample, or at the one after if the next is singular.
    [[nodiscard]] std::optional<std::size_t> turn_at(const SampleRegion& region) const {
        const int own = report_.samples[region.samples.front()].orientation;
        for (const std::size_t sample : region.samples) {
            for (const std::size_t next : neighbours(grid_, sample)) {
                if (cuts_.contains({std::min(sample, next), std::max(sample, next)})) {
                    continue;
                }
                if (report_.samples[next].orientation == -own) {
                    return next;
                }
                const std::size_t beyond = next + next - sample;
                if (report_.samples[next].singular && beyond < grid_.size() &&
                    report_.samples[beyond].orientation == -own) {
                    return beyond;
                }
            }
        }
        return std::nullopt;
    }

    void find_orientation() {
        const bool mostly_mirrored = count_orientation(-1) > count_orientation(1);
        const int minority = mostly_mirrored ? 1 : -1;
        std::vector<SampleRegion> folded;
        std::vector<SampleRegion> parts;
        std::optional<std::size_t> across;
        for (SampleRegion& region :
             regions([&](std::size_t i) { return report_.samples[i].orientation == minority; })) {
            if (region.samples.size() < fewest_samples) {
                continue;
            }
            const auto turn = turn_at(region);
            across = across ? across : turn;
            (turn ? folded : parts).push_back(std::move(region));
        }
        if (!folded.empty()) {
            Finding& finding = add(FindingKind::fold, folded);
            finding.other = place(*across);
            finding.message = fmt::format(
                "the picture folds over: {} of it, {}, is mirrored "
                "relative to its surroundings",
                percent(finding.share), in_regions(folded.size()));
            finding.remedy = "if this is unintended, " + advice_on_fold();
        }
        if (!parts.empty() && !mostly_mirrored) {
            Finding& finding = add(FindingKind::mirrored, parts);
            finding.defect = false;
            finding.message = fmt::format("{} of the picture, {}, is mirrored",
                                          percent(finding.share), in_regions(parts.size()));
            finding.remedy = "if this is unintended, exchange the ends of u or of v there";
        }
        if (mostly_mirrored) {
            add_all_mirrored();
        }
    }

    // Fits what makes the picture fold.
    [[nodiscard]] std::string advice_on_fold() const {
        switch (cause_of_fold(evidence_.camera, grid_.picture_width, grid_.picture_height,
                              evidence_.time, report_.distance, evidence_.work)) {
            case FoldCause::arrangement:
                return "make what arranges the picture there weaker or wider";
            case FoldCause::warp: return "make the warp of the parameters there weaker or wider";
            case FoldCause::move: return "make the deformation of the object there weaker or wider";
            case FoldCause::object: break;
        }
        return "look for an object or a formula that turns back along u or v there";
    }

    void add_all_mirrored() {
        Finding& finding =
            add(FindingKind::mirrored,
                regions([this](std::size_t i) { return report_.samples[i].orientation == -1; }));
        finding.defect = false;
        const bool whole = count_orientation(1) == 0;
        finding.message =
            whole ? "the picture is mirrored"
                  : fmt::format("most of the picture, {}, is mirrored", percent(finding.share));
        finding.remedy = "if this is unintended, exchange the ends of u or of v in map";
        if (report_.distance && !report_.single_viewpoint && crosses_before()) {
            finding.message +=
                fmt::format(" at a distance of {:.4g}, beyond the point where its rays cross",
                            *report_.distance);
            finding.remedy =
                "nearer things are not mirrored; --distance sets the distance of the measurement";
        }
    }

    // Whether most rays that are mirrored at the measured distance are not mirrored in front of it.
    [[nodiscard]] bool crosses_before() const {
        constexpr double right_before = 1e-3;
        std::size_t turned = 0;
        for (std::size_t i = 0; i < grid_.size(); ++i) {
            if (report_.samples[i].orientation == -1 &&
                jacobian(evidence_.rays[i], right_before * *report_.distance).minimum > 0.0) {
                ++turned;
            }
        }
        return 2 * turned > count_orientation(-1);
    }

    void find_seams() {
        constexpr std::size_t max_single = 8;
        const std::vector<Seam> seams = join_seams(grid_, evidence_.crossings);
        for (std::size_t i = 0; i < std::min(seams.size(), max_single); ++i) {
            lengthen(add_seam(seams[i]), seams[i]);
        }
        if (seams.size() > max_single) {
            Finding& finding = add_seam(seams[max_single]);
            for (std::size_t i = max_single; i < seams.size(); ++i) {
                lengthen(finding, seams[i]);
            }
            finding.message = fmt::format("rays jump along {} more lines, {:.0f} pixels in total",
                                          finding.count, finding.length);
        }
    }

    void lengthen(Finding& finding, const Seam& seam) const {
        ++finding.count;
        finding.length += seam.length;
        for (const Crossing& crossing : seam.crossings) {
            finding.samples.push_back(crossing.sample);
            finding.samples.push_back(crossing.sample + (crossing.along_x ? 1 : grid_.columns));
        }
        std::sort(finding.samples.begin(), finding.samples.end());
        finding.samples.erase(std::unique(finding.samples.begin(), finding.samples.end()),
                              finding.samples.end());
    }

    Finding& add_seam(const Seam& seam) {
        Finding finding;
        finding.kind = FindingKind::seam;
        finding.place = place(seam.crossings[seam.crossings.size() / 2].point);
        double angle = 0.0;
        double distance = 0.0;
        for (const Crossing& crossing : seam.crossings) {
            angle = std::max(angle, crossing.angle);
            distance = std::max(distance, crossing.distance);
        }
        const std::string turn =
            fmt::format("directions by up to {:.3g} deg", angle * 180.0 / std::numbers::pi);
        const std::string shift = fmt::format("origins by up to {:.3g}", distance);
        const bool both = angle > 1e-6 && distance > 1e-6 * report_.origin_extent;
        finding.message = fmt::format("rays jump along a line of {:.0f} pixels, {}{}{}",
                                      seam.length, angle > 1e-6 ? turn : "", both ? ", " : "",
                                      both || angle <= 1e-6 ? shift : "");
        finding.remedy =
            "if this is unintended, look for a discontinuity: if(), floor(), mod(), or an angle "
            "that wraps around";
        return found_.emplace_back(std::move(finding));
    }

    void find_singular() {
        const auto singular =
            regions([this](std::size_t i) { return report_.samples[i].singular; });
        if (singular.empty()) {
            return;
        }
        Finding& finding = add(FindingKind::singular, singular);
        finding.defect = finding.share > negligible_share;
        finding.message = fmt::format(
            "in {} of the picture, {}, rays do not change from pixel to pixel in some direction, "
            "or change without bound",
            percent(finding.share), in_regions(singular.size()));
        finding.remedy =
            all_in_one_plane()
                ? "all rays lie in one plane: if this is unintended, move the eye "
                  "out of the plane of the direction object, or the direction object away from the "
                  "eye"
                : "if this is unintended, look for a u or v that the objects do not use, or for "
                  "a parametrisation that is constant there";
    }

    // Whether all rays lie in one plane although they change with both picture x and picture y.
    [[nodiscard]] bool all_in_one_plane() const {
        constexpr double tolerance = 1e-9;
        const double size = 1.0 + report_.origin_extent;
        const Ray* first = nullptr;
        V3d normal(0.0);
        bool by_x = false;
        bool by_y = false;
        const auto widen = [&](const V3d& vector) {
            const V3d found = first->direction.cross(vector);
            normal = found.length2() > normal.length2() ? found : normal;
        };
        for (const Ray& ray : evidence_.rays) {
            if (!ray.valid) {
                continue;
            }
            first = first == nullptr ? &ray : first;
            widen(ray.direction);
            widen((ray.origin - first->origin) / size);
            by_x = by_x || ray.origin_by_x.length() + ray.direction_by_x.length() > tolerance;
            by_y = by_y || ray.origin_by_y.length() + ray.direction_by_y.length() > tolerance;
        }
        if (!(by_x && by_y && normal.length() > tolerance)) {
            return false;
        }
        normal.normalize();
        return std::all_of(evidence_.rays.begin(), evidence_.rays.end(), [&](const Ray& ray) {
            return !ray.valid ||
                   (std::abs(normal.dot(ray.direction)) <= tolerance &&
                    std::abs(normal.dot(ray.origin - first->origin)) <= tolerance * size);
        });
    }

    void find_repeated() {
        const auto repeated =
            regions([this](std::size_t i) { return report_.samples[i].views > 1; });
        if (repeated.empty() || goes_round_often()) {
            return;
        }
        int maximum = 0;
        for (const Sample& sample : report_.samples) {
            maximum = std::max(maximum, int{sample.views});
        }
        Finding& finding = add(FindingKind::repeated, repeated);
        finding.defect = finding.share > negligible_share;
        finding.other = place(evidence_.repeats.other[repeated.front().middle]);
        finding.message = fmt::format(
            "{} of the picture shows the same view as another part, up to "
            "{} times in total",
            percent(finding.share), maximum);
        const bool whole_turn = std::max(evidence_.turns.u, evidence_.turns.v) > 1.0;
        finding.remedy =
            whole_turn ? "if this is unintended, reduce the range of map: a full turn is "
                         "360deg"
                       : "if this is unintended, look for a stage or a formula that gives two "
                         "places the same u and v, such as repeat, mod() or abs()";
    }

    const Evidence& evidence_;
    const CameraReport& report_;
    const SampleGrid& grid_;
    std::set<std::pair<std::size_t, std::size_t>> cuts_;
    std::vector<Finding> found_;
};

}  // namespace

std::string_view name_of(FindingKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::vector<Finding> find_all(const Evidence& evidence) { return Finder(evidence)(); }

}  // namespace balcony::analyse
