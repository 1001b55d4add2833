#include "io/vessel/stated_coordinates.h"
#include "io/fiducial_file.h"
#include "io/messages/messages.h"
#include "io/opening/add_vessels.h"
#include "io/surface_file.h"
#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

// Units and axes stated by a mesh, a curve or a table are used; otherwise a message says that they are not.

namespace {

bool hasWarning(const core::Messages& warnings, const core::MessageEntry& entry)
{
    return std::ranges::any_of(warnings, [&](const core::Message& each) { return each.is(entry); });
}

double unitOf(const std::string& header, double asked = 0.0)
{
    const auto rule = io::coordinateConversion(header, asked, "x");
    return rule ? rule.value().unitMm : -1.0;
}

TEST(StatedCoordinates, UnitsAreReadInTheWordsOfManyPrograms)
{
    for (const char* centimeters :
         {"# vertex coordinates are measured in units, where 1 unit = 10.000000 mm", "# Units: cm", "# units are in cm",
          "# File units = centimeters", "UNITS=cm", "solid part unit cm", "comment unit: Centimetre",
          "# 100 units = 1 m", "# 10 mm per unit", "unitMm = 10", "LengthUnit = cm", "# all coordinates are in cm",
          "# points (cm)", "# Coordinates [cm]", "Exported in centimeters", "# one unit is 1 cm", "#units cm"}) {
        EXPECT_DOUBLE_EQ(unitOf(centimeters), 10.0) << centimeters;
    }
    EXPECT_DOUBLE_EQ(unitOf("# 1 unit = 1000.0 mm"), 1000.0);
    EXPECT_DOUBLE_EQ(unitOf("# units: inches"), 25.4);
    EXPECT_DOUBLE_EQ(unitOf("# unit: in"), 25.4);
    EXPECT_DOUBLE_EQ(unitOf("# units: \xc2\xb5m"), 0.001);
    EXPECT_DOUBLE_EQ(unitOf("# units: microns"), 0.001);
    EXPECT_DOUBLE_EQ(unitOf("# units: m"), 1000.0);
    EXPECT_DOUBLE_EQ(unitOf("# units: METERS"), 1000.0);
}

TEST(StatedCoordinates, OtherWordsAreNoUnit)
{
    for (const char* words :
         {"# Blender v2.8 OBJ File", "binary STL by AngioPose, SPACE=LPS, mm", "# community mesh of 12 points",
          "# id type x y z radius parent; mm, patient LPS; type 5 where branches meet", "# unit sphere",
          "# 1 unit = 0 mm", "vtk output", "# units: pixels", "# units: mm/s", "# 1 unit = mm2", "x,y,z,radius,branch",
          ""}) {
        const auto rule = io::coordinateConversion(words, 0.0, "x");
        ASSERT_TRUE(rule) << words;
        EXPECT_EQ(rule.value().unitMm, 1.0) << words;
        EXPECT_FALSE(rule.value().isUnitStated) << words;
    }
}

TEST(StatedCoordinates, WhatIsAskedForGoesFirstAndTheDifferenceIsSaid)
{
    const auto asked = io::coordinateConversion("# units: cm", 1.0, "x");
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked.value().unitMm, 1.0);
    EXPECT_TRUE(hasWarning(asked.value().notes, io::messages::unitOverruled));
    const auto agreed = io::coordinateConversion("# units: cm", 10.0, "x");
    EXPECT_TRUE(hasWarning(agreed.value().notes, io::messages::unitStated));
    const auto two = io::coordinateConversion("# units: cm\n# 1 unit = 1 m", 0.0, "x");
    EXPECT_TRUE(hasWarning(two.value().notes, io::messages::unitsContradict));
    EXPECT_TRUE(io::coordinateConversion("# units: mm", 0.0, "x").value().notes.empty());
    for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_TRUE(io::coordinateConversion("", wrong, "x").error().message.is(io::messages::fileWrongUnit));
    }
}

TEST(StatedCoordinates, AxesAreTurnedOrNamed)
{
    for (const char* ras : {"# SPACE=RAS", "comment Space: ras", "# coordinate system = RAS", "SPACE = RAS",
                            "# axes: right-anterior-superior"}) {
        EXPECT_TRUE(io::coordinateConversion(ras, 0.0, "x").value().isRas) << ras;
    }
    for (const char* other : {"# SPACE=LPS", "# space is air", "# coordinates in lap units", "vtk output"}) {
        const auto rule = io::coordinateConversion(other, 0.0, "x");
        ASSERT_TRUE(rule) << other;
        EXPECT_FALSE(rule.value().isRas) << other;
    }
    for (const char* wrong : {"# SPACE=LAS", "# space: rai", "# axes are LPI"}) {
        const auto rule = io::coordinateConversion(wrong, 0.0, "x");
        ASSERT_FALSE(rule) << wrong;
        EXPECT_TRUE(rule.error().message.is(io::messages::axesOther)) << wrong;
    }
}

