#include "io/surface_file.h"

#include "core/imaging/fill_surface.h"
#include "io/vessel_input_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace angiopose;

namespace {

using test::TemporaryFolder;

/// A box with one corner at the origin in the syntax of each format, corners numbered from 0.
constexpr std::array<std::array<int, 3>, 12> boxTriangles = {{{0, 2, 1},
                                                              {0, 3, 2},
                                                              {4, 5, 6},
                                                              {4, 6, 7},
                                                              {0, 1, 5},
                                                              {0, 5, 4},
                                                              {1, 2, 6},
                                                              {1, 6, 5},
                                                              {2, 3, 7},
                                                              {2, 7, 6},
                                                              {3, 0, 4},
                                                              {3, 4, 7}}};

std::array<Eigen::Vector3d, 8> boxCorners()
{
    return {{{0, 0, 0}, {70, 0, 0}, {70, 50, 0}, {0, 50, 0}, {0, 0, 30}, {70, 0, 30}, {70, 50, 30}, {0, 50, 30}}};
}

std::string pointLines(const std::string& prefix)
{
    std::string text;
    for (const Eigen::Vector3d& corner : boxCorners()) {
        text += prefix + std::to_string(corner.x()) + " " + std::to_string(corner.y()) + " " +
                std::to_string(corner.z()) + "\n";
    }
    return text;
}

std::string triangleLines(const std::string& prefix, int first)
{
    std::string text;
    for (const auto& triangle : boxTriangles) {
        text += prefix + std::to_string(triangle[0] + first) + " " + std::to_string(triangle[1] + first) + " " +
                std::to_string(triangle[2] + first) + "\n";
    }
    return text;
}

std::string stlText()
{
    std::string text = "solid box\n";
    for (const auto& triangle : boxTriangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : triangle) {
            const Eigen::Vector3d point = boxCorners()[static_cast<std::size_t>(corner)];
            text += "vertex " + std::to_string(point.x()) + " " + std::to_string(point.y()) + " " +
                    std::to_string(point.z()) + "\n";
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
}

std::string legacyVtk(const std::string& title)
{
    return "# vtk DataFile Version 3.0\n" + title + "\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" + pointLines("") +
           "POLYGONS 12 48\n" + triangleLines("3 ", 0);
}

std::string plyText()
{
    return "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement "
           "face "
           "12\nproperty list uchar int vertex_indices\nend_header\n" +
           pointLines("") + triangleLines("3 ", 0);
}

template <class Number>
std::string bytesOf(Number value, bool isBigEndian)
{
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (isBigEndian) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
}

std::string binaryPly(bool isBigEndian)
{
    std::string text = "ply\nformat binary_" + std::string(isBigEndian ? "big" : "little") +
                       "_endian 1.0\nelement vertex 8\nproperty double x\nproperty float32 y\nproperty float z\n"
                       "property uchar red\nelement face 12\nproperty list uint8 ushort vertex_index\nend_header\n";
    for (const Eigen::Vector3d& corner : boxCorners()) {
        text += bytesOf(corner.x(), isBigEndian) + bytesOf(static_cast<float>(corner.y()), isBigEndian) +
                bytesOf(static_cast<float>(corner.z()), isBigEndian) + '\xff';
    }
    for (const auto& triangle : boxTriangles) {
        text += '\3';
        for (const int corner : triangle) {
            text += bytesOf(static_cast<std::uint16_t>(corner), isBigEndian);
        }
    }
    return text;
}

std::string dataArray(const std::string& attributes, const std::string& numbers)
{
    return "<DataArray " + attributes + " format=\"ascii\">" + numbers + "</DataArray>";
}

/// The box as VTK XML cells: triangles as strips, or as the cells of a grid.
std::string xmlVtk(bool isGrid)
{
    std::string offsets, types;
    for (std::size_t i = 1; i <= boxTriangles.size(); ++i) {
        offsets += std::to_string(3 * i) + " ";
        types += "5 ";
    }
    const std::string kind = isGrid ? "UnstructuredGrid" : "PolyData", cells = isGrid ? "Cells" : "Strips";
    return "<VTKFile type=\"" + kind + "\" version=\"0.1\" byte_order=\"LittleEndian\"><" + kind +
           "><Piece NumberOfPoints=\"8\" NumberOf" + cells + "=\"12\"><Points>" +
           dataArray("type=\"Float64\" NumberOfComponents=\"3\"", pointLines("")) + "</Points><" + cells + ">" +
           dataArray("type=\"Int32\" Name=\"connectivity\"", triangleLines("", 0)) +
           dataArray("type=\"Int32\" Name=\"offsets\"", offsets) +
           (isGrid ? dataArray("type=\"UInt8\" Name=\"types\"", types) : "") + "</" + cells + "></Piece></" + kind +
           "></VTKFile>";
}

void expectBox(const core::Result<io::LoadedSurface>& surface)
{
    ASSERT_TRUE(surface) << surface.error().message;
    EXPECT_EQ(surface.value().mesh.pointsInPatient.size(), 8U);
    EXPECT_EQ(surface.value().mesh.triangles.size(), 12U);
    EXPECT_TRUE(surface.value().warnings.empty()) << surface.value().warnings.front();
    const auto mask = core::fillSurface(surface.value().mesh, 1.0);
    ASSERT_TRUE(mask) << mask.error().message;
    // Voxel centers lie on the walls here, so only they depend on rounding.
    EXPECT_NEAR(static_cast<double>(std::count(mask.value().voxels.begin(), mask.value().voxels.end(), 1)),
                70 * 50 * 30, 100.0);
}

}   // namespace

TEST(ReadSurface, EveryFormatGivesTheSameBox)
{
    const TemporaryFolder folder;
    expectBox(io::readSurface(folder.write("box.stl", stlText())));
    expectBox(io::readSurface(folder.write("box.OBJ", pointLines("v ") + triangleLines("f ", 1))));
    expectBox(io::readSurface(folder.write("box.ply", plyText())));
    expectBox(io::readSurface(folder.write("little.ply", binaryPly(false))));
    expectBox(io::readSurface(folder.write("big.ply", binaryPly(true))));
    expectBox(io::readSurface(folder.write("box.vtk", legacyVtk("a box"))));
    expectBox(io::readSurface(folder.write("strips.vtp", xmlVtk(false))));
    expectBox(io::readSurface(folder.write("grid.vtu", xmlVtk(true))));
    const auto box = io::readSurface(folder.file("box.ply"));
    ASSERT_TRUE(io::writeSurface(box.value().mesh, folder.file("binary.stl")));
    expectBox(io::readSurface(folder.file("binary.stl")));
}

TEST(ReadSurface, RasIsTurnedAndUnitsAreMillimeters)
{
    const TemporaryFolder folder;
    const auto surface = io::readSurface(folder.write("box.vtk", legacyVtk("vtk output SPACE=RAS")), 2.0);
    ASSERT_TRUE(surface) << surface.error().message;
    EXPECT_EQ(surface.value().mesh.pointsInPatient[2], Eigen::Vector3d(-140, -100, 0));
}

TEST(ReadSurface, HolesAndUnusualSizesAreMentioned)
{
    const TemporaryFolder folder;
    const std::string whole = triangleLines("f ", 1);
    const auto open = io::readSurface(folder.write("open.obj", pointLines("v ") + whole.substr(0, whole.size() - 8)));
    ASSERT_TRUE(open) << open.error().message;
    ASSERT_EQ(open.value().warnings.size(), 1U);
    EXPECT_NE(open.value().warnings.front().text().find("3 open"), std::string::npos);
    const auto small = io::readSurface(folder.write("small.obj", pointLines("v ") + whole), 0.1);
    ASSERT_TRUE(small);
    EXPECT_NE(small.value().warnings.front().text().find("9.1 mm across"), std::string::npos);
}

TEST(ReadSurface, DamagedFilesSayWhatIsWrong)
{
    const TemporaryFolder folder;
    const std::map<std::string, std::string> files = {
        {"a.obj", "v 1 2\nf 1 2 3\n"},
        {"b.obj", pointLines("v ") + "f 1 2 99\n"},
        {"c.stl", stlText().substr(0, 900)},
        {"d.ply", plyText().substr(0, 300)},
        {"e.vtk", legacyVtk("x").substr(0, 200)},
        {"f.obj", pointLines("v ")},
        {"g.txt", "hello"},
        {"h.obj", pointLines("v ") + "v nan 0 0\nf 1 2 9\n"},
    };
    for (const auto& [name, content] : files) {
        const auto surface = io::readSurface(folder.write(name, content));
        ASSERT_FALSE(surface) << name;
        EXPECT_TRUE(surface.error().message.text().starts_with(folder.file(name))) << surface.error().message;
        EXPECT_TRUE(surface.error().message.text().ends_with(".")) << surface.error().message;
    }
}

/// A capped tube of 60 rings of 16 points, plus one more corner shared by three triangles.
std::string tubeWithCornerAt(const std::string& corner)
{
    constexpr int rings = 60, sides = 16;
    std::string text;
    for (int ring = 0; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            text += "v " + std::to_string(4.0 * std::cos(angle)) + " " + std::to_string(4.0 * std::sin(angle)) + " " +
                    std::to_string(1.5 * ring) + "\n";
        }
    }
    const auto face = [&text](int a, int b, int c) {
        text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
    };
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const int a = ring * sides + side, b = ring * sides + (side + 1) % sides;
            face(a, b, b + sides);
            face(a, b + sides, a + sides);
        }
    }
    for (int side = 1; side + 1 < sides; ++side) {
        face(0, side + 1, side);
        face((rings - 1) * sides, (rings - 1) * sides + side, (rings - 1) * sides + side + 1);
    }
    text += "v " + corner + "\n";
    for (int side = 0; side < 3; ++side) {
        face(480 + side, 481 + side, rings * sides);
    }
    return text;
}

