// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "balcony/motion.hpp"
#include "base/precondition.hpp"
#include "scene/axes.hpp"
#include "scene/gltf/write_material.hpp"

namespace balcony::scene {

namespace {

using nlohmann::json;
using scene::Light;
using scene::LightKind;
using scene::M44d;
using scene::Material;
using scene::Mesh;
using scene::V2f;
using scene::V3d;
using scene::V3f;
using scene::V4f;

// Numbers of the glTF 2.0 specification.
constexpr int component_float = 5126;
constexpr int component_unsigned_int = 5125;
constexpr int target_array_buffer = 34962;
constexpr int target_element_array_buffer = 34963;
constexpr std::uint32_t glb_magic = 0x46546c67U;
constexpr std::uint32_t glb_version = 2;
constexpr std::uint32_t chunk_json = 0x4e4f534aU;
constexpr std::uint32_t chunk_binary = 0x004e4942U;

constexpr int opengl_nearest = 9728;

constexpr int wrap_mode(scene::Wrap wrap) {
    return wrap == scene::Wrap::repeat ? 10497 : wrap == scene::Wrap::clamp ? 33071 : 33648;
}

// glTF knows two formats: JPEG, which starts with 0xff, and PNG.
const char* mime_type(const std::vector<std::uint8_t>& bytes) {
    constexpr std::uint8_t jpeg_marker = 0xff;
    return bytes.front() == jpeg_marker ? "image/jpeg" : "image/png";
}

json array_of(const V3d& v) { return json::array({v.x, v.y, v.z}); }

class Writer {
public:
    explicit Writer(const scene::Scene& scene)
        : scene_(scene), turned_(turning(scene.axes, Axes::y_up)) {
        document_["asset"] = {{"version", "2.0"}, {"generator", "Balcony"}};
        document_["scene"] = 0;
    }

    std::vector<std::uint8_t> write() {
        add_textures();
        for (const Material& material : scene_.materials) {
            append("materials", gltf_material(material, extensions_));
        }
        for (const Mesh& mesh : scene_.meshes) {
            add_mesh(mesh);
        }
        json roots = json::array();
        for (const scene::Instance& instance : scene_.instances) {
            roots.push_back(add_instance(instance));
        }
        if (scene_.motion) {
            add_motion(*scene_.motion, roots);
        }
        for (const Light& light : scene_.lights) {
            roots.push_back(add_light(light));
        }
        if (!extensions_.empty()) {
            document_["extensionsUsed"] = extensions_;
        }
        document_["scenes"] = json::array({{{"name", scene_.name}, {"nodes", roots}}});
        return container();
    }

private:
    // Appends raw bytes at a multiple of four and returns the index of their buffer view.
    std::size_t add_view(const void* data, std::size_t size, int target) {
        binary_.resize((binary_.size() + 3) / 4 * 4);
        json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
        if (target != 0) {
            view["target"] = target;
        }
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        binary_.insert(binary_.end(), bytes, bytes + size);
        return append("bufferViews", std::move(view));
    }

    std::size_t append(const char* list, json element) {
        json& elements = document_[list];
        elements.push_back(std::move(element));
        return elements.size() - 1;
    }

    template <class Element>
    json accessor(const std::vector<Element>& elements, const char* type) {
        const std::size_t bytes = elements.size() * sizeof(Element);
        return {{"bufferView", add_view(elements.data(), bytes, target_array_buffer)},
                {"componentType", component_float},
                {"count", elements.size()},
                {"type", type}};
    }

    void add_textures() {
        for (const scene::Texture& texture : scene_.textures) {
            const std::size_t view = add_view(texture.bytes->data(), texture.bytes->size(), 0);
            const std::size_t image = append("images", {{"name", texture.name},
                                                        {"mimeType", mime_type(texture.bytes)},
                                                        {"bufferView", view}});
            json properties{{"wrapS", wrap_mode(texture.wrap_u)},
                            {"wrapT", wrap_mode(texture.wrap_v)}};
            if (!texture.interpolated) {
                properties["magFilter"] = opengl_nearest;
            }
            const std::size_t sampler = append("samplers", std::move(properties));
            append("textures", {{"source", image}, {"sampler", sampler}});
        }
    }

