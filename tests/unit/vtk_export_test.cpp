#include "lissom/view/vtk_export.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>

#include "lissom/view/vtk_writer.h"
#include "tests/unit/view_samples.h"

namespace lissom {
namespace {

/// Reads what the exporters wrote with other people's code and compares bit by bit. Arguments: file, expected arrays as
/// lines "where name values..." with hexadecimal numbers ('_' stands for a blank in names).
constexpr const char* kReader = R"(
import base64, struct, sys
import xml.etree.ElementTree as xml
path, expected = sys.argv[1:]
found = {}
if path.endswith('.vtu'):
    import meshio
    mesh = meshio.read(path)
    found['points coordinates'] = mesh.points.ravel()
    assert [c.type for c in mesh.cells] in (['line'], ['line', 'triangle'], ['triangle']), mesh.cells
    found['cells connectivity'] = [i for c in mesh.cells for i in c.data.ravel()]
    found.update({'point ' + k: v.ravel() for k, v in mesh.point_data.items()})
    found.update({'cell ' + k: [x for block in v for x in block.ravel()] for k, v in mesh.cell_data.items()})
else:
    root = xml.parse(path).getroot()
    assert root.get('type') == 'PolyData' and root.get('header_type') == 'UInt64'
    piece = root.find('PolyData/Piece')
    def values(array):
        raw = base64.b64decode(array.text, validate=True)
        (size,) = struct.unpack('<Q', raw[:8])
        assert size == len(raw) - 8
        kind = {'Float64': 'd', 'Int64': 'q'}[array.get('type')]
        return struct.unpack('<%d%s' % (size // 8, kind), raw[8:])
    found['points coordinates'] = values(piece.find('Points/DataArray'))
    assert len(found['points coordinates']) == 3 * int(piece.get('NumberOfPoints'))
    for array in piece.findall('Lines/DataArray'):
        found['cells ' + array.get('Name')] = values(array)
    for array in piece.findall('Polys/DataArray'):
        found['polygons ' + array.get('Name')] = values(array)
    for array in piece.findall('PointData/DataArray'):
        found['point ' + array.get('Name')] = values(array)
checked = 0
for line in open(expected):
    where, name, *numbers = line.split()
    got = found[where + ' ' + name.replace('_', ' ')]
    want = [float('nan') if n.strip('-') == 'nan' else float.fromhex(n) for n in numbers]
    assert len(got) == len(want), (name, len(got), len(want))
    for g, w in zip(got, want):
        assert struct.pack('<d', g) == struct.pack('<d', w) or (g != g and w != w), (name, g, w)
        checked += 1
print('compared', checked)
assert checked > 20
)";

class VtkFile {
 public:
  VtkFile(const std::string& name, const std::string& bytes)
      : folder_(std::filesystem::path(testing::TempDir()) / ("lissom_" + name)) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    std::ofstream(folder_ / "reader.py") << kReader;
    file_ = name;
  }
  ~VtkFile() { std::filesystem::remove_all(folder_); }

  void expect(const std::string& where, const std::string& name, const std::vector<double>& values) {
    expected_ += where + " " + name;
    char text[64];
    for (double v : values) {
      std::snprintf(text, sizeof text, " %a", v);
      expected_ += text;
    }
    expected_ += "\n";
  }

  /// What the reader printed: "compared" and a count when everything is equal.
  std::string compare() const {
    std::ofstream(folder_ / "expected.txt") << expected_;
    const auto quoted = [&](const std::string& name) { return " \"" + (folder_ / name).string() + "\""; };
    const std::string command = "/usr/bin/python3" + quoted("reader.py") + quoted(file_) + quoted("expected.txt") +
                                " >" + quoted("log") + " 2>&1";
    const int code = std::system(command.c_str());
    std::ostringstream log;
    log << std::ifstream(folder_ / "log").rdbuf();
    return code == 0 ? log.str() : "failed: " + log.str();
  }

 private:
  std::filesystem::path folder_;
  std::string file_, expected_;
};

std::vector<double> coordinates(const Drawing& drawing) {
  std::vector<double> flat;
  for (const RodStrip& rod : drawing.rods) {
    for (const Vec3& p : rod.points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  }
  return flat;
}

std::vector<double> normals(const Drawing& drawing) {
  std::vector<double> flat;
  for (const RodStrip& rod : drawing.rods) {
    for (const Vec3& p : rod.n) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  }
  return flat;
}

TEST(VtkExport, ReaderNoticesAWrongDigit) {
  const Drawing drawing = samples::beam_and_ring();
  VtkFile file("wrong.vtu", vtu_bytes(drawing).value());
  std::vector<double> values = drawing.fields[0].values;
  values[0] = std::nextafter(values[0], 1);
  file.expect("cell", "axial_force_(N)", values);
  EXPECT_NE(file.compare().find("AssertionError: ('axial_force_(N)'"), std::string::npos);
}

TEST(VtkExport, TimeIsInTheFile) {
  const std::string bytes = vtu_bytes(samples::beam_and_ring(), 0.25).value();
  EXPECT_NE(bytes.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.25<"), std::string::npos);
}

TEST(VtkExport, VtuComesBackEqual) {
  const Drawing drawing = samples::beam_and_ring();
  VtkFile file("state.vtu", vtu_bytes(drawing).value());
  file.expect("points", "coordinates", coordinates(drawing));
  file.expect("cells", "connectivity", {0, 1, 1, 2, 2, 3, 4, 5, 5, 6, 6, 7, 7, 8, 8, 4});
  file.expect("cell", "axial_force_(N)", drawing.fields[0].values);
  file.expect("point", "bending_<moment>_(N_m)", drawing.fields[1].values);
  file.expect("cell", "n", normals(drawing));
  file.expect("cell", "rod", {0, 0, 0, 1, 1, 1, 1, 1});
  EXPECT_EQ(file.compare(), "compared 92\n");
}

TEST(VtkExport, VtpComesBackEqual) {
  const Drawing drawing = samples::beam_and_ring();
  const Result<std::string> bytes = vtp_bytes(drawing);
  ASSERT_TRUE(bytes.ok()) << bytes.error().text();
  VtkFile file("state.vtp", bytes.value());
  file.expect("points", "coordinates", coordinates(drawing));
  file.expect("cells", "connectivity", {0, 1, 2, 3, 4, 5, 6, 7, 8, 4});
  file.expect("cells", "offsets", {4, 10});
  file.expect("point", "bending_<moment>_(N_m)", drawing.fields[1].values);
  file.expect("point", "axial_force_(N)", edge_values_at_points(drawing, drawing.fields[0].values));
  EXPECT_EQ(file.compare(), "compared 57\n");
}

/// Two squares of cloth on a closed rod, with a value per triangle, per point and per edge, and tensions.
Drawing sail() {
  Drawing drawing = samples::saddle(1, 5);
  drawing.membranes[0].tension = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  drawing.fields = {samples::triangle_field("tension", {1.0 / 3, std::nan("")}),
                    samples::edge_field("axial force", {1, 2, 3, 4}),
                    {.name = "displacement",
                     .unit = "m",
                     .display_unit = "mm",
                     .place = Field::Place::kNode,
                     .values = {1, 2, 3, 4, 0.1, 0.2, 0.3, 0.4}}};
  return drawing;
}

std::vector<double> all_coordinates(const Drawing& drawing) {
  std::vector<double> flat = coordinates(drawing);
  for (const Vec3& p : drawing.membranes[0].points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  return flat;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(VtkExport, VtuHasMembranesAfterTheRods) {
  const Drawing drawing = sail();
  VtkFile file("sail.vtu", vtu_bytes(drawing).value());
  file.expect("points", "coordinates", all_coordinates(drawing));
  file.expect("cells", "connectivity", {0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 7, 4, 7, 6});
  file.expect("cell", "tension_(N/m)", {kNone, kNone, kNone, kNone, 1.0 / 3, kNone});
  file.expect("cell", "axial_force_(N)", {1, 2, 3, 4, kNone, kNone});
  file.expect("cell", "rod", {0, 0, 0, 0, -1, -1});
  file.expect("cell", "membrane", {-1, -1, -1, -1, 0, 0});
  file.expect("cell", "largest_tension_vector_(N/m)", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6});
  file.expect("point", "displacement_(m)", drawing.fields[2].values);
  EXPECT_EQ(file.compare(), "compared 88\n");
}

TEST(VtkExport, VtpHasMembranesAsPolygons) {
  const Drawing drawing = sail();
  VtkFile file("sail.vtp", vtp_bytes(drawing).value());
  file.expect("points", "coordinates", all_coordinates(drawing));
  file.expect("cells", "connectivity", {0, 1, 2, 3, 0});
  file.expect("polygons", "connectivity", {4, 5, 7, 4, 7, 6});
  file.expect("polygons", "offsets", {3, 6});
  file.expect("point", "tension_(N/m)", {kNone, kNone, kNone, kNone, 1.0 / 3, 1.0 / 3, kNone, 1.0 / 3});
  file.expect("point", "membrane", {-1, -1, -1, -1, 0, 0, 0, 0});
  file.expect("point", "displacement_(m)", drawing.fields[2].values);
  EXPECT_EQ(file.compare(), "compared 61\n");
}

TEST(VtkExport, EdgeMeansSkipMissingValues) {
  const std::vector<double> means =
      edge_values_at_points(samples::beam_and_ring(), std::vector<double>{1, 3, std::nan(""), 10, 20, 30, 40, 50});
  ASSERT_EQ(means.size(), 9u);
  EXPECT_EQ(means[0], 1);
  EXPECT_EQ(means[1], 2);
  EXPECT_EQ(means[2], 3);
  EXPECT_TRUE(std::isnan(means[3]));
  EXPECT_EQ(means[4], 30);  // ring: last and first edge
  EXPECT_EQ(means[8], 45);
}

TEST(VtkExport, Base64) {
  const auto encode = [](const std::string& s) {
    return base64({reinterpret_cast<const uint8_t*>(s.data()), s.size()});
  };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode("\xff\xfe\xfd"), "//79");
}

TEST(VtkExport, CollectionListsStatesInOrder) {
  const std::vector<SeriesEntry> entries = {{0, "a&b_0.vtu"}, {0.1, "a&b_1.vtu"}};
  const std::string text = pvd_bytes(entries).value();
  const size_t first = text.find("<DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"a&amp;b_0.vtu\"/>");
  const size_t second = text.find("<DataSet timestep=\"0.1\" group=\"\" part=\"0\" file=\"a&amp;b_1.vtu\"/>");
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
  EXPECT_FALSE(pvd_bytes(std::vector<SeriesEntry>{{std::nan(""), "x.vtu"}}).ok());
}

TEST(VtkExport, BadShapesNameTheRod) {
  Drawing drawing = samples::beam_and_ring();
  drawing.rods[0].points[1].x() = INFINITY;
  EXPECT_EQ(vtu_bytes(drawing).error().where, "rod \"beam\"");
  EXPECT_EQ(vtp_bytes(drawing).error().where, "rod \"beam\"");
  drawing = samples::beam_and_ring();
  drawing.fields[1].values.pop_back();
  EXPECT_EQ(vtu_bytes(drawing).error().where, "field \"bending <moment>\"");
  EXPECT_EQ(vtp_bytes({}).error().code, ErrorCode::kGeometry);
}

}  // namespace
}  // namespace lissom
