// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Map projections against PROJ's own forward function.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <regex>
#include <set>

#include <proj.h>

#include "balcony/make_stage.hpp"
#include "support.hpp"

namespace balcony::cameras::test::maps_test {

namespace {

using camera::ObjectGenerator;
using expr::Expr;
using std::numbers::pi;

/// PROJ's forward function on the unit sphere.
class Forward {
public:
    explicit Forward(const std::string& definition)
        : context_(proj_context_create(), proj_context_destroy),
          projection_(nullptr, proj_destroy) {
        proj_log_level(context_.get(), PJ_LOG_NONE);
        projection_.reset(proj_create(context_.get(), (definition + " +R=1").c_str()));
        const std::regex fixed("\\+proj=(alsk|gs48|gs50)\\b.*");
        radius_ = std::regex_match(definition, fixed) ? 6370997.0 : 1.0;
    }
    [[nodiscard]] bool is_invertible() const {
        return projection_ != nullptr && proj_pj_info(projection_.get()).has_inverse != 0 &&
               proj_angular_input(projection_.get(), PJ_FWD) != 0 &&
               proj_angular_output(projection_.get(), PJ_FWD) == 0;
    }
    [[nodiscard]] V2d operator()(double longitude, double latitude) const {
        proj_errno_reset(projection_.get());
        const PJ_COORD at =
            proj_trans(projection_.get(), PJ_FWD, proj_coord(longitude, latitude, 0.0, 0.0));
        if (proj_errno(projection_.get()) != 0) {
            return V2d(std::numeric_limits<double>::quiet_NaN());
        }
        return V2d(at.xy.x, at.xy.y) / radius_;
    }
    /// How far rounding scatters the coordinates of a point: they bend in steps so small that a
    /// smooth function is straight there.
    [[nodiscard]] double rounding(double longitude, double latitude) const {
        double worst = 0.0;
        for (const double step : {1e-7, 3e-8}) {
            for (const auto& [east, north] : {std::pair(step, 0.0), std::pair(0.0, step)}) {
                const V2d bend = (*this)(longitude + east, latitude + north) +
                                 (*this)(longitude - east, latitude - north) -
                                 2.0 * (*this)(longitude, latitude);
                worst = std::max(worst, bend.length());
            }
        }
        return worst;
    }

private:
    std::unique_ptr<PJ_CONTEXT, PJ_CONTEXT* (*)(PJ_CONTEXT*)> context_;
    std::unique_ptr<PJ, PJ* (*)(PJ*)> projection_;
    double radius_;
};

Result<std::shared_ptr<const ObjectGenerator>> projection(const std::string& definition) {
    return camera::make_stage<ObjectGenerator>("projection",
                                               {{"definition", definition}, {"radius", 1.0}});
}

/// The points of the sphere for points of the map, with derivatives.
class Backward {
public:
    explicit Backward(const ObjectGenerator& stage) {
        camera::Emitter emit(*graph_);
        const Expr u = graph_->variable(0);
        const Expr v = graph_->variable(1);
        const camera::ObjectPoint p = stage.generate({u, v}, emit);
        roots_ = {p.x, p.y, p.z};
        for (const Expr parameter : {u, v}) {
            const std::array point{p.x, p.y, p.z};
            const auto slopes = expr::differentiate(point, parameter);
            roots_.insert(roots_.end(), slopes.begin(), slopes.end());
        }
        roots_.push_back(emit.valid());
        roots_ = expr::simplify(roots_);
    }

    struct Sample {
        V3d point, by_u, by_v;
        bool valid = false;
    };
    [[nodiscard]] Sample operator()(const V2d& at) const {
        const std::array variables{at.x, at.y};
        expr::Point point;
        point.variables = variables;
        const std::vector<double> r = expr::evaluate(roots_, point);
        return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}, r[9] != 0.0};
    }

private:
    std::shared_ptr<expr::Graph> graph_ = std::make_shared<expr::Graph>();
    std::vector<Expr> roots_;
};

double longitude(const V3d& e) { return std::atan2(e.y, e.x); }
double latitude(const V3d& e) { return std::atan2(e.z, std::hypot(e.x, e.y)); }

/// Operations of PROJ that have an inverse on a sphere, but not here; docs/maps.md says why.
const std::set<std::string> without_inverse{
    "airocean", "bipc",    "calcofi",    "cart", "geocent", "imw_p", "isea", "krovak",  "labrd",
    "lsat",     "misrsom", "mod_krovak", "nzmg", "rouss",   "sch",   "som",  "spilhaus"};