    std::vector<V3f> turned_directions(const std::vector<V3f>& directions) const {
        std::vector<V3f> turned(directions.size());
        for (std::size_t i = 0; i < directions.size(); ++i) {
            turned_.multDirMatrix(directions[i], turned[i]);
        }
        return turned;
    }

    std::vector<V4f> turned_tangents(const std::vector<V4f>& tangents) const {
        std::vector<V4f> turned;
        turned.reserve(tangents.size());
        for (const V4f& tangent : tangents) {
            V3f direction;
            turned_.multDirMatrix(V3f(tangent.x, tangent.y, tangent.z), direction);
            turned.emplace_back(direction.x, direction.y, direction.z, tangent.w);
        }
        return turned;
    }

    void add_mesh(const Mesh& mesh) {
        const std::vector<V3f> positions = turned_directions(mesh.positions);
        scene::Box3f box;
        for (const V3f& position : positions) {
            box.extendBy(position);
        }
        json position_accessor = accessor(positions, "VEC3");
        position_accessor["min"] = {box.min.x, box.min.y, box.min.z};
        position_accessor["max"] = {box.max.x, box.max.y, box.max.z};
        json attributes = {{"POSITION", append("accessors", std::move(position_accessor))}};
        if (!mesh.normals.empty()) {
            attributes["NORMAL"] =
                append("accessors", accessor(turned_directions(mesh.normals), "VEC3"));
        }
        if (!mesh.tangents.empty()) {
            attributes["TANGENT"] =
                append("accessors", accessor(turned_tangents(mesh.tangents), "VEC4"));
        }
        for (std::size_t set = 0; set < mesh.texture_coordinates.size(); ++set) {
            const std::vector<V2f>& coordinates = mesh.texture_coordinates[set];
            if (!coordinates.empty()) {
                attributes["TEXCOORD_" + std::to_string(set)] =
                    append("accessors", accessor(coordinates, "VEC2"));
            }
        }
        if (!mesh.colors.empty()) {
            attributes["COLOR_0"] = append("accessors", accessor(mesh.colors, "VEC4"));
        }
        const std::size_t bytes = mesh.triangles.size() * sizeof(mesh.triangles[0]);
        const std::size_t view =
            add_view(mesh.triangles.data(), bytes, target_element_array_buffer);
        const std::size_t indices = append("accessors", {{"bufferView", view},
                                                         {"componentType", component_unsigned_int},
                                                         {"count", mesh.triangles.size() * 3},
                                                         {"type", "SCALAR"}});
        const json primitive = {
            {"attributes", attributes}, {"indices", indices}, {"material", mesh.material.value()}};
        append("meshes", {{"name", mesh.name}, {"primitives", json::array({primitive})}});
    }

    // glTF stores matrices in column-major order for column vectors, which is the order in which
    // Imath stores them in row-major order for row vectors.
    std::size_t add_instance(const scene::Instance& instance) {
        const M44d placed = turned_.transposed() * instance.world_from_mesh * turned_;
        json node = {{"name", scene_.objects[instance.object].name},
                     {"mesh", instance.mesh.value()}};
        const V3d translation = placed.translation();
        if (placed != M44d().setTranslation(translation)) {
            node["matrix"] = std::vector<double>(&placed[0][0], &placed[0][0] + 16);
        } else if (translation != V3d(0.0)) {
            node["translation"] = array_of(translation);
        }
        return append("nodes", std::move(node));
    }

    [[nodiscard]] std::vector<double> matrix_of(const M44d& matrix) const {
        const M44d placed = turned_.transposed() * matrix * turned_;
        return {&placed[0][0], &placed[0][0] + 16};
    }

