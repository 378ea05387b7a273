/// What --help says of order, truth and judge besides the options.
#pragma once

namespace crawford::help {

inline constexpr auto order =
    "Read orders and uncertainties from anyone's table; exit 1 if one falls short";

inline constexpr auto order_examples = R"(
The table is CSV with a header row. First column: h, "h [mm]" or cells; rows in any order, any
refinement ratios. Every other column is a quantity: a name that begins with "error" falls to
zero, any other is a value whose limit is not known. docs/order.md is a tour.

With --expect every column must show the order: one grid with NaN, equal errors, round-off, two
grids only, errors that rise in between or an order that is too high fail, too.

Values get the limit, h -> 0, and its uncertainty by four procedures: celik-2008, roache,
xing-stern-2010, eca-hoekstra-2014 (docs/order.md). They take --expect for the formal order, else 2.

Examples:
  crawford order table.csv
  crawford order table.csv --expect 2 --within 0.1 --junit orders.xml
  crawford order drag.csv --dimension 3 --quantity drag --json -)";

inline constexpr auto truth = "Exact solutions at any points, as CSV";

inline constexpr auto truth_examples = R"(
Every exact solution that the solver is held against, manufactured ones with their sources. Points
are a table "x [m],y [m]" in any unit of length; values of --set carry their units. What comes out
is SI, a column a field, with its unit in the first row. docs/truths.md has them all.

Examples:
  crawford truth --list
  crawford truth slab --help
  crawford truth slab --set material=binder --set depth="300 um" --points points.csv
  crawford truth manufactured-heat --time "1 ms" --points points.csv)";

inline constexpr auto judge =
    "Hold another code's fields against an exact solution; exit 1 if a gate falls short";

inline constexpr auto judge_examples = R"(
CASE is sandwich-mechanical, sandwich-thermal, slab, or any exact solution of crawford truth --list;
--describe says what to solve, with all properties. Each file is CSV, points or cells anywhere in
the domain: "x [m],y [m]" and fields, "temperature [K]" or what --field maps; a column weight or area
weighs the points (else all count alike). Or it is VTU or VTKHDF, whose fields at points and
at cells are both read: see crawford points. h = 1/GRID. Errors in L1, L2 and Linf, orders, and the
verdict by the rules that our own studies are held to. docs/judge.md is a tour.

Examples:
  crawford judge slab --describe
  crawford judge slab 32=T32.csv 64=T64.csv 128=T128.csv
  crawford judge slab 32=T32.csv 64=T64.csv 128=T128.csv --field T=temp:degC --set depth="300 um"
  crawford judge manufactured-heat 16=a.csv 32=b.csv 64=c.csv --expect 2 --time "1 ms" --json -)";

inline constexpr auto points = "Fields of a VTU or VTKHDF file as CSV";

inline constexpr auto points_examples = R"(
An unstructured grid in the plane: triangles, quadrilaterals, polygons. VTU: ascii, binary or
appended, raw or in base64, packed by zlib or not. VTKHDF: one time, as crawford burn writes it.
Columns: "x [m],y [m]", each component of each field, and "area [m2]", what a point or cell stands
for. A unit is the attribute `units` (VTKHDF), or what stands in brackets after a name.

Examples:
  crawford points fields.vtu
  crawford points out/sandwich/sandwich_000010.hdf --at cells --out stress.csv)";

}  // namespace crawford::help