/// Maps of a part of the sphere, whose forward functions continue in folds.
const std::set<std::string> partial{"qsc",    "s2",     "alsk", "gs48",  "gs50",
                                    "mil_os", "lee_os", "ccon", "murd2", "pconic"};

/// Where PROJ's forward function of Winkel's second map gives up: 0.2 degrees around the poles.
bool is_given_up(const std::string& definition, double latitude) {
    return definition.find("wink2") != std::string::npos && std::abs(latitude) > 0.495 * pi;
}

// Definitions of every projection, by name, with parameters that it needs, and some variants.
std::vector<std::string> definitions() {
    std::vector<std::string> all;
    for (const PJ_OPERATIONS* row = proj_list_operations(); row->id != nullptr; ++row) {
        const std::string name = "+proj=" + std::string(row->id);
        if (name == "+proj=ocea") {
            all.push_back(name + " +lat_0=30 +lonc=10 +alpha=35");
            continue;
        }
        for (const char* parameters :
             {"", " +lat_1=30 +lat_2=60", " +lat_1=30", " +h=2", " +m=1 +n=1.5", " +n=0.6",
              " +lat_0=30 +lonc=10 +alpha=35", " +lat_0=20 +azi=19",
              " +o_proj=moll +o_lat_p=35 +o_lon_p=20",
              " +lat_1=10 +lon_1=-20 +lat_2=50 +lon_2=40"}) {
            if (Forward(name + parameters).is_invertible()) {
                all.push_back(name + parameters);
                break;
            }
        }
    }
    for (const char* variant : {"+proj=robin +lon_0=40",
                                "+proj=merc +lat_ts=30 +lon_0=-100",
                                "+proj=laea +lat_0=40 +lon_0=10",
                                "+proj=aeqd +lat_0=90",
                                "+proj=stere +lat_0=-90 +lat_ts=-70",
                                "+proj=ortho +lat_0=-30",
                                "+proj=gnom +lat_0=50",
                                "+proj=lcc +lat_1=-20 +lat_2=-60 +lat_0=-40 +lon_0=130",
                                "+proj=aea +lat_1=-10 +lat_2=50",
                                "+proj=bonne +lat_1=90",
                                "+proj=bonne +lat_1=-40",
                                "+proj=tpers +h=1.5 +lat_0=20 +tilt=30 +azi=40 +lon_0=5",
                                "+proj=geos +h=5.6 +sweep=x",
                                "+proj=hammer +W=0.7",
                                "+proj=lagrng +W=1.5 +lat_1=20",
                                "+proj=rhealpix +north_square=2 +south_square=1",
                                "+proj=healpix +rot_xy=30",
                                "+proj=qsc +lat_0=90",
                                "+proj=qsc +lon_0=90",
                                "+proj=s2 +lat_0=90",
                                "+proj=s2 +lat_0=-90",
                                "+proj=s2 +lon_0=90",
                                "+proj=s2 +lon_0=180",
                                "+proj=s2 +lon_0=-90",
                                "+proj=s2 +UVtoST=linear",
                                "+proj=s2 +UVtoST=tangent",
                                "+proj=peirce_q +shape=square",
                                "+proj=wintri +lat_1=40",
                                "+proj=wink2 +lat_1=50",
                                "+proj=loxim +lat_1=40",
                                "+proj=poly +lat_0=30",
                                "+proj=tmerc +lat_0=20 +k_0=0.9",
                                "+proj=cass +lat_0=-30",
                                "+proj=somerc +lat_0=47",
                                "+proj=ocea +lat_1=20 +lon_1=0 +lat_2=40 +lon_2=60",
                                "+proj=omerc +lat_0=40 +lonc=-10 +alpha=60 +no_off",
                                "+proj=ccon +lat_1=50",
                                "+proj=ob_tran +o_proj=robin +o_lat_p=60 +o_lon_p=-20 +lon_0=15",
                                "+proj=oea +m=1 +n=2 +theta=30",
                                "+proj=leac +lat_1=20 +south",
                                "+proj=nsper +h=0.2 +lat_0=60"}) {
        all.emplace_back(variant);
    }
    return all;
}

std::string name_of(const std::string& definition) {
    return definition.substr(6, definition.find(' ') - 6);
}

class EveryProjection : public testing::TestWithParam<std::string> {};

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    return name_of(info.param) + "_" + std::to_string(info.index);
}

}  // namespace

