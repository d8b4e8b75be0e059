// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "support.hpp"

#include "balcony/prescription.hpp"

namespace balcony::camera {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Vector& a) { return std::sqrt(dot(a, a)); }

Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector operator*(double factor, const Vector& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

void expect_near(const Vector& found, const Vector& wanted, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(found[i], wanted[i], tolerance) << "coordinate " << i;
    }
}

Arguments::Value numbers(std::vector<double> values) {
    return std::vector<Scalar>(values.begin(), values.end());
}

namespace {

// As many as there must be, on a grid in their first two coordinates, the others small and varied.
PointList some_points(const PointsParameter& type) {
    PointList points{type.coordinates.front(), {}};
    for (std::size_t i = 0; i < type.min_points; ++i) {
        for (std::size_t k = 0; k < points.coordinates; ++k) {
            const double place = k == 0   ? static_cast<double>(i % 4) - 1.5
                                 : k == 1 ? static_cast<double>(i / 4) - 1.5
                                          : 0.0;
            points.values.push_back(place + 0.1 * std::sin(static_cast<double>(7 * i + 3 * k)));
        }
    }
    return points;
}

// A stage of a kind that changes nothing much.
Arguments::StagePointer some_stage(StageKind kind) {
    switch (kind) {
        case StageKind::picture_arranger: return *try_stage(kind, "place", {});
        case StageKind::picture_mapper: return *try_stage(kind, "range", {});
        case StageKind::parameter_transformer:
        case StageKind::object_transformer: return *try_stage(kind, "scale", {});
        case StageKind::object_generator: return object("sphere");
        case StageKind::direction_rule: return *try_stage(kind, "normal", {});
        case StageKind::stereo_view: return *try_stage(kind, "stereo", {});
        case StageKind::lens: return *try_stage(kind, "lens", {});
        case StageKind::focus: return *try_stage(kind, "distance", {});
        case StageKind::bend: return *try_stage(kind, "pinholes", {});
        case StageKind::clip_shape: return *try_stage(kind, "ellipse", {});
    }
    return nullptr;
}

std::shared_ptr<const GreyImage> some_image() {
    return std::make_shared<const GreyImage>(
        GreyImage{4, 2, {0.0F, 0.25F, 0.5F, 1.0F, 1.0F, 0.75F, 0.5F, 0.0F}});
}

// Two triangles over the unit square of texture coordinates, bent along its diagonal.
std::shared_ptr<const TexturedMesh> some_mesh() {
    const TexturedMesh::Corner a{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.0}};
    const TexturedMesh::Corner b{{2.0, 0.0, 0.0}, {0.0, 0.6, 0.8}, {1.0, 0.0}};
    const TexturedMesh::Corner c{{2.0, 2.0, 1.0}, {0.0, 0.0, 1.0}, {1.0, 1.0}};
    const TexturedMesh::Corner d{{0.0, 2.0, 0.0}, {0.6, 0.0, 0.8}, {0.0, 1.0}};
    return std::make_shared<const TexturedMesh>(TexturedMesh{{{a, b, c}, {a, c, d}}});
}

// A camera of both kinds of files.
std::shared_ptr<const CalibrationFile> some_calibration() {
    return std::make_shared<const CalibrationFile>(CalibrationFile{
        "some.yml",
        {{.numbers =
              {{"width", 400.0}, {"height", 300.0}, {"fx", 350.0}, {"cx", 195.0}, {"cy", 148.0}},
          .distortion = {-0.1, 0.02, 0.001, 0.002},
          .origin = "pixel_center",
          .pose = CameraPose{{{{0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}}}, {}}}}});
}

// A biconvex lens behind its stop.
std::shared_ptr<const Prescription> some_lens() {
    const Medium glass{"glass", Medium::Dispersion::none, {1.5}};
    return std::make_shared<const Prescription>(
        Prescription{"some.dat",
                     {{.radius = 3.0, .stop = true, .gap = 1.0},
                      {.curvature = 0.02, .radius = 10.0, .gap = 4.0, .behind = glass},
                      {.curvature = -0.02, .radius = 10.0}}});
}