TEST(ReadSurface, PointsThatCannotBeOfTheBodyAreLeftOutAndItIsSaid)
{
    const TemporaryFolder folder;
    for (const char* corner : {"1000000 0 0", "0 -5000 30", "9e30 0 0"}) {
        const std::string path = folder.write("tube.obj", tubeWithCornerAt(corner));
        const auto surface = io::readSurface(path);
        ASSERT_TRUE(surface) << surface.error().message;
        EXPECT_EQ(surface.value().mesh.pointsInPatient.size(), 960U);
        EXPECT_LT(surface.value().extentMm, 100.0);
        ASSERT_FALSE(surface.value().warnings.empty());
        EXPECT_NE(surface.value().warnings.front().text().find("Outlier points (1)"), std::string::npos)
            << surface.value().warnings.front();
        core::VesselInput input;
        input.kind = core::VesselInputKind::Surface;
        const auto vessels = io::readVessels(path, input);
        ASSERT_TRUE(vessels) << vessels.error().message;
        ASSERT_EQ(vessels.value().tree.branches.size(), 1U);
        EXPECT_NEAR(vessels.value().tree.branches.front().lengthMm(), 88.0, 5.0);
    }
    const auto near = io::readSurface(folder.write("near.obj", tubeWithCornerAt("900 0 0")));
    ASSERT_TRUE(near);
    EXPECT_GT(near.value().extentMm, 800.0) << "a body may be so large";
}