/// Corners of a box of 70 x 50 x 30 with one corner at the origin.
constexpr const char* boxPoints[] = {"0 0 0",  "70 0 0",  "70 50 0",  "0 50 0",
                                     "0 0 30", "70 0 30", "70 50 30", "0 50 30"};
constexpr const char* boxFaces[] = {"0 2 1", "0 3 2", "4 5 6", "4 6 7", "0 1 5", "0 5 4",
                                    "1 2 6", "1 6 5", "2 3 7", "2 7 6", "3 0 4", "3 4 7"};

std::string rows(const std::string& prefix, std::span<const char* const> lines)
{
    std::string text;
    for (const char* line : lines) {
        text += prefix + line + "\n";
    }
    return text;
}

std::string objFaces()
{
    std::string text;
    for (const char* face : boxFaces) {
        text += std::string("f ") + static_cast<char>(face[0] + 1) + " " + static_cast<char>(face[2] + 1) + " " +
                static_cast<char>(face[4] + 1) + "\n";
    }
    return text;
}

std::string stlOf(const std::string& solid, const std::string& end, bool inCapitals)
{
    std::string text = solid + "\n";
    for (const char* face : boxFaces) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : {face[0] - '0', face[2] - '0', face[4] - '0'}) {
            text += "vertex " + std::string(boxPoints[corner]) + "\n";
        }
        text += "endloop\nendfacet\n";
    }
    text += end;
    if (inCapitals) {
        std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
    return text;
}

void expectAcross(const core::Result<io::LoadedSurface>& surface, double unitMm, double sign, const std::string& what)
{
    ASSERT_TRUE(surface) << what << ": " << surface.error().message;
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
    for (const Eigen::Vector3d& point : surface.value().mesh.pointsInPatient) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    EXPECT_EQ(surface.value().mesh.triangles.size(), 12U) << what;
    EXPECT_LT(((high - low) - unitMm * Eigen::Vector3d(70, 50, 30)).norm(), 1e-6 * unitMm) << what;
    EXPECT_NEAR(sign > 0.0 ? low.x() : high.x(), 0.0, 1e-9) << what;
}

TEST(StatedCoordinates, HoldForSurfacesOfEveryFormat)
{
    const test::TemporaryFolder folder;
    const std::string points = rows("", boxPoints), faces = rows("3 ", boxFaces);
    const auto vtk = [&](const std::string& title) {
        return "# vtk DataFile Version 3.0\n" + title + "\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" + points +
               "POLYGONS 12 48\n" + faces;
    };
    const auto ply = [&](const std::string& comment) {
        return "ply\nformat ascii 1.0\n" + comment +
               "\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 12\nproperty "
               "list uchar int vertex_indices\nend_header\n" +
               points + faces;
    };
    std::string field = vtk("x");
    field.insert(field.find("POINTS"), "FIELD FieldData 2\nSPACE 1 1 string\nRAS\nLengthUnit 1 1 string\ncm\n");
    const std::string obj = rows("v ", boxPoints) + objFaces();
    const std::vector<std::tuple<std::string, std::string, double, double>> files = {
        {"a.obj", "# vertex coordinates are measured in units, where 1 unit = 10.000000 mm\n" + obj, 10.0, 1.0},
        {"b.obj", "mtllib x\n# SPACE=RAS\n# 1 unit = 1000.0 mm\n" + obj, 1000.0, -1.0},
        {"c.obj", obj, 1.0, 1.0},
        {"d.ply", ply("comment units: cm"), 10.0, 1.0},
        {"e.ply", ply("obj_info SPACE=RAS"), 1.0, -1.0},
        {"f.vtk", vtk("vessels, unit = cm, SPACE=RAS"), 10.0, -1.0},
        {"g.vtk", field, 10.0, -1.0},
        {"h.stl", stlOf("solid box UNITS=cm", "endsolid\n", false), 10.0, 1.0},
        {"i.STL", stlOf("solid box SPACE=RAS", "endsolid\n", true), 1.0, -1.0}};
    for (const auto& [name, content, unitMm, sign] : files) {
        const auto surface = io::readSurface(folder.write(name, content));
        expectAcross(surface, unitMm, sign, name);
        EXPECT_EQ(hasWarning(surface.value().warnings, io::messages::unitStated), unitMm != 1.0) << name;
    }
    const auto forced = io::readSurface(folder.file("a.obj"), 1.0);
    expectAcross(forced, 1.0, 1.0, "asked for");
    EXPECT_TRUE(hasWarning(forced.value().warnings, io::messages::unitOverruled));
}

