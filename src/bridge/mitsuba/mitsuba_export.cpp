// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as a sensor plugin of Mitsuba 3 in Python, of calls of Dr.Jit (Mitsuba 3 documentation,
// "Custom Python plugin", mitsuba.Sensor, mitsuba.TraversalCallback; Dr.Jit documentation, "API
// reference").

#include <fmt/format.h>

#include "bridge/text/array_python.hpp"
#include "bridge/text/targets.hpp"

namespace balcony::bridge {

namespace {

// Dr.Jit leaves gradients of 0 alone where a derivative is infinite, so branches need no guards.
constexpr std::string_view mitsuba_select =
    "def _select(condition, a, b):\n"
    "    return dr.select(condition, mi.Float(a), mi.Float(b))\n\n";

constexpr Spellings mitsuba_spellings = spellings({
    function(Op::modulo, "_modulo", "def _modulo(a, b):\n    return a - b * dr.floor(a / b)\n\n"),
    function(Op::minimum, "_minimum",
             "def _minimum(a, b):\n    return dr.select(b < a, mi.Float(b), mi.Float(a))\n\n"),
    function(Op::maximum, "_maximum",
             "def _maximum(a, b):\n    return dr.select(a < b, mi.Float(b), mi.Float(a))\n\n"),
    function(Op::sign, "_sign",
             "def _sign(a):\n"
             "    return dr.select(a > 0.0, 1.0, dr.select(a < 0.0, -1.0, 0.0 * a))\n\n"),
    standard(Op::power, "power"),
    symbol(Op::logical_and, "&"),
    symbol(Op::logical_or, "|"),
    pattern(Op::logical_not, "({0} ^ True)"),
    standard(Op::is_finite, "isfinite"),
    function(Op::select, "_select", mitsuba_select),
});

// Looks into a table as expr::Table does.
constexpr std::string_view mitsuba_lookup = R"(
def _lookup(coefficients, axes, *at):
    """A piecewise polynomial over the cells of a box; axes: (first, last, cells, degree) each."""
    cell, steps = mi.UInt32(0), []
    for (first, last, cells, _), a in zip(axes, at):
        position = (a - first) * (cells / (last - first))
        number = dr.select(position > 0.0, dr.minimum(dr.floor(position), cells - 1.0), 0.0)
        cell = cell * cells + mi.UInt32(number)
        steps.append(position - number)
    sizes = [degree + 1 for *_, degree in axes]
    count = math.prod(sizes)
    values = [dr.gather(mi.Float, coefficients, cell * count + i) for i in range(count)]
    for step, size in zip(reversed(steps), reversed(sizes)):
        rows = [values[i:i + size] for i in range(0, len(values), size)]
        values = [functools.reduce(lambda value, c: value * step + c, reversed(row))
                  for row in rows]
    return values[0]


)";

// CLASS is the name of the class, NAME the camera's, and the other words in capitals stand for what
// follows from its parameters.
constexpr std::string_view mitsuba_sensor = R"(
class CLASS(mi.Sensor):
    """The camera as a sensor: it looks along z of its own space, with y up and x to the left.

    t of the camera is the time of a ray. Where there is no ray, the weight is 0.
    """

    def __init__(self, props):
        mi.Sensor.__init__(self, props)
        if self.world_transform().has_scale():
            raise ValueError("to_world of the sensor NAME has a scale")
INITIAL
    def traverse(self, callback):
        super().traverse(callback)
        callback.put("to_world", self.m_to_world, mi.ParamFlags.NonDifferentiable)
TRAVERSED
    def sample_ray_differential(self, time, sample1, sample2, sample3, active=True):
        wavelengths, weight = self.sample_wavelengths(
            dr.zeros(mi.SurfaceInteraction3f), sample1, active)
        film = self.film()
        size, crop, offset = film.size(), film.crop_size(), film.crop_offset()
        o, d, valid, o_x, o_y, d_x, d_y = _NAME_formulas(
            sample2.x * crop[0] + offset[0], sample2.y * crop[1] + offset[1],
            mi.Float(size[0]), mi.Float(size[1]), timeARGUMENTS)
        valid &= active
        o = dr.select(valid, o, mi.Point3f(0.0, 0.0, 0.0))
        d = dr.select(valid, d, mi.Vector3f(0.0, 0.0, 1.0))
        to_world = self.world_transform()
        ray = mi.RayDifferential3f(to_world @ o, to_world @ d, time, wavelengths)
        ray.o_x = to_world @ mi.Point3f(o + dr.select(valid, o_x, 0.0))
        ray.o_y = to_world @ mi.Point3f(o + dr.select(valid, o_y, 0.0))
        ray.d_x = to_world @ dr.normalize(d + dr.select(valid, d_x, 0.0))
        ray.d_y = to_world @ dr.normalize(d + dr.select(valid, d_y, 0.0))
        ray.has_differentials = True
        return ray, dr.select(valid, weight, 0.0)

    def sample_ray(self, time, sample1, sample2, sample3, active=True):
        ray, weight = self.sample_ray_differential(time, sample1, sample2, sample3, active)
        return mi.Ray3f(ray), weight

    def bbox(self):
        return mi.ScalarBoundingBox3f()

    def to_string(self):
        return "CLASS[]"


mi.register_sensor("NAME", lambda props: CLASS(props))
)";