// From points of the map to the sphere and back with PROJ. Where PROJ's own coordinates scatter, so
// may the difference: an angle that scatters moves both.
TEST_P(EveryProjection, IsInvertedWithinABillionthOfTheRadius) {
    const Forward forward(GetParam());
    const auto stage = projection(GetParam());
    if (without_inverse.contains(name_of(GetParam()))) {
        EXPECT_FALSE(stage);
        return;
    }
    ASSERT_TRUE(stage) << to_text(stage.diagnostics);
    const Backward backward(**stage);
    const camera::ParameterRectangle shown = *(*stage)->own_picture();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    int valid = 0;
    constexpr int points = 1500;
    for (int i = 0; i < points; ++i) {
        const V2d at(std::lerp(shown.u_first, shown.u_last, any(random)),
                     std::lerp(shown.v_first, shown.v_last, any(random)));
        const Backward::Sample found = backward(at);
        if (!found.valid || is_given_up(GetParam(), latitude(found.point))) {
            continue;
        }
        ++valid;
        const double lambda = longitude(found.point);
        const double phi = latitude(found.point);
        const double error = (forward(lambda, phi) - at).length();
        if (!(error <= 1e-9)) {
            constexpr double scatter = 4.0;  // of a few samples, for the largest of a thousand
            EXPECT_LE(error, 1e-9 + scatter * forward.rounding(lambda, phi))
                << at << " at " << lambda / degree << ' ' << phi / degree;
        }
    }
    EXPECT_GE(valid, points / 5);
}

// Every direction that PROJ puts into the rectangle is on the map.
TEST_P(EveryProjection, LeavesNothingOut) {
    const auto stage = projection(GetParam());
    if (!stage || partial.contains(name_of(GetParam()))) {
        return;
    }
    const Forward forward(GetParam());
    const Backward backward(**stage);
    const camera::ParameterRectangle shown = *(*stage)->own_picture();
    for (double lambda = -177.3; lambda < 180.0; lambda += 9.0) {
        for (double phi = -87.0; phi < 90.0; phi += 9.3) {
            const V2d at = forward(lambda * degree, phi * degree);
            const bool is_shown = shown.u_last <= at.x && at.x <= shown.u_first &&
                                  shown.v_first <= at.y && at.y <= shown.v_last;
            if (is_shown) {
                EXPECT_TRUE(backward(at).valid) << lambda << ' ' << phi << " at " << at;
            }
        }
    }
}

TEST_P(EveryProjection, HasExactDerivatives) {
    const auto stage = projection(GetParam());
    if (!stage) {
        return;
    }
    const Backward backward(**stage);
    const camera::ParameterRectangle shown = *(*stage)->own_picture();
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> any(0.15, 0.85);
    constexpr double step = 1e-5;
    int compared = 0;
    int off = 0;
    for (int i = 0; i < 100; ++i) {
        const V2d at(std::lerp(shown.u_first, shown.u_last, any(random)),
                     std::lerp(shown.v_first, shown.v_last, any(random)));
        const Backward::Sample here = backward(at);
        const Backward::Sample right = backward(at + V2d(step, 0.0));
        const Backward::Sample left = backward(at - V2d(step, 0.0));
        const Backward::Sample above = backward(at + V2d(0.0, step));
        const Backward::Sample below = backward(at - V2d(0.0, step));
        if (!here.valid || !right.valid || !left.valid || !above.valid || !below.valid) {
            continue;
        }
        ++compared;
        const V3d by_u = (right.point - left.point) / (2.0 * step);
        const V3d by_v = (above.point - below.point) / (2.0 * step);
        constexpr double allowed = 1e-5;  // rounding, and third derivatives times step squared
        off += (by_u - here.by_u).length() > allowed * (1.0 + by_u.length()) ||
                       (by_v - here.by_v).length() > allowed * (1.0 + by_v.length())
                   ? 1
                   : 0;
    }
    EXPECT_GE(compared, 15);
    // A step across a crease, such as between the triangles of a face, is no derivative.
    EXPECT_LE(off, 1);
}

INSTANTIATE_TEST_SUITE_P(Proj, EveryProjection, testing::ValuesIn(definitions()), test_name);