TEST(StatedCoordinates, AreNotAskedForAgain)
{
    const test::TemporaryFolder folder;
    std::string small = "# units: mm\n";
    for (int i = 0; i < 10; ++i) {
        small += std::to_string(0.01 * i) + ",0,0\n";
    }
    for (const bool isStated : {true, false}) {
        io::LoadedInputs inputs;
        const std::string path = folder.write("small.csv", isStated ? small : small.substr(small.find('\n') + 1));
        ASSERT_TRUE(io::addVessels(inputs, path, {}, "", {}));
        EXPECT_EQ(inputs.extentInUnknownUnits.has_value(), !isStated);
    }
}

TEST(StatedCoordinates, HoldForCenterlinesOfEveryFormat)
{
    const test::TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.csv", "# units: cm; SPACE=RAS\nx,y,z,radius\n0,0,0,1\n1,0,0,1\n2,0,0,1\n"},
        {"b.swc", "# units: cm\n# space = RAS\n1 2 0 0 0 1 -1\n2 2 1 0 0 1 1\n3 2 2 0 0 1 2\n"},
        {"c.vtk",
         "# vtk DataFile Version 3.0\nSPACE=RAS unit cm\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 2 0 "
         "0\nLINES 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS Radius float 1\nLOOKUP_TABLE default\n1 1 1\n"}};
    for (const auto& [name, content] : files) {
        const auto read = io::readTree(folder.write(name, content));
        ASSERT_TRUE(read) << name << read.error().message;
        const core::VesselBranch& branch = read.value().tree.branches.front();
        EXPECT_EQ(branch.pointsInPatient.back(), Eigen::Vector3d(-20, 0, 0)) << name;
        EXPECT_EQ(branch.radiusMm.front(), 10.0) << name;
        EXPECT_TRUE(hasWarning(read.value().warnings, io::messages::unitStated)) << name;
        EXPECT_TRUE(read.value().isUnitStated);
    }
}

std::string markup(const std::string& type, const std::string& more, double scale = 1.0)
{
    std::string points;
    for (int i = 0; i < 31; ++i) {
        points += (i > 0 ? ", " : "") + std::string("{\"label\": \"p\", \"position\": [") +
                  std::to_string(2.0 * i * scale) + ", " + std::to_string(scale) + ", 0]}";
    }
    return "{\"markups\": [{\"type\": \"" + type + "\"" + more + ", \"controlPoints\": [" + points + "]}]}";
}

TEST(SlicerMarkups, UnitsAndAxesAreUsedOrNamed)
{
    const test::TemporaryFolder folder;
    const auto endOf = [&](const std::string& more, double scale) {
        const auto tree = io::readVesselTree(folder.write("c.mrk.json", markup("Curve", more, scale)));
        EXPECT_TRUE(tree) << more << tree.error().message;
        return tree ? tree.value().branches.front().pointsInPatient.back() : Eigen::Vector3d(0, 0, 0);
    };
    const auto near = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() < 1e-9; };
    EXPECT_TRUE(near(endOf("", 1.0), {60, 1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateUnits": ["mm", "UCUM", "millimeter"])", 1.0), {60, 1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateUnits": ["um", "UCUM", "micrometer"])", 1000.0), {60, 1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateUnits": "um")", 1000.0), {60, 1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateUnits": "MM")", 1.0), {60, 1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateUnits": "cm")", 0.1), {60, 1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateSystem": "ras")", 1.0), {-60, -1, 0}));
    EXPECT_TRUE(near(endOf(R"(, "coordinateSystem": "Lps")", 1.0), {60, 1, 0}));
    for (const char* type : {"Curve", "Fiducial"}) {
        const auto problemOf = [&](const std::string& more) {
            const std::string path = folder.write("w.mrk.json", markup(type, more));
            const auto tree = io::readVesselTree(path);
            const auto points = io::readFiducials(path);
            EXPECT_FALSE(std::string(type) == "Curve" ? bool(tree) : bool(points)) << more;
            return std::string(type) == "Curve" ? tree.error().message.text() : points.error().message.text();
        };
        EXPECT_NE(problemOf(R"(, "coordinateSystem": "IJK")").find("IJK"), std::string::npos);
        EXPECT_NE(problemOf(R"(, "coordinateUnits": "furlong")").find("furlong"), std::string::npos);
        EXPECT_NE(problemOf(R"(, "coordinateUnits": ["px", "UCUM", "pixel"])").find("px"), std::string::npos);
    }
    const auto points = io::readFiducials(
        folder.write("p.mrk.json", markup("Fiducial", R"(, "coordinateUnits": ["um", "UCUM", "micrometer"])", 1000.0)));
    ASSERT_TRUE(points) << points.error().message;
    EXPECT_TRUE(near(points.value().back().pointInPatient, {60, 1, 0}));
}