    // Nodes that move, each below its parent, and the instances below them. An instance's node is
    // the one with its number, since instances are written first.
    void add_motion(const Motion& motion, json& roots) {
        if (motion.instances.empty()) {
            return;
        }
        json animation = {{"channels", json::array()}, {"samplers", json::array()}};
        std::vector<std::size_t> written;
        for (const Node& node : motion.nodes) {
            written.push_back(add_moving_node(motion, node, animation));
            if (node.parent.valid()) {
                add_child(written[node.parent.value()], written.back());
            } else {
                roots.push_back(append("nodes", {{"matrix", matrix_of(node.world_from_parent)},
                                                 {"children", {written.back()}}}));
            }
        }
        for (const MovingInstance& moving : motion.instances) {
            json& node = document_["nodes"][moving.instance];
            node.erase("matrix");
            node.erase("translation");
            roots.erase(std::find(roots.begin(), roots.end(), json(moving.instance)));
            add_child(written[moving.node.value()], moving.instance);
        }
        if (!animation["channels"].empty()) {
            append("animations", std::move(animation));
        }
    }

    void add_child(std::size_t parent, std::size_t child) {
        document_["nodes"][parent]["children"].push_back(child);
    }

    std::size_t add_moving_node(const Motion& motion, const Node& node, json& animation) {
        const bool moves = node.translation_track.valid() || node.rotation_track.valid() ||
                           node.scale_track.valid();
        if (!moves) {
            return append("nodes", {{"matrix", matrix_of(node.parent_from_node)}});
        }
        V3d translation, axis;
        turned_.multDirMatrix(node.translation, translation);
        turned_.multDirMatrix(node.rotation.v, axis);
        const std::size_t index =
            append("nodes", {{"translation", array_of(translation)},
                             {"rotation", {axis.x, axis.y, axis.z, node.rotation.r}},
                             {"scale", array_of(turned_scale(node.scale))}});
        add_channel(motion, node.translation_track, index, "translation", animation);
        add_channel(motion, node.rotation_track, index, "rotation", animation);
        add_channel(motion, node.scale_track, index, "scale", animation);
        return index;
    }

    // Factors along the axes change their order with them, but not their signs.
    [[nodiscard]] V3d turned_scale(const V3d& scale) const {
        V3d turned(0.0);
        for (int from = 0; from < 3; ++from) {
            for (int to = 0; to < 3; ++to) {
                turned[to] += std::abs(turned_[from][to]) * scale[from];
            }
        }
        return turned;
    }

    void add_channel(const Motion& motion, TrackIndex track_index, std::size_t node,
                     const char* path, json& animation) {
        if (!track_index.valid()) {
            return;
        }
        const Track& track = motion.tracks[track_index.value()];
        // Vectors and the vector parts of rotations turn with the axes.
        const bool is_scale = std::string_view(path) == "scale";
        std::vector<float> values = track.values;
        for (std::size_t i = 0; i + track.width <= values.size(); i += track.width) {
            const V3d own(values[i], values[i + 1], values[i + 2]);
            V3d vector;
            turned_.multDirMatrix(own, vector);
            const V3f turned(is_scale ? turned_scale(own) : vector);
            std::copy_n(&turned.x, 3, &values[i]);
        }
        const std::vector<float> times(track.times.begin(), track.times.end());
        json input = accessor(times, "SCALAR");
        input["min"] = {times.front()};
        input["max"] = {times.back()};
        json output = accessor(values, "SCALAR");
        output["count"] = values.size() / track.width;
        output["type"] = track.width == 4 ? "VEC4" : "VEC3";
        const char* interpolations[] = {"STEP", "LINEAR", "CUBICSPLINE"};
        animation["channels"].push_back({{"sampler", animation["samplers"].size()},
                                         {"target", {{"node", node}, {"path", path}}}});
        animation["samplers"].push_back(
            {{"input", append("accessors", std::move(input))},
             {"output", append("accessors", std::move(output))},
             {"interpolation", interpolations[std::size_t(track.interpolation)]}});
    }