namespace {

/// A built-in camera of the family of maps, and its projection in PROJ's words.
std::string definition_of(const std::string& name) {
    const Result<std::vector<lang::Description>> described = lang::Workspace().describe(name);
    EXPECT_TRUE(described);
    std::map<std::string, std::string> defaults;
    for (const auto& parameter : described->front().parameters) {
        defaults[parameter.name] =
            std::regex_replace(parameter.default_text, std::regex("deg"), "");
    }
    std::ifstream stream(BALCONY_SOURCE_DIR "/cameras/maps/" + name + ".cam");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::smatch call;
    EXPECT_TRUE(std::regex_search(text, call, std::regex("projection\\(\"([^\"]*)\"([^)]*)\\)")));
    std::string definition = call[1];
    if (definition.find('=') == std::string::npos) {
        definition = "+proj=" + definition;
    }
    const std::string given = call[2];
    const std::regex argument("(\\w+) = (\\w+)");
    for (std::sregex_iterator i(given.begin(), given.end(), argument), end; i != end; ++i) {
        definition += " +" + (*i)[1].str() + "=" + defaults[(*i)[2]];
    }
    return definition;
}

std::vector<std::string> map_cameras() {
    std::vector<std::string> names;
    for (const std::string& name : lang::built_in_cameras()) {
        if (lang::family_of(name) == "maps" && name != "planet") {
            names.push_back(name);
        }
    }
    return names;
}

class MapCamera : public testing::TestWithParam<std::string> {};

}  // namespace

// Its picture is the map as seen from inside of the sphere: a point of the picture looks at the
// direction that PROJ puts there.
TEST_P(MapCamera, IsTheMapOfProj) {
    const std::string definition = definition_of(GetParam());
    const auto stage = projection(definition);
    ASSERT_TRUE(stage) << definition << to_text(stage.diagnostics);
    const camera::ParameterRectangle shown = *(*stage)->own_picture();
    const Forward forward(definition);
    const Rays rays(GetParam());
    int valid = 0;
    for (double x = 0.031; x < 1.0; x += 0.083) {
        for (double y = 0.047; y < 1.0; y += 0.091) {
            const Ray ray = rays.at(x, y);
            if (!ray.valid || is_given_up(definition, latitude(ray.direction))) {
                continue;
            }
            ++valid;
            const double lambda = longitude(ray.direction);
            const double phi = latitude(ray.direction);
            const V2d at(std::lerp(shown.u_first, shown.u_last, x),
                         std::lerp(shown.v_last, shown.v_first, y));
            EXPECT_LE((forward(lambda, phi) - at).length(),
                      1e-9 + 4.0 * forward.rounding(lambda, phi))
                << x << ' ' << y;
        }
    }
    EXPECT_GE(valid, 40);
}

INSTANTIATE_TEST_SUITE_P(All, MapCamera, testing::ValuesIn(map_cameras()),
                         [](const auto& name) { return name.param; });

TEST(MapCameras, AreAllThatProjCanInvert) {
    std::set<std::string> shown;
    for (const std::string& name : map_cameras()) {
        shown.insert(name_of(definition_of(name)));
    }
    for (const std::string& definition : definitions()) {
        const std::string name = name_of(definition);
        if (name != "ob_tran" && !without_inverse.contains(name)) {
            EXPECT_TRUE(shown.contains(name)) << name << " has no camera";
        }
    }
}

TEST(MapCameras, LookAlongXWithEastOnTheLeft) {
    const Rays rays("robin");
    expect_near(rays.at(0.5, 0.5).direction, V3d(1.0, 0.0, 0.0), 1e-12);
    EXPECT_GT(rays.at(0.25, 0.5).direction.y, 0.9);
    EXPECT_GT(rays.at(0.5, 0.25).direction.z, 0.5);
}

TEST(MapProjections, OfAPlanetLookInwardsWithEastOnTheRight) {
    const Rays rays("planet", {{"radius", "2"}, {"pz", "1"}});
    const Ray middle = rays.at(0.5, 0.5);
    expect_near(middle.origin, V3d(2.0, 0.0, 1.0), 1e-12);
    expect_near(middle.direction, V3d(-1.0, 0.0, 0.0), 1e-12);
    EXPECT_GT(rays.at(0.75, 0.5).origin.y, 1.8);
    EXPECT_GT(rays.at(0.5, 0.25).origin.z, 2.0);
}