TEST(SlicerMarkups, PointsThatAreNotPlacedAreLeftOutAndCounted)
{
    const test::TemporaryFolder folder;
    std::string text = markup("Curve", "");
    const auto put = [&text](const std::string& before, const std::string& instead) {
        const std::size_t at = text.find(before);
        text.replace(at, text.find('}', at) - at, instead);
    };
    put("\"position\": [14.0", R"("position": [0, 0, 0], "positionStatus": "undefined")");
    put("\"position\": [18.0", R"("position": [1, 2, 3], "positionStatus": "Preview")");
    put("\"position\": [22.0", R"("position": null, "positionStatus": "missing")");
    put("\"position\": [30.0", R"("position": null)");
    const auto read = io::readTree(folder.write("c.mrk.json", text));
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read.value().tree.branches.size(), 1U);
    EXPECT_EQ(read.value().tree.pointCount(), 27U);
    EXPECT_NEAR(read.value().tree.branches.front().lengthMm(), 60.0, 1e-9);
    ASSERT_TRUE(hasWarning(read.value().warnings, io::messages::markupsNotPlaced));
    EXPECT_NE(read.value().warnings.front().text().find("(number: 4)"), std::string::npos);
}

/// Writes the same points in the three line formats.
std::vector<std::string> writtenLines(const test::TemporaryFolder& folder, const std::vector<Eigen::Vector3d>& points)
{
    std::string table = "x,y,z,branch\n", json, vtk, ids;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto joined = [&](const char* between) {
            return std::to_string(points[i].x()) + between + std::to_string(points[i].y()) + between +
                   std::to_string(points[i].z());
        };
        table += joined(",") + ",1\n";
        json += (i > 0 ? ", " : "") + std::string("{\"position\": [") + joined(", ") + "]}";
        vtk += joined(" ") + "\n";
        ids += " " + std::to_string(i);
    }
    const std::string count = std::to_string(points.size());
    return {
        folder.write("l.csv", table),
        folder.write("l.mrk.json", R"({"markups": [{"type": "Curve", "controlPoints": [)" + json + "]}]}"),
        folder.write("l.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS " + count + " double\n" +
                                  vtk + "LINES 1 " + std::to_string(points.size() + 1) + "\n" + count + ids + "\n")};
}

std::vector<Eigen::Vector3d> bow()
{
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= 30; ++i) {
        points.emplace_back(40.0 * std::cos(0.05 * i), 40.0 * std::sin(0.05 * i), 0.0);
    }
    return points;
}

double lengthOf(const core::VesselTree& tree)
{
    double lengthMm = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
    }
    return lengthMm;
}

TEST(LinesThatLeap, HaveTheirBeginningPutBackInEveryFormat)
{
    const test::TemporaryFolder folder;
    const std::vector<Eigen::Vector3d> whole = bow();
    for (const std::ptrdiff_t shift : {1, 4, 15, 30}) {
        std::vector<Eigen::Vector3d> points = whole;
        std::ranges::rotate(points, points.begin() + shift);
        for (const std::string& path : writtenLines(folder, points)) {
            const auto read = io::readTree(path);
            ASSERT_TRUE(read) << path << read.error().message;
            ASSERT_EQ(read.value().tree.branches.size(), 1U) << path;
            EXPECT_NEAR(lengthOf(read.value().tree), 30 * 80.0 * std::sin(0.025), 1e-3) << path;
            EXPECT_LT((read.value().tree.branches.front().pointsInPatient.front() - whole.front()).norm(), 1e-5);
            EXPECT_TRUE(hasWarning(read.value().warnings, io::messages::treeTurnedRound)) << path;
        }
    }
}

