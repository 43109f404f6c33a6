"""Which program of checks is for which files."""
import dataclasses
import pathlib
import re


@dataclasses.dataclass(frozen=True)
class Group:
    program: str            # in tests/mutation
    files: tuple            # those judged
    sources: tuple = ()     # compiled beside the program
    embedded: tuple = ()    # (symbol, file): texts that the build compiles in (embed_text of CMakeLists.txt)
    arguments: tuple = ()   # files given to the program
    libraries: tuple = ()
    # Where nothing throws, a call has no second way out that would count as a branch.
    coverage_flags: tuple = ('-fno-exceptions',)
    slow: bool = False  # to compile: left out of the everyday sample


FILTERED = tuple(f'exact/filtered/{name}.cpp' for name in ('filtered', 'filtered_kernel', 'crossing', 'hit_fraction',
                                                           'rounded_parameter', 'stages/integer_image'))

KERNELS = tuple(f'exact/kernels/{name}.cpp' for name in ('dyadic', 'expansion_kernel', 'expansion_range',
                                                        'extended_rational', 'product_sum'))

TREE = tuple(f'tracer/accel/{name}.cpp' for name in ('boxed_faces', 'triangle_queries', 'triangle_tree', 'wide/bins',
                                                     'wide/build', 'wide/probe', 'wide/tree'))

TRUTHS = ('exact/classes/class_table.cpp',) + tuple(f'exact/trial/{name}.cpp' for name in ('formulations', 'quick_truth',
                                                                                         'truth'))

CLASSES = (('embedded_classes163', 'data/classes163.tsv'), ('embedded_ray_classes', 'data/ray_classes.tsv'))

GROUPS = (
    Group('kill.cpp', ('core/sign.h', 'core/vec3.h', 'core/signed_volume.h', 'core/kernel.h', 'core/coplanar.h',
                       'core/segura_feito.h', 'core/operands.h', 'exact/classes/chirotope.h', 'exact/oracles/caratheodory.h'),
          arguments=('data/classes163.tsv', 'data/ray_classes.tsv')),
    Group('kill_polygons.cpp', ('core/covering.h', 'core/segura_feito_polygon.h', 'core/polygon.h', 'core/longest_axis.h',
                                'core/products.h', 'exact/oracles/point_in_rings.h', 'exact/oracles/polygon_oracles.h')),
    Group('kill_filters.cpp', ('exact/filtered/filter_bounds.h', 'exact/filtered/filter.h',
                               'exact/filtered/term_filter.h', 'exact/filtered/within_filter.h',
                               'exact/filtered/shared_volumes.h', 'exact/filtered/twin.h', 'exact/filtered/filtered.h')),
    Group('kill_verdicts.cpp', ('core/due.h', 'core/contract.h', 'exact/trial/judge.h', 'exact/trial/judge.cpp',
                                'exact/trial/outcome.h', 'exact/trial/outcome.cpp', 'exact/trial/count.h',
                                'exact/trial/count.cpp'),
          sources=('tests/mutation/kill_counts.cpp', 'exact/trial/judge.cpp', 'exact/trial/outcome.cpp',
                   'exact/trial/count.cpp', 'exact/classes/class_table.cpp'), embedded=CLASSES, coverage_flags=()),
    Group('kill_kernels.cpp', KERNELS + tuple(f'exact/kernels/{name}.h' for name in (
              'bounded_integer', 'dyadic', 'expansion', 'expansion_bound', 'expansion_kernel', 'extended_rational', 'integers',
              'lattice_kernel', 'product_sum')),
          sources=KERNELS + ('tests/mutation/kill_numbers.cpp',), libraries=('-lgmpxx', '-lgmp'), coverage_flags=(), slow=True),
    Group('kill_filtered.cpp', FILTERED + ('exact/filtered/filtered_kernel.h', 'exact/filtered/tally.h',
                                           'exact/filtered/double_double.h', 'exact/filtered/stages/exact_stages.h',
                                           'exact/filtered/stages/fixed_integer.h', 'exact/filtered/stages/grid_kernel.h',
                                           'exact/filtered/stages/integer_image.h',
                                           'exact/filtered/stages/default_rounding.h'),
          sources=FILTERED + ('exact/kernels/dyadic.cpp', 'exact/classes/class_table.cpp'),
          embedded=CLASSES,
          libraries=('-lmpfr', '-lgmpxx', '-lgmp'), coverage_flags=(), slow=True),
    Group('kill_tree.cpp', TREE + tuple(f'tracer/accel/{name}.h' for name in (
              'boxed_faces', 'certified', 'lanes_at_work', 'triangle_tree', 'wide/bins', 'wide/box', 'wide/closest',
              'wide/leaf_filter', 'wide/packet', 'wide/packet_boxes', 'wide/packet_lanes', 'wide/probe', 'wide/probe_lanes',
              'wide/queries', 'wide/stream_lanes', 'wide/traversal', 'wide/traversal_lanes', 'wide/tree',
              'wide/waiting_lanes')),
          sources=TREE + FILTERED + tuple(f'tracer/accel/wide/{name}.cpp' for name in (
              'packet', 'packet_portable', 'traversal', 'traversal_portable')) +
          ('tests/mutation/kill_boxes.cpp', 'tests/mutation/kill_packets.cpp', 'exact/filtered/filtered_polygon.cpp',
           'exact/kernels/dyadic.cpp', 'exact/classes/class_table.cpp'),
          embedded=CLASSES, libraries=('-ltbb', '-lmpfr', '-lgmpxx', '-lgmp'), coverage_flags=(), slow=True),
    Group('kill_truths.cpp', TRUTHS + ('exact/classes/class_table.h', 'exact/classes/classify.h',
                                       'exact/trial/formulations_on.h', 'exact/trial/truth.h',
                                       'exact/trial/truth_rules.h'),
          sources=TRUTHS + KERNELS + ('tests/mutation/kill_classes.cpp', 'exact/filtered/stages/integer_image.cpp'),
          embedded=CLASSES,
          libraries=('-lgmpxx', '-lgmp'), coverage_flags=(), slow=True),
)
GROUP_OF = {file: group for group in GROUPS for file in group.files}


def units_of(group, root, scratch):
    """What is compiled for the group's program, the program first: paths in the repository, or in the scratch folder."""
    units = [f'tests/mutation/{group.program}', *group.sources]
    if group.embedded:
        text = '#include "exact/base/embedded.h"\n'
        for symbol, file in group.embedded:
            text += f'const char* const tribunal::{symbol} = R"embedded({(root / file).read_text()})embedded";\n'
        generated = pathlib.Path(scratch) / 'embedded.cpp'
        generated.write_text(text)
        units.append(str(generated))
    return units


def reached_from(unit, root):
    """The files of the repository that a unit includes, itself among them."""
    seen, todo = {unit}, [unit]
    while todo:
        for name in re.findall(r'^#include "([^"]*)"', (root / todo.pop()).read_text(), re.M):
            if name not in seen and (root / name).exists():
                seen.add(name)
                todo.append(name)
    return seen
