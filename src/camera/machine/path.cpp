// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getEyePnt and getDirPnt: picture mapper, parameter transformers, object generator, object
// transformers.

#include "balcony/camera.hpp"

#include "camera/machine/ray_expressions.hpp"

namespace balcony::camera {

namespace {

ParameterPoint parameters_of(const Path& path, const PicturePoint& picture, Emitter& emit) {
    ParameterPoint p = path.mapper->map(picture, emit);
    emit.record({path.mapper.get(), {}, {p.u, p.v}});
    for (const ParameterTransformerPointer& transformer : path.parameter_transformers) {
        p = transformer->transform(p, emit);
        emit.record({transformer.get(), {}, {p.u, p.v}});
    }
    return p;
}

ObjectPoint moved(const Path& path, ObjectPoint p, Emitter& emit) {
    for (const ObjectTransformerPointer& transformer : path.object_transformers) {
        p = transformer->transform(p, emit);
    }
    return p;
}

ObjectVector differentiate(const ObjectPoint& p, Expr leaf) {
    const std::array coordinates{p.x, p.y, p.z};
    const std::vector<Expr> slopes = expr::differentiate(coordinates, leaf);
    return {slopes[0], slopes[1], slopes[2]};
}

}  // namespace

ObjectVector normal_of(const ObjectElement& e) {
    return e.own_normal ? *e.own_normal
                        : cross(differentiate(e.point, e.parameters.u),
                                differentiate(e.point, e.parameters.v));
}

// Cross products of tangents are transformed by the cofactors of the Jacobian:
// n' = (Jy x Jz, Jz x Jx, Jx x Jy) n, with Jx the derivative by x.
ObjectElement ObjectTransformer::transform_element(const ObjectElement& e, Emitter& emit) const {
    const ObjectPoint point = transform(e.point, emit);
    if (!e.own_normal) {
        return {point, std::nullopt, e.parameters};
    }
    Graph& graph = emit.graph();
    const std::array free{graph.fresh_variable(), graph.fresh_variable(), graph.fresh_variable()};
    Emitter unused(graph);
    const ObjectPoint p = transform({free[0], free[1], free[2]}, unused);
    const ObjectVector by_x = differentiate(p, free[0]);
    const ObjectVector by_y = differentiate(p, free[1]);
    const ObjectVector by_z = differentiate(p, free[2]);
    const ObjectVector& n = *e.own_normal;
    const ObjectVector turned =
        n.x * cross(by_y, by_z) + n.y * cross(by_z, by_x) + n.z * cross(by_x, by_y);
    const std::array made{turned.x, turned.y, turned.z};
    const std::array put{expr::Substitution{free[0], e.point.x},
                         expr::Substitution{free[1], e.point.y},
                         expr::Substitution{free[2], e.point.z}};
    const std::vector<Expr> there = expr::substitute(graph, made, put);
    return {point, ObjectVector{there[0], there[1], there[2]}, e.parameters};
}

// The object is first emitted with free parameters (u, v), so that its tangents are derivatives
// with respect to its own parameters, independent of the mapper and the parameter transformers;
// then these are substituted.
PathPoint Path::emit(const PicturePoint& picture, Emitter& emit,
                     bool with_second_derivative) const {
    Graph& graph = emit.graph();
    const Expr u = graph.fresh_variable();
    const Expr v = graph.fresh_variable();
    Emitter object_emit(graph);
    object_emit.set_picture_size(picture.size);
    ObjectElement element{
        generator->generate({u, v}, object_emit), generator->normal({u, v}, object_emit), {u, v}};
    const bool has_own_normal = element.own_normal.has_value();
    const auto record = [&](const Stage& stage) {
        object_emit.record({&stage, {}, {element.point.x, element.point.y, element.point.z}});
    };
    record(*generator);
    for (const ObjectTransformerPointer& transformer : object_transformers) {
        element = transformer->transform_element(element, object_emit);
        record(*transformer);
    }
    const ObjectPoint& p = element.point;
    const ObjectVector along_u = differentiate(p, u);
    const ObjectVector along_v = differentiate(p, v);
    const ObjectVector normal = normal_of(element);
    const Expr orientation =
        has_own_normal ? object_emit(1.0) : generator->orientation({u, v}, object_emit);

    const ParameterPoint parameters = parameters_of(*this, picture, emit);
    const std::array free{expr::Substitution{u, parameters.u}, expr::Substitution{v, parameters.v}};
    std::vector<Expr> made{p.x,       p.y,       p.z,         along_u.x,          along_u.y,
                           along_u.z, along_v.x, along_v.y,   along_v.z,          normal.x,
                           normal.y,  normal.z,  orientation, object_emit.valid()};
    if (with_second_derivative) {
        const ObjectVector second = differentiate({along_u.x, along_u.y, along_u.z}, u);
        made.insert(made.end(), {second.x, second.y, second.z});
    }
    const std::vector<Expr> put = expr::substitute(graph, made, free);
    emit.require(put[13]);
    for (const Emitter::Need& need : object_emit.needs()) {
        const std::array condition{need.condition};
        emit.require_somewhere(expr::substitute(graph, condition, free)[0], need.otherwise);
    }
    for (StageValues& stage : substitute(graph, object_emit.stages(), free)) {
        emit.record(std::move(stage));
    }

    const Expr zero = graph.constant(0.0);
    Emitter center_emit(graph);
    const ObjectPoint center = moved(*this, {zero, zero, zero}, center_emit);
    const Expr turned_over = put[12] < zero;
    const auto one_sided = [&](Expr along) { return select(turned_over, -along, along); };
    return {{put[0], put[1], put[2]},
            {put[3], put[4], put[5]},
            {put[6], put[7], put[8]},
            with_second_derivative ? std::optional(ObjectVector{put[14], put[15], put[16]})
                                   : std::nullopt,
            {put[9], put[10], put[11]},
            {one_sided(put[9]), one_sided(put[10]), one_sided(put[11])},
            center,
            center_emit.valid(),
            parameters,
            picture.size};
}

}  // namespace balcony::camera