TEST(LinesThatLeap, AreCutThereInEveryFormat)
{
    const test::TemporaryFolder folder;
    std::vector<Eigen::Vector3d> points = bow();
    for (const Eigen::Vector3d& point : bow()) {
        points.push_back(point + Eigen::Vector3d(0, 0, 70));
    }
    for (const std::string& path : writtenLines(folder, points)) {
        const auto read = io::readTree(path);
        ASSERT_TRUE(read) << path << read.error().message;
        EXPECT_EQ(read.value().tree.branches.size(), 2U) << path;
        EXPECT_NEAR(lengthOf(read.value().tree), 60 * 80.0 * std::sin(0.025), 1e-3) << path;
        EXPECT_TRUE(hasWarning(read.value().warnings, io::messages::treeLeaps)) << path;
    }
}

TEST(LinesThatLeap, AreNotThoseOfFewOrUnevenPoints)
{
    const test::TemporaryFolder folder;
    for (const std::vector<Eigen::Vector3d>& points :
         {std::vector<Eigen::Vector3d>{{0, 0, 0}, {70, 0, 0}},
          std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {70, 0, 0}},
          std::vector<Eigen::Vector3d>{{0, 0, 0}, {4, 0, 0}, {9, 0, 0}, {45, 0, 0}, {52, 0, 0}}, bow()}) {
        for (const std::string& path : writtenLines(folder, points)) {
            const auto read = io::readTree(path);
            ASSERT_TRUE(read) << path;
            EXPECT_EQ(read.value().tree.pointCount(), points.size()) << path;
            EXPECT_TRUE(read.value().warnings.empty()) << path;
        }
    }
}

/// The box as binary STL, with `declared` triangles in its header and `trailing` appended.
std::string binaryStl(const std::string& title, std::uint32_t declared, const std::string& trailing)
{
    std::string content = title;
    content.resize(80);
    content.append(reinterpret_cast<const char*>(&declared), 4);
    for (const char* face : boxFaces) {
        content.append(12, '\0');
        for (const int corner : {face[0] - '0', face[2] - '0', face[4] - '0'}) {
            float point[3];
            std::sscanf(boxPoints[corner], "%f %f %f", point, point + 1, point + 2);
            content.append(reinterpret_cast<const char*>(point), 12);
        }
        content.append(2, '\0');
    }
    return content + trailing;
}

TEST(StlFiles, MayBeginWithSolidAndEndWithMore)
{
    const test::TemporaryFolder folder;
    for (const char* title : {"box", "solid box", "SOLID BOX"}) {
        for (const std::size_t more : {0U, 1U, 49U, 51U, 400U}) {
            const auto surface = io::readSurface(folder.write("box.stl", binaryStl(title, 12, std::string(more, 'x'))));
            expectAcross(surface, 1.0, 1.0, title + std::to_string(more));
            EXPECT_EQ(hasWarning(surface.value().warnings, io::messages::stlTooMany), more >= 50) << more;
        }
    }
    expectAcross(io::readSurface(folder.write("b.stl", binaryStl("solid, unit = cm", 12, "tail"))), 10.0, 1.0, "unit");
    expectAcross(io::readSurface(folder.write("c.STL", stlOf("Solid x", "EndSolid x\n", true))), 1.0, 1.0, "capitals");
    expectAcross(io::readSurface(folder.write("d.stl", stlOf("solid x", "endsolid x\nmade by hand\n", false))), 1.0,
                 1.0, "words behind");
}

TEST(StlFiles, WhoseHeaderContradictsThemAreNamedWithBothNumbers)
{
    const test::TemporaryFolder folder;
    for (const std::uint32_t declared : {13U, 4000000000U, 0U}) {
        const auto surface = io::readSurface(folder.write("box.stl", binaryStl("box", declared, "")));
        ASSERT_FALSE(surface);
        const std::string text = surface.error().message.text();
        EXPECT_NE(text.find("declares " + std::to_string(declared)), std::string::npos) << text;
        EXPECT_NE(text.find("contains 12"), std::string::npos) << text;
    }
    const auto cut = io::readSurface(folder.write("cut.stl", stlOf("solid x", "", false)));
    ASSERT_TRUE(cut);
    EXPECT_TRUE(hasWarning(cut.value().warnings, io::messages::stlWithoutEnd));
}

}   // namespace
