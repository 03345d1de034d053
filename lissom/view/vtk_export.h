#pragma once
/// Files that ParaView opens: shapes and fields of rods in SI units, one file per state, and the list of a series.
/// Data arrays are exact (binary, base64 inline). Names carry the unit: "axial force (N)".

#include <optional>
#include <span>
#include <string>

#include "lissom/core/result.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

/// Unstructured grid: one line cell per edge. Cell data: every edge field, rod number, half-extents r_n and r_b, frame
/// axes t, b, n. Point data: every node field, rod number, and `radius` (of the round section of equal area) for the
/// tube filter. Membranes follow as triangle cells on points of their own, with every triangle field; rod cells and
/// membrane cells have NaN (and rod or membrane number -1) in what belongs to the other. `time` (s) becomes the TimeValue.
Result<std::string> vtu_bytes(const Drawing& drawing, std::optional<double> time = {});

/// Poly-data: one poly-line per rod, ready for the tube filter. Point data: every node field, every edge field as the
/// mean of the edges that meet, radius, r_n, r_b, and n and b as vectors. Membranes follow as polygons, their fields as
/// means at the points too.
Result<std::string> vtp_bytes(const Drawing& drawing, std::optional<double> time = {});

/// One state of a series.
struct SeriesEntry {
  double time = 0;   ///< s, or the load factor
  std::string file;  ///< relative to the collection
};

/// ParaView collection of files over time.
Result<std::string> pvd_bytes(std::span<const SeriesEntry> entries);

}  // namespace lissom