TEST(MapProjections, OfBadDefinitionsAreDiagnosed) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"robim", "did you mean 'robin'?"},
        {"", "takes a name"},
        {"   ", "has no name"},
        {"+lat_1=30", "has no name"},
        {"longlat", "are not a map"},
        {"airy", "no inverse of the map projection 'airy'"},
        {"+proj=krovak", "docs/maps.md"},
        {"lcc", "PROJ rejects this definition of 'lcc'"},
        {"+proj=lcc +lat_1=abc", "'lat_1' is not a number"},
        {"+proj=pipeline +step +proj=merc", "several steps"},
        {"unitconvert", "is a transformation"},
        {"EPSG:3857", "code of a register"},
        {"+init=epsg:4326", "code of a register"},
        {"+proj=robin +", "is not a parameter"},
        {"+proj=robin +lat_1=", "is not a number"},
        {"+proj=robin \\x01\\x02", "is not a parameter"},
        {"+proj=robin +over", "'over' is not supported"},
        {"+proj=merc +lat_ts=nan", "is not a number"},
        {"+proj=peirce_q +shape=horizontal", "no inverse"},
        {"+proj=ob_tran +o_proj=ob_tran +o_lat_p=3", "'ob_tran'"},
        {std::string(100'000, 'x'), "100000 characters"}};
    for (const auto& [definition, message] : cases) {
        const auto stage = projection(definition);
        EXPECT_FALSE(stage) << definition;
        EXPECT_NE(to_text(stage.diagnostics).find(message), std::string::npos)
            << definition.substr(0, 80) << ": " << to_text(stage.diagnostics);
    }
}

TEST(MapProjections, OfTheEarthInMetresAreThoseOfTheSphereWithAWarning) {
    const auto stage = projection("+proj=robin +ellps=WGS84 +units=m +x_0=100 +no_defs");
    ASSERT_TRUE(stage);
    const std::string said = to_text(stage.diagnostics);
    EXPECT_NE(said.find("'ellps', 'units' and 'x_0' have no effect"), std::string::npos) << said;
}

// A power series is one-to-one on the disc where the slopes of its other terms add up to less than
// that of the first. The sizes of the coefficients are those of PROJ, after Snyder (1984).
TEST(ModifiedStereographic, ShowsTheDiscOnWhichItsSeriesHasNoFolds) {
    struct Row {
        const char* name;
        std::array<double, 2> middle;
        std::vector<double> re, im;  // Of the coefficients, from that of the first power on.
    };
    const std::vector<Row> rows{{"gs50",
                                 {-pi / 1.5, pi / 4.0},
                                 {0.9842990, 0.0211642, -0.1036018, -0.0329095, 0.0499471,
                                  0.0260460, 0.0007388, 0.0075848, -0.0216473, -0.0225161},
                                 {0.0, 0.0037608, -0.0575102, -0.0320119, 0.1223335, 0.0899805,
                                  -0.1435792, -0.1334108, 0.0776645, 0.0853673}},
                                {"gs48",
                                 {-pi / 1.875, pi * 39.0 / 180.0},
                                 {0.98879, 0.0, -0.050909, 0.0, 0.075528},
                                 {0.0, 0.0, 0.0, 0.0, 0.0}}};
    for (const Row& row : rows) {
        const auto slopes = [&](double radius) {
            double sum = 0.0;
            for (std::size_t i = 1; i < row.re.size(); ++i) {
                const auto degree = static_cast<double>(i);
                sum += (degree + 1.0) * std::hypot(row.re[i], row.im[i]) * std::pow(radius, degree);
            }
            return sum;
        };
        constexpr double step = 0.001;
        double radius = 0.0;
        while (slopes(radius + step) < row.re[0]) {
            radius += step;
        }
        const auto stage = projection(std::string("+proj=") + row.name);
        ASSERT_TRUE(stage) << to_text(stage.diagnostics);
        const Backward backward(**stage);
        const camera::ParameterRectangle shown = *(*stage)->own_picture();
        const auto [east, north] = row.middle;
        const V3d middle = V3d(std::cos(east), std::sin(east), std::tan(north)).normalized();
        double farthest = 0.0;
        constexpr int side = 81;
        for (int i = 0; i < side * side; ++i) {
            const V2d at(1.0 * (i % side) / (side - 1), 1.0 * (i / side) / (side - 1));
            const Backward::Sample found = backward({std::lerp(shown.u_first, shown.u_last, at.x),
                                                     std::lerp(shown.v_first, shown.v_last, at.y)});
            if (found.valid) {
                const double angle = std::acos(std::min(1.0, found.point.dot(middle)));
                farthest = std::max(farthest, 2.0 * std::tan(0.5 * angle));
            }
        }
        EXPECT_LE(farthest, radius + step) << row.name;
        EXPECT_GE(farthest, radius - 4.0 * radius / side) << row.name;  // A cell of the grid.
    }
}

}  // namespace balcony::cameras::test::maps_test