    std::size_t add_light(const Light& light) {
        const float strength =
            std::max({light.intensity.x, light.intensity.y, light.intensity.z, 1e-30F});
        const char* kinds[] = {"point", "spot", "directional"};
        json written = {{"name", light.name},
                        {"type", kinds[static_cast<std::size_t>(light.kind)]},
                        {"intensity", strength},
                        {"color",
                         {light.intensity.x / strength, light.intensity.y / strength,
                          light.intensity.z / strength}}};
        if (light.range > 0.0F) {
            written["range"] = light.range;
        }
        if (light.kind == LightKind::spot) {
            written["spot"] = {{"innerConeAngle", light.inner_cone},
                               {"outerConeAngle", light.outer_cone}};
        }
        if (light.kind == LightKind::directional && light.angle != sun_angle) {
            written["extras"] = {{"angle", light.angle}};
        }
        json& lights = document_["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back(std::move(written));
        extensions_.insert("KHR_lights_punctual");

        V3d position;
        turned_.multDirMatrix(light.position, position);
        json node = {{"name", light.name}, {"translation", array_of(position)}};
        node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
        if (light.kind != LightKind::point) {
            node["rotation"] = rotation_towards(light.direction);
        }
        return append("nodes", std::move(node));
    }

    // The shortest rotation, as a quaternion (x, y, z, w), from -z, the direction of glTF's
    // lights, to a direction of the scene.
    json rotation_towards(const V3d& direction) const {
        V3d turned;
        turned_.multDirMatrix(direction, turned);
        const V3d towards = turned.normalized();
        const V3d axis = V3d(0.0, 0.0, -1.0).cross(towards);
        const double w = 1.0 - towards.z;
        constexpr double nearly_opposite = 1e-12;
        if (w < nearly_opposite) {
            return {1.0, 0.0, 0.0, 0.0};
        }
        const double length = std::sqrt(axis.length2() + w * w);
        return {axis.x / length, axis.y / length, axis.z / length, w / length};
    }

    static void put(std::vector<std::uint8_t>& bytes, std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) {
            bytes.push_back(static_cast<std::uint8_t>(word >> shift & 0xffU));
        }
    }

    std::vector<std::uint8_t> container() {
        binary_.resize((binary_.size() + 3) / 4 * 4);
        document_["buffers"] = json::array({{{"byteLength", binary_.size()}}});
        std::string text = document_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');

        constexpr std::size_t header_bytes = 12;
        constexpr std::size_t chunk_header_bytes = 8;
        std::vector<std::uint8_t> bytes;
        put(bytes, glb_magic);
        put(bytes, glb_version);
        put(bytes, static_cast<std::uint32_t>(header_bytes + 2 * chunk_header_bytes + text.size() +
                                              binary_.size()));
        put(bytes, static_cast<std::uint32_t>(text.size()));
        put(bytes, chunk_json);
        bytes.insert(bytes.end(), text.begin(), text.end());
        put(bytes, static_cast<std::uint32_t>(binary_.size()));
        put(bytes, chunk_binary);
        bytes.insert(bytes.end(), binary_.begin(), binary_.end());
        return bytes;
    }

    const scene::Scene& scene_;
    M44d turned_;
    json document_;
    std::set<std::string> extensions_;
    std::vector<std::uint8_t> binary_;
};

}  // namespace

std::vector<std::uint8_t> to_glb(const scene::Scene& scene) {
    precondition(check(scene).empty(), "the scene is consistent");
    precondition(std::all_of(scene.textures.begin(), scene.textures.end(),
                             [](const Texture& texture) { return !texture.bytes->empty(); }),
                 "the textures of a GLB file are embedded");
    return Writer(scene).write();
}

}  // namespace balcony::scene