// Curved in every parameter, and of full rank.
Formula some_formula(const FormulaShape& shape) {
    return formula(shape.parameters, [&](Graph& graph, const std::vector<Expr>& p) {
        std::vector<Expr> results;
        for (std::size_t i = 0; i < shape.max_results; ++i) {
            const Expr own = i < p.size() ? p[i] : graph.constant(0.0);
            results.push_back(own + 0.1 * sin(p[0] + static_cast<double>(i)));
        }
        return results;
    });
}

// The default value of a parameter, or one that its maker takes.
// Channel k is 0.2 k + x or, for odd k, 0.2 k + y, with x and y from 0 to 1.
std::shared_ptr<const PixelMap> some_map(const MapParameter& type) {
    PixelMap map{4, 3, {}, std::vector<std::uint8_t>(12, 1)};
    for (std::size_t k = 0; k < type.channels(); ++k) {
        std::vector<double>& channel = map.channels.emplace_back();
        for (std::size_t i = 0; i < 12; ++i) {
            const double x = (static_cast<double>(i % 4) + 0.5) / 4.0;
            const double y = 1.0 - (static_cast<double>(i / 4) + 0.5) / 3.0;
            const double number = static_cast<double>(k);
            channel.push_back(0.2 * number + (k % 2 == 0 ? x : y));
        }
    }
    return std::make_shared<const PixelMap>(std::move(map));
}

struct SomeValue {
    Arguments::Value operator()(const NumberParameter& type) const {
        return numbers({type.default_value.value_or(0.7)});
    }
    Arguments::Value operator()(const CountParameter& type) const {
        return numbers({type.default_value.value_or(std::max(2.0, type.range.minimum))});
    }
    Arguments::Value operator()(const PairParameter& type) const {
        const std::array<double, 2> value = type.default_value.value_or(std::array{0.6, 0.4});
        return numbers({value[0], value[1]});
    }
    Arguments::Value operator()(const TripleParameter& type) const {
        const std::array<double, 3> value = type.default_value.value_or(
            type.names_axes ? std::array{0.0, 0.6, 0.8} : std::array{0.6, 0.4, 0.3});
        return numbers({value[0], value[1], value[2]});
    }
    Arguments::Value operator()(const ChoiceParameter& type) const {
        return std::string(type.choices.front());
    }
    Arguments::Value operator()(const PointsParameter& type) const { return some_points(type); }
    Arguments::Value operator()(const NestedStageParameter& type) const {
        Arguments::StagePointer stage =
            type.dimension == 1 ? object("circle") : some_stage(type.kind);
        return type.several ? Arguments::Value(std::vector{stage}) : Arguments::Value(stage);
    }
    Arguments::Value operator()(const FormulaParameter& type) const {
        return some_formula(type.shape);
    }
    // A projection, and as good as any as the name of an object.
    Arguments::Value operator()(const NameParameter&) const { return std::string("robin"); }
    Arguments::Value operator()(const ImageParameter&) const { return some_image(); }
    Arguments::Value operator()(const MeshParameter&) const { return some_mesh(); }
    Arguments::Value operator()(const MapParameter& type) const { return some_map(type); }
    Arguments::Value operator()(const CalibrationParameter&) const { return some_calibration(); }
    Arguments::Value operator()(const PrescriptionParameter&) const { return some_lens(); }
};

/// Calibrated cameras and maps as direction objects, whose points have tangents. OCamCalib's
/// first coefficient is negative.
std::optional<Arguments::Value> value_of_direction_object(const StageEntry& row,
                                                          std::string_view name) {
    const std::map<std::string_view, std::vector<double>> values{
        {"width", {400.0}}, {"height", {300.0}}, {"fx", {350.0}}, {"radius", {1.0}}};
    if (row.section == "Map projections" && name == "radius") {
        return numbers({1.0});
    }
    if (row.section != "Calibrated cameras") {
        return std::nullopt;
    }
    if (name == "coefficients") {
        return PointList{1, {-300.0, 0.0, 5e-4}};
    }
    const auto found = values.find(name);
    return found != values.end() ? std::optional(numbers(found->second)) : std::nullopt;
}

}  // namespace

