// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as one Python function of PyTorch: its rays have gradients by positions and parameters.

#include "bridge/text/array_python.hpp"
#include "bridge/text/targets.hpp"
#include "bridge/text/unused_branches.hpp"

namespace balcony::bridge {

namespace {

// PyTorch takes two numbers for a tensor of the default precision, so functions of two values get
// tensors like x.
constexpr Spellings torch_spellings = spellings(
    {
        standard(Op::power, "pow"),
        pattern(Op::arctangent2, "LIB.arctan2(*_beside(x, {0}, {1}))"),
        function(Op::sign, "_sign",
                 "def _sign(a):\n    return LIB.where(a == a, LIB.sign(a), a)\n\n"),
        pattern(Op::select, "LIB.where({0}, *_beside(x, {1}, {2}))"),
    },
    array_spellings);

// Rays are computed once without gradients, which shows where there is one. Where they are wanted,
// they are computed again: an operation that may have an infinite derivative where there is no ray
// gets a harmless operand there, since 0 times infinity is not a number.
constexpr std::string_view torch_helpers = R"(
def _arrays(*given):
    """Tensors of one dtype on one device: those of tensors with dimensions, or else of others."""
    tensors = [a if torch.is_tensor(a) else torch.as_tensor(a)
               for a in given if not isinstance(a, (int, float))]
    leading = [a for a in tensors if a.dim() > 0] or tensors
    dtypes = ([a.dtype for a in leading if a.is_floating_point()]
              or [a.dtype for a in tensors if a.is_floating_point()]
              or [torch.get_default_dtype()])
    dtype = functools.reduce(torch.promote_types, dtypes)
    device = leading[0].device if leading else None
    return [torch.as_tensor(a, dtype=dtype, device=device) for a in given]


def _beside(x, *given):
    return [torch.as_tensor(a, dtype=x.dtype, device=x.device) for a in given]


def _rays(formulas, *given):
    """What formulas give, with gradients of 0 where there is no ray."""
    x, y, *more = _arrays(*given)
    x, y = torch.broadcast_tensors(x, y, *more)[:2]
    with torch.no_grad():
        made = formulas(None, x, y, *more)
    if not torch.is_grad_enabled() or not any(a.requires_grad for a in (x, y, *more)):
        return made
    valid = made[2]
    learnt = formulas(valid, x, y, *more)
    return tuple(a if a is valid else
                 torch.where(valid[(...,) + (None,) * (a.dim() - valid.dim())], b, a)
                 for a, b in zip(made, learnt))


def _used(live, a, harmless):
    """An operand, or a harmless one where there is no ray."""
    return a if live is None or a.dim() == 0 else torch.where(live, a, harmless)


def _vector(x, *at):
    return torch.stack(torch.broadcast_tensors(*_beside(x, *at), x)[:-1], -1)


)";

constexpr std::string_view torch_inverse_helpers = R"(def _doubles(*given):
    return [a.double() for a in _arrays(*given)]


def _indices(condition):
    return torch.nonzero(condition, as_tuple=True)[0]


def _count(n, like):
    return torch.arange(n, dtype=like.dtype, device=like.device)


def _order(rows):
    return torch.sort(rows, dim=1, stable=True)[1]


)";

// By the theorem of implicit functions: where the iteration arrives, one more step changes nothing,
// but has the derivatives of the position.
constexpr std::string_view torch_behind_inverse = R"(

def _with_gradients(slopes, points, found, far, *more, **parameters):
    """Positions and distances with their gradients by points and parameters."""
    points, = _arrays(points)
    if torch.is_grad_enabled():
        seen = _indices(torch.isfinite(far.reshape(-1)))
        to, at = points.double().reshape(-1, 3)[seen], found.reshape(-1, 2)[seen]
        o, d, _, by_position = slopes(at[:, 0], at[:, 1], *more, **parameters)
        z, m = _across(to, o, d)
        at = at + _step(z.detach(), m, d.detach(), by_position.detach())
        o, d, *_ = slopes(at[:, 0], at[:, 1], *more, **parameters)
        z, _ = _across(to, o, d)
        found = found.reshape(-1, 2).index_put((seen,), at).reshape(found.shape)
        far = far.reshape(-1).index_put((seen,), z).reshape(far.shape)
    return found.to(points.dtype), far.to(points.dtype)


def $_find_from(points, positions, width, height, /, *more, **parameters):
    """As _$_find_from(), with gradients by points and parameters."""
    return _with_gradients(
        $_slopes, points,
        *_$_find_from(points, positions, width, height, *more, **parameters),
        width, height, *more, **parameters)


def $_find(points, width, height, /, *more, **parameters):
    """As _$_find(), with gradients by points and parameters."""
    return _with_gradients(
        $_slopes, points, *_$_find(points, width, height, *more, **parameters),
        width, height, *more, **parameters)
)";

constexpr ArrayLibrary torch{
    .name = "torch",
    .imports = "import functools\n\nimport torch\n",
    .arrays = "tensors",
    .derivatives =
        "    All have the dtype and the device of the tensors that are given, and gradients by all "
        "of them,\n"
        "    which are 0 where there is no ray.\n",
    .spellings = torch_spellings,
    .number_of_condition = "({0}).to(x.dtype)",
    .guarded = "_used(live, {0}, {1})",
    .parameters = "live, ",
    .helpers = torch_helpers.substr(1),
    .table = "torch.tensor([{0}], dtype=torch.float64)",
    .whole = ".long()",
    .like = ".to({0})",
    .inverse_helpers = torch_inverse_helpers,
    .searching = "@torch.no_grad()\n",
    .finding = "_$",
    .behind_inverse = torch_behind_inverse};

Result<std::string> write_torch(const ExportSource& source, const ExportOptions&,
                                CameraFormulas formulas) {
    Result<CameraFormulas> guarded =
        with_guarded_branches(std::move(formulas), source.camera.name());
    if (!guarded) {
        return std::move(guarded.diagnostics);
    }
    return array_module(torch, source, std::move(*guarded));
}

}  // namespace

ExportTarget torch_target() {
    return {.name = "torch",
            .meaning = "one Python function of PyTorch, with gradients by positions and parameters",
            .ending = ".py",
            .write = write_torch,
            .opens_parameters = true,
            .has_inverse = true};
}

}  // namespace balcony::bridge