TEST(ReadSurface, TracingOneEndsWhenStopped)
{
    const TemporaryFolder folder;
    const std::string path = folder.write("tube.obj", tubeWithCornerAt("2400 30 20"));
    core::VesselInput input;
    input.kind = core::VesselInputKind::Surface;
    for (const int heardAfter : {1, 2, 3, 5, 8, 13, 21, 34}) {
        int asked = 0;
        const auto vessels = io::readVessels(path, input, [&](double) {
            return ++asked >= heardAfter ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        if (asked < heardAfter) {
            break;   // finished before that call
        }
        ASSERT_FALSE(vessels);
        EXPECT_TRUE(vessels.error().isCancellation()) << vessels.error().message;
        EXPECT_LE(asked, heardAfter + 1) << "once stopped, it ends";
    }
}

TEST(ReadSurface, PlyIsTakenAtItsWord)
{
    // Values that VTK would take for zeros, or skip.
    const TemporaryFolder folder;
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    std::string wheel = "0 0 0\n", corners = "300";
    for (int i = 0; i < 300; ++i) {
        wheel += std::to_string(100.0 * std::cos(i)) + " " + std::to_string(100.0 * std::sin(i)) + " 0\n";
        corners += " " + std::to_string(i);
    }
    const std::string many = changed(changed(plyText(), "vertex 8", "vertex 301"), "face 12", "face 1");
    const std::string cut = binaryPly(false);
    const std::map<std::string, std::pair<std::string, std::string>> files = {
        {"word.ply", {changed(plyText(), "70.000000", "70.0x0000"), "surface.ply-data-damaged"}},
        {"cut.ply", {cut.substr(0, cut.size() - 3), "surface.ply-data-damaged"}},
        {"short.ply", {changed(plyText(), "face 12", "face 13"), "surface.ply-data-damaged"}},
        {"type.ply", {changed(plyText(), "float z", "flaot z"), "surface.ply-header-damaged"}},
        {"flat.ply", {changed(plyText(), "float z", "float q"), "surface.ply-header-damaged"}},
        {"huge.ply", {changed(plyText(), "vertex 8", "vertex 2147483647"), "surface.ply-header-damaged"}},
        {"none.ply", {changed(plyText(), "face 12", "face 0"), "surface.no-triangles"}},
        {"wheel.ply", {many.substr(0, many.find("end_header\n") + 11) + wheel + corners, "surface.ply-data-damaged"}},
    };
    for (const auto& [name, expected] : files) {
        const auto surface = io::readSurface(folder.write(name, expected.first));
        ASSERT_FALSE(surface) << name;
        EXPECT_EQ(surface.error().message.id(), expected.second) << name;
    }
    EXPECT_TRUE(io::readSurface(folder.write("box.ply", plyText()), 1.0, [](double) {
                    return core::ObserverDecision::Stop;
                }).isStopped());
}

TEST(ReadSurface, AortaInCentimetersKeepsItsVolume)
{
    ANGIOPOSE_NEEDS_DATA("abdominal-aorta-mesh/demo.vtp");
    const std::string path = test::dataFile("abdominal-aorta-mesh/demo.vtp").string();
    const auto asMillimeters = io::readSurface(path);
    ASSERT_TRUE(asMillimeters) << asMillimeters.error().message;
    EXPECT_FALSE(asMillimeters.value().warnings.empty()) << "34 mm of aorta";

    const auto surface = io::readSurface(path, 10.0);

    ASSERT_TRUE(surface);
    EXPECT_TRUE(surface.value().warnings.empty()) << surface.value().warnings.front();
    EXPECT_EQ(surface.value().mesh.triangles.size(), 39'124U);
    double enclosed = 0.0;   // divergence theorem
    for (const auto& t : surface.value().mesh.triangles) {
        const auto& points = surface.value().mesh.pointsInPatient;
        enclosed += points[t[0]].dot(points[t[1]].cross(points[t[2]])) / 6.0;
    }
    const auto mask = core::fillSurface(surface.value().mesh, 1.0);
    ASSERT_TRUE(mask) << mask.error().message;
    const auto inside = static_cast<double>(std::count(mask.value().voxels.begin(), mask.value().voxels.end(), 1));
    EXPECT_NEAR(inside / std::abs(enclosed), 1.0, 0.01);
}