Arguments arguments_for(const StageEntry& row, const Given& given) {
    Arguments arguments;
    for (const StageParameter& parameter : row.parameters) {
        const auto value = given.find(parameter.name);
        if (value != given.end()) {
            arguments.set(parameter.name, value->second);
        } else if (const auto fitting = value_of_direction_object(row, parameter.name)) {
            arguments.set(parameter.name, *fitting);
        } else if (!parameter.optional) {
            arguments.set(parameter.name, std::visit(SomeValue{}, parameter.type));
        }
    }
    if (row.shape) {
        arguments.set_formula(some_formula(*row.shape));
    }
    return arguments;
}

std::vector<std::string_view> choices_of(const StageParameter& parameter) {
    const auto* type = parameter.as<ChoiceParameter>();
    return type != nullptr ? type->choices : std::vector<std::string_view>();
}

Result<std::shared_ptr<const Stage>> try_stage(StageKind kind, std::string_view name,
                                               const Given& given) {
    const StageEntry* row = catalogue().find(kind, name);
    if (row == nullptr) {
        return error("no such stage");
    }
    return row->make(arguments_for(*row, given));
}

ObjectGeneratorPointer object(std::string_view name, const Given& given) {
    return stage<ObjectGenerator>(StageKind::object_generator, name, given);
}

ObjectTransformerPointer move(std::string_view name, const Given& given) {
    return stage<ObjectTransformer>(StageKind::object_transformer, name, given);
}

ParameterTransformerPointer warp(std::string_view name, const Given& given) {
    return stage<ParameterTransformer>(StageKind::parameter_transformer, name, given);
}

PictureMapperPointer range(double u_first, double u_last, double v_first, double v_last) {
    return stage<PictureMapper>(StageKind::picture_mapper, "range",
                                {{"u_first", numbers({u_first})},
                                 {"u_last", numbers({u_last})},
                                 {"v_first", numbers({v_first})},
                                 {"v_last", numbers({v_last})}});
}

DirectionRulePointer look(std::string_view name, const Given& given) {
    return stage<DirectionRule>(StageKind::direction_rule, name, given);
}

GeneratorProbe::GeneratorProbe(const ObjectGeneratorPointer& generator) {
    Emitter emit(*graph_);
    const Expr u = graph_->picture_x();
    const Expr v = graph_->picture_y();
    const ObjectPoint p = generator->generate({u, v}, emit);
    roots_ = {p.x, p.y, p.z};
    for (const Expr leaf : {u, v}) {
        const std::array coordinates{p.x, p.y, p.z};
        for (const Expr slope : expr::differentiate(coordinates, leaf)) {
            roots_.push_back(slope);
        }
    }
    roots_.push_back(emit.valid());
}

Sample GeneratorProbe::operator()(double u, double v, double time) const {
    const std::vector<double> r = expr::evaluate(roots_, {u, v, time, {}});
    return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}, r[9] != 0.0};
}

Vector transformed(const ObjectTransformerPointer& transformer, const Vector& point) {
    Graph graph;
    Emitter emit(graph);
    const ObjectPoint p =
        transformer->transform({graph.variable(0), graph.variable(1), graph.variable(2)}, emit);
    const std::vector<double> r = expr::evaluate(std::array{p.x, p.y, p.z}, {0.0, 0.0, 0.0, point});
    return {r[0], r[1], r[2]};
}

std::array<double, 2> warped(const ParameterTransformerPointer& transformer, double u, double v) {
    Graph graph;
    Emitter emit(graph);
    const ParameterPoint p = transformer->transform({graph.picture_x(), graph.picture_y()}, emit);
    const std::vector<double> r = expr::evaluate(std::array{p.u, p.v}, {u, v, 0.0, {}});
    return {r[0], r[1]};
}

CameraProbe::CameraProbe(const Camera& camera, double width, double height) {
    const RayExpressions ray = camera.emit(*graph_, width, height);
    const std::array roots{ray.origin.x,    ray.origin.y,     ray.origin.z,
                           ray.direction.x, ray.direction.y,  ray.direction.z,
                           ray.valid,       ray.parameters.u, ray.parameters.v};
    roots_ = expr::simplify(roots);
}

Ray CameraProbe::operator()(double x, double y, double time) const {
    const std::vector<double> r = expr::evaluate(roots_, {x, y, time, {}});
    return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, r[6] != 0.0, {r[7], r[8]}};
}

Camera camera(Camera::Parts parts) {
    Result<Camera> made = Camera::make(std::move(parts));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

}  // namespace balcony::camera