std::set<std::string_view> mitsuba_words() {
    std::set<std::string_view> names = python_words();
    names.insert({"mi", "dr", "math", "functools", "self", "film", "sampler", "to_world", "type",
                  "id", "shutter_open", "shutter_close", "srf", "o_x", "o_y", "d_x", "d_y"});
    return names;
}

class MitsubaExport : TextExport {
public:
    MitsubaExport(const ExportSource& source, CameraFormulas formulas)
        : TextExport(source, std::move(formulas), mitsuba_words()) {}

    std::string text() {
        const Dialect dialect{.spellings = mitsuba_spellings,
                              .number = python_number,
                              .number_of_condition = "dr.select({0}, mi.Float(1.0), mi.Float(0.0))",
                              .condition_of_number = "(({0}) != 0.0)",
                              .before_standard = "dr."};
        const Listing made =
            listing_of(formulas_, dialect, names_, "_",
                       [this](std::string_view input) { return input_name(input); });
        std::string text = commented(head(), "#") + "\n";
        text += made.tables.empty() ? "" : "import functools\nimport math\n\n";
        text += "import drjit as dr\nimport mitsuba as mi\n\n\n";
        for (const std::string& helper : made.helpers) {
            text += helper + "\n";
        }
        text += made.tables.empty() ? std::string_view() : mitsuba_lookup.substr(1);
        return text + python_tables(made, "mi.Float([{0}])") + formulas(made) + sensor();
    }

private:
    [[nodiscard]] std::vector<std::string> head() const {
        std::vector<std::string> lines = opening_lines(source_);
        lines.insert(
            lines.end(),
            {"", "A sensor of Mitsuba 3.7 or later, in its variants that compile (llvm_*, cuda_*):",
             fmt::format(
                 "mi.set_variant(...), import this module, and load a scene with {{\"type\": "
                 "\"{}\"}}.",
                 name_),
             "With to_world=mi.ScalarTransform4f().look_at([0, 0, 0], [1, 0, 0], [0, 0, 1]) the "
             "rays are those of the",
             "camera's file, with z up; with [0, 1, 0] those of a camera with y up."});
        return lines;
    }

    [[nodiscard]] std::string formulas(const Listing& listing) const {
        const auto line = [&listing](std::string_view name, std::string_view type,
                                     std::size_t first) {
            return fmt::format("    {} = mi.{}(\n        {},\n        {},\n        {})\n", name,
                               type, listing.roots[first + 1].text, listing.roots[first + 2].text,
                               listing.roots[first].text);
        };
        return fmt::format("def _{}_formulas({}):\n", name_,
                           python_inputs(formulas_.lens, parameters_)) +
               python_definitions(listing) +
               "    # x to the left, y up, z forward; Balcony's own axes are x forward, y to the "
               "left, z up.\n" +
               line("origin", "Point3f", RayRoots::origin) +
               line("direction", "Vector3f", RayRoots::direction) +
               fmt::format("    valid = (x == x) & (y == y) & ({})\n",
                           listing.roots[RayRoots::valid].text) +
               line("o_x", "Vector3f", RayRoots::origin_by_x) +
               line("o_y", "Vector3f", RayRoots::origin_by_y) +
               line("d_x", "Vector3f", RayRoots::direction_by_x) +
               line("d_y", "Vector3f", RayRoots::direction_by_y) +
               "    return origin, direction, valid, o_x, o_y, d_x, d_y\n\n\n";
    }

    [[nodiscard]] std::string sensor() const {
        std::string initial;
        std::string traversed;
        std::string own;
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            initial += fmt::format("        self._{0} = mi.Float(props.get(\"{0}\", {1}))\n",
                                   parameters_[i], python_number(source_.parameters[i].value));
            traversed += fmt::format(
                "        callback.put(\"{0}\", self._{0}, mi.ParamFlags.Differentiable)\n",
                parameters_[i]);
            own += fmt::format(", self._{}", parameters_[i]);
        }
        // Programs contain literal numbers, and would be compiled anew for every new value.
        const std::string opaque =
            own.empty() ? "" : fmt::format("        dr.make_opaque({})\n", own.substr(2));
        initial += opaque + (formulas_.lens ? "        self.m_needs_sample_3 = True\n" : "");
        if (!own.empty()) {
            traversed +=
                "\n    def parameters_changed(self, keys):\n"
                "        super().parameters_changed(keys)\n" +
                opaque;
        }
        std::string text(mitsuba_sensor.substr(1));
        text = replaced(std::move(text), "INITIAL\n", initial + "\n");
        text = replaced(std::move(text), "TRAVERSED\n", traversed + "\n");
        text = replaced(
            std::move(text), "ARGUMENTS",
            (formulas_.lens ? ", 2.0 * sample3.x - 1.0, 2.0 * sample3.y - 1.0" : "") + own);
        text = replaced(std::move(text), "CLASS", name_ + "_sensor");
        return replaced(std::move(text), "NAME", name_);
    }
};

Result<std::string> write_mitsuba(const ExportSource& source, const ExportOptions&,
                                  CameraFormulas formulas) {
    return MitsubaExport(source, std::move(formulas)).text();
}

}  // namespace

// Most of Mitsuba's variants compute in single precision, so it is judged.
ExportTarget mitsuba_target() {
    return {.name = "mitsuba",
            .meaning = "a sensor plugin of Mitsuba 3 in Python, with gradients by parameters",
            .ending = ".py",
            .write = write_mitsuba,
            .always_single = true,
            .opens_parameters = true,
            .footprints = true,
            .axes = Axes::z_up,
            .only_axes = true};
}

}  // namespace balcony::bridge
