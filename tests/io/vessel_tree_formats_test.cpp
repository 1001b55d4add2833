#include "core/vessel/root_tree.h"
#include "core/vessel/tree_gaps.h"
#include "core/vessel/tree_knots.h"
#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <bit>
#include <cstdint>

using namespace angiopose;

namespace {

core::VesselTree oddTree()
{
    core::VesselTree tree;
    for (int id : {7, 3}) {
        core::VesselBranch branch{id, id == 7 ? "LAD" : "", {}, {}};
        for (int i = 0; i < 5; ++i) {
            branch.pointsInPatient.emplace_back(i / 3.0, id * 0.1, -1e-7 * i + 1000.0 / 7.0);
            branch.radiusMm.push_back(1.0 / (i + 3));
        }
        tree.branches.push_back(branch);
    }
    return tree;
}

core::VesselTree readTreeOrFail(const std::string& path)
{
    auto tree = io::readVesselTree(path);
    EXPECT_TRUE(tree) << tree.error().message;
    return tree ? std::move(tree).value() : core::VesselTree{};
}

void expectSame(const core::VesselTree& actual, const core::VesselTree& expected)
{
    ASSERT_EQ(actual.branches.size(), expected.branches.size());
    for (std::size_t i = 0; i < actual.branches.size(); ++i) {
        EXPECT_EQ(actual.branches[i].id, expected.branches[i].id);
        EXPECT_EQ(actual.branches[i].name, expected.branches[i].name);
        EXPECT_EQ(actual.branches[i].pointsInPatient, expected.branches[i].pointsInPatient);
        EXPECT_EQ(actual.branches[i].radiusMm, expected.branches[i].radiusMm);
    }
}

template <class Number>
std::string bigEndian(Number value)
{
    std::string bytes(sizeof value, '\0');
    for (std::size_t i = 0; i < sizeof value; ++i) {
        const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
        bytes[i] = raw[sizeof value - 1 - i];
    }
    return bytes;
}

std::string treeErrorOf(const std::string& path)
{
    const auto tree = io::readVesselTree(path);
    return tree ? "loaded" : tree.error().message.text();
}

constexpr const char* header = "# vtk DataFile Version 3.0\n";

/// Two trees with one root each, the second with a loop: a branch that ends on another one.
core::VesselTree forest()
{
    core::VesselTree tree;
    const auto add = [&tree](int generation, const std::vector<Eigen::Vector3d>& corners) {
        core::VesselBranch branch{static_cast<int>(tree.branches.size()) + 1, "", corners, {}, generation};
        branch.radiusMm.assign(corners.size(), 1.5);
        tree.branches.push_back(std::move(branch));
    };
    add(0, {{0, 0, 0}, {0, 0, 20}, {0, 0, 40}});
    add(1, {{0, 0, 20}, {10, 0, 30}, {20, 0, 40}});
    add(0, {{50, 0, 0}, {50, 0, 20}, {50, 0, 40}, {50, 0, 60}});
    add(1, {{50, 0, 20}, {70, 0, 30}, {50, 0, 40}});
    return core::resampled(tree, 1.0);
}

TEST(VesselTreeFormats, KeepSeveralRootsAndLoops)
{
    const core::VesselTree tree = forest();
    ASSERT_EQ(core::componentCount(tree), 2);
    double lengthMm = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
    }
    for (const char* name : {"tree.vtp", "tree.csv", "tree.swc", "tree.mrk.json"}) {
        const test::TemporaryFolder folder;
        ASSERT_TRUE(io::writeVesselTree(tree, folder.file(name))) << name;
        const core::VesselTree read = readTreeOrFail(folder.file(name));
        EXPECT_EQ(core::componentCount(read), 2) << name;
        EXPECT_EQ(core::treeKnots(read, {}, 2.0).cuts.size(), 1U) << name;
        double readMm = 0.0;
        for (const core::VesselBranch& branch : read.branches) {
            readMm += branch.lengthMm();
        }
        EXPECT_NEAR(readMm, lengthMm, 3.0) << name;
        const core::VesselTree rooted = core::rootTreeAt(read, {50, 0, 0});
        EXPECT_EQ(std::ranges::count(rooted.branches, 0, &core::VesselBranch::generation), 2) << name;
    }
}

/// Found by fuzzing: VTK 9.1 dereferences a null pointer if an array has a nonexistent type.
TEST(VesselTreeFormats, AnArrayOfNoTypeIsRefused)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("tree.vtp");
    for (const char* type : {"type=\"S parent\"", "", "type=", "type=\"\"", "type='Float'"}) {
        test::writeText(path, std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
                                          "byte_order=\"LittleEndian\">\n<PolyData><FieldData><Array ") +
                                  type +
                                  " Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">1</Array></FieldData>"
                                  "</PolyData></VTKFile>\n");
        const auto tree = io::readVesselTree(path);
        ASSERT_FALSE(tree) << type;
        EXPECT_NE(tree.error().message.text().find("damaged"), std::string::npos) << tree.error().message;
    }
}

}   // namespace

TEST(WriteVesselTree, RestoresEveryBit)
{
    const test::TemporaryFolder folder;
    for (const char* name : {"tree.vtp", "tree.csv"}) {
        ASSERT_TRUE(io::writeVesselTree(oddTree(), folder.file(name)));
        expectSame(readTreeOrFail(folder.file(name)), oddTree());
    }
    EXPECT_FALSE(io::writeVesselTree(oddTree(), folder.file("tree.obj")));
}

TEST(ReadVesselTree, TurnsRasIntoLps)
{
    const test::TemporaryFolder folder;
    const std::string body = "\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1 2 3 4 5 7\nLINES 1 3\n2 0 1\n";
    const auto ras =
        readTreeOrFail(folder.write("ras.vtk", header + std::string("3D Slicer output. SPACE=RAS") + body));
    EXPECT_EQ(ras.branches.at(0).pointsInPatient[0], Eigen::Vector3d(-1, -2, 3));
    const auto lps =
        readTreeOrFail(folder.write("lps.vtk", header + std::string("3D Slicer output. SPACE=LPS") + body));
    EXPECT_EQ(lps.branches.at(0).pointsInPatient[0], Eigen::Vector3d(1, 2, 3));
}

TEST(ReadVesselTree, ReadsBinaryLegacyFiles)
{
    const test::TemporaryFolder folder;
    std::string text = "# vtk DataFile Version 5.1\nvtk output\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n";
    for (const double value : {0.5, 0.0, 1.0, 1.5, 0.0, 1.0, 2.5, 0.25, 1.0}) {
        text += bigEndian(value);
    }
    text += "\nCELLS 2 3\nOFFSETS vtktypeint64\n" + bigEndian<std::int64_t>(0) + bigEndian<std::int64_t>(3);
    text += "\nCONNECTIVITY vtktypeint64\n";
    for (const std::int64_t index : {0, 1, 2}) {
        text += bigEndian(index);
    }
    text += "\nCELL_TYPES 1\n" + bigEndian<std::int32_t>(4);
    text += "\nPOINT_DATA 3\nFIELD FieldData 1\nMaximumInscribedSphereRadius 1 3 float\n";
    for (const float value : {1.0F, 0.5F, 0.25F}) {
        text += bigEndian(value);
    }
    const auto tree = readTreeOrFail(folder.write("grid.vtk", text + "\n"));
    ASSERT_EQ(tree.branches.size(), 1u);
    EXPECT_EQ(tree.branches[0].pointsInPatient[2], Eigen::Vector3d(2.5, 0.25, 1.0));
    EXPECT_EQ(tree.branches[0].radiusMm, (std::vector<double>{1.0, 0.5, 0.25}));
}

TEST(ReadVesselTree, LegacyTextMayHoldNoNumbersAndAnyWords)
{
    // "nan" as written by VTK's own writer, CRLF, arrays of every kind, names in field data.
    const test::TemporaryFolder folder;
    std::string text = header + std::string(
                                    "t\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nSPACE 1 1 string\nRAS\n"
                                    "POINTS 3 double\n0.1 0 0 1 0 0 2 0 0\nMETADATA\nINFORMATION 0\n\n"
                                    "VERTICES 1 2\n1 0\nLINES 1 4\n3 0 1 2\nCELL_DATA 2\nFIELD FieldData 1\n"
                                    "GroupIds 1 2 int\n5 12\nPOINT_DATA 3\nNORMALS n float\n0 0 1 0 0 1 0 0 1\n"
                                    "FIELD FieldData 2\nflow 1 3 float\nnan -inf 1\nRadius 1 3 double\n1 0.1 2\n");
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
        text.insert(at, "\r");
    }
    const auto tree = readTreeOrFail(folder.write("rich.vtk", text));
    ASSERT_EQ(tree.branches.size(), 1u);
    EXPECT_EQ(tree.branches[0].id, 12);
    EXPECT_EQ(tree.branches[0].pointsInPatient[0], Eigen::Vector3d(-0.1, 0, 0));
    EXPECT_EQ(tree.branches[0].radiusMm, (std::vector<double>{1.0, 0.1, 2.0}));
}

TEST(ReadVesselTree, StopEndsTheDecoderOfALegacyFile)
{
    const test::TemporaryFolder folder;
    const std::string path =
        folder.write("tree.vtk", header + std::string("t\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
                                                      "0 0 0 1 0 0\nLINES 1 3\n2 0 1\n"));
    EXPECT_TRUE(io::readVesselTree(path, {}, [](double) { return core::ObserverDecision::Stop; }).isStopped());
    EXPECT_TRUE(io::readVesselTree(path, {}, [](double) { return core::ObserverDecision::Continue; }));
}

TEST(ReadVesselTree, ChainsSegmentsAtBifurcations)
{
    const test::TemporaryFolder folder;
    const auto tree = readTreeOrFail(
        folder.write("segments.vtk", header + std::string("y\nASCII\nDATASET POLYDATA\n"
                                                          "POINTS 6 float\n0 0 0 1 0 0 2 0 0 3 1 0 4 2 0 3 -1 0\n"
                                                          "LINES 5 15\n2 0 1\n2 1 2\n2 2 3\n2 3 4\n2 2 5\n")));
    ASSERT_EQ(tree.branches.size(), 3u);
    EXPECT_EQ(tree.pointCount(), 3u + 3u + 2u);
}

TEST(ReadVesselTree, ReadsSwcInItsUnit)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write(
        "tree.swc", "# comment\n1 2 0 0 0 500 -1\n2 2 1000 0 0 400 1\n3 2 2000 0 0 300 2\n4 2 2000 1000 0 200 2\n");
    const auto tree = io::readVesselTree(path, {.unitMm = 0.001});
    ASSERT_TRUE(tree) << tree.error().message;
    ASSERT_EQ(tree.value().branches.size(), 3u);
    EXPECT_NEAR(tree.value().branches[0].lengthMm(), 1.0, 1e-12);
    EXPECT_NEAR(tree.value().branches[0].radiusMm[0], 0.5, 1e-12);
    EXPECT_NE(treeErrorOf(folder.write("orphan.swc", "1 2 0 0 0 1 9\n")).find("parent"), std::string::npos);
}

TEST(ReadVesselTree, MultipliesLengthsByTheUnit)
{
    const test::TemporaryFolder folder;
    const std::string table = folder.write("tree.csv", "x,y,z,radius\n0,0,0,0.002\n0.05,0,0,0.001\n0.1,0,0,0.001\n");
    const std::string lines =
        folder.write("tree.vtk", header + std::string("y\nASCII\nDATASET POLYDATA\n"
                                                      "POINTS 3 float\n0 0 0 0.05 0 0 0.1 0 0\n"
                                                      "LINES 1 4\n3 0 1 2\n"
                                                      "POINT_DATA 3\nSCALARS Radius float\n"
                                                      "LOOKUP_TABLE default\n0.002 0.001 0.001\n"));
    for (const std::string& path : {table, lines}) {
        const auto tree = io::readVesselTree(path, {.unitMm = 1000.0});
        ASSERT_TRUE(tree) << tree.error().message;
        ASSERT_EQ(tree.value().branches.size(), 1u) << path;
        EXPECT_NEAR(tree.value().branches[0].lengthMm(), 100.0, 1e-4) << path;
        EXPECT_NEAR(tree.value().branches[0].radiusMm[0], 2.0, 1e-6) << path;
    }
}

TEST(WriteVesselTree, SwcKeepsPointsRadiiAndForks)
{
    const test::TemporaryFolder folder;
    core::VesselTree tree;
    tree.branches.push_back({1, "", {{0.1, 0.0, 0.0}, {10.0, 0.0, 0.0}, {20.0, 0.3, 0.0}}, {3.0, 2.5, 2.0}});
    tree.branches.push_back({2, "", {{10.0, 30.0, 0.0}, {10.0, 15.0, 1.0 / 3.0}, {10.0, 0.0, 0.0}}, {1.0, 1.1, 2.5}});
    tree.branches.push_back({3, "", {{10.0, 16.0, 0.3}, {10.0, 16.0, 9.0}}, {1.0, 0.9}});   // touches branch 2
    tree.branches.push_back({4, "", {{90.0, 0.0, 0.0}, {99.0, 0.0, 0.0}}, {1.0, 1.0}});   // not connected to the others
    const std::string path = folder.file("tree.swc");
    ASSERT_TRUE(io::writeVesselTree(tree, path));
    const core::VesselTree read = readTreeOrFail(path);
    EXPECT_EQ(read.branches.size(), 6u);   // split at the two bifurcations
    EXPECT_EQ(read.pointCount(), 2u + 2u + 2u + 2u + 3u + 2u);
    const auto has = [&](const Eigen::Vector3d& point, double radius) {
        for (const core::VesselBranch& branch : read.branches) {
            for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
                if (branch.pointsInPatient[i] == point && branch.radiusMm[i] == radius) {
                    return true;
                }
            }
        }
        return false;
    };
    EXPECT_TRUE(has({10.0, 15.0, 1.0 / 3.0}, 1.1));
    EXPECT_TRUE(has({20.0, 0.3, 0.0}, 2.0));
    const auto nodes = core::findNodes(read);
    EXPECT_EQ(std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return node.isBifurcation(); }), 2);
}

TEST(WriteVesselTree, SwcWithoutRadii)
{
    const test::TemporaryFolder folder;
    core::VesselTree tree;
    tree.branches.push_back({1, "", {{0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}}, {}});
    const std::string path = folder.file("tree.swc");
    ASSERT_TRUE(io::writeVesselTree(tree, path));
    EXPECT_EQ(readTreeOrFail(path).branches.size(), 1u);
}

TEST(ReadVesselTree, CountsSharedTrunksOnce)
{
    // Two lines from one inlet that separate after 20 mm, as written by VMTK.
    const test::TemporaryFolder folder;
    std::string text = "x,y,z,branch\n";
    for (int line = 1; line <= 2; ++line) {
        for (int i = 0; i <= 40; ++i) {
            const double side = i > 20 ? (i - 20) * (line == 1 ? 1.0 : -1.0) : 0.0;
            text += std::to_string(i) + "," + std::to_string(side) + ",0," + std::to_string(line) + "\n";
        }
    }
    const auto tree = readTreeOrFail(folder.write("vmtk.csv", text));
    ASSERT_EQ(tree.branches.size(), 3u);
    double length = 0.0;
    for (const auto& branch : tree.branches) {
        length += branch.lengthMm();
    }
    EXPECT_NEAR(length, 20.0 + 2.0 * 20.0 * std::sqrt(2.0), 1e-6);
}

TEST(ReadVesselTree, SplitsTheRealCoronaryTrees)
{
    ANGIOPOSE_NEEDS_DATA("coronary-ccta-centerlines/lca_cl.vtp");
    const auto left = readTreeOrFail(test::dataFile("coronary-ccta-centerlines/lca_cl.vtp").string());
    EXPECT_EQ(left.branches.size(), 9u);   // 5 outlets: 5 + 4 sections between bifurcations
    double length = 0.0;
    for (const auto& branch : left.branches) {
        length += branch.lengthMm();
        EXPECT_EQ(branch.radiusMm.size(), branch.pointsInPatient.size());
    }
    EXPECT_NEAR(length, 428.3, 1.0);   // the five lines have a total of 792 mm
    const auto right = readTreeOrFail(test::dataFile("coronary-ccta-centerlines/rca_cl.vtp").string());
    EXPECT_EQ(right.branches.size(), 7u);
    const auto rows = readTreeOrFail(test::dataFile("coronary-ccta-centerlines/centerline_lca.csv").string());
    for (const auto& branch : rows.branches) {
        for (std::size_t i = 1; i < branch.pointsInPatient.size(); ++i) {
            EXPECT_LT((branch.pointsInPatient[i] - branch.pointsInPatient[i - 1]).norm(), 5.0);   // no jumps
        }
    }
}

TEST(ReadVesselTree, KeepsIdsOfTheFile)
{
    const test::TemporaryFolder folder;
    const std::string body =
        "ids\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n0 0 0 1 0 0 2 0 0 0 5 0 1 5 0 2 6 0\nLINES 2 8\n3 0 1 2\n3 3 4 "
        "5\n";
    const auto tree = readTreeOrFail(
        folder.write("ids.vtk", header + body + "CELL_DATA 2\nSCALARS GroupIds int 1\nLOOKUP_TABLE default\n12 4\n"));
    EXPECT_EQ(tree.branches[0].id, 12);
    EXPECT_EQ(tree.branches[1].id, 4);
    const auto repeated = readTreeOrFail(
        folder.write("same.vtk", header + body + "CELL_DATA 2\nSCALARS GroupIds int 1\nLOOKUP_TABLE default\n5 5\n"));
    EXPECT_EQ(repeated.branches[0].id, 1);
    EXPECT_EQ(repeated.branches[1].id, 2);
}

TEST(ReadVesselTree, SaysWhatIsWrong)
{
    const test::TemporaryFolder folder;
    EXPECT_NE(treeErrorOf(folder.write("a.csv", "x,y,z\n0,0,0\n1,nan,0\n")).find("line 3"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("b.csv", "x,y,z\n0,0,0\n1,0\n")).find("line 3"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("c.csv", "x;y;z\n0,5;0;0\n")).find("columns"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("d.csv", "x,y,z\n1,1,1\n1,1,1\n")).find("two distinct points"),
              std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("e.csv", "x,y,z\n")).find("no lines"), std::string::npos);
    const std::string start = header + std::string("t\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 nan\n");
    EXPECT_NE(treeErrorOf(folder.write("f.vtk", start + "LINES 1 3\n2 0 1\n")).find("not a number"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("g.vtk", start + "LINES 1 3\n2 0 7\n")).find("does not exist"),
              std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("h.vtk", start + "POLYGONS 1 4\n3 0 1 1\n")).find("surface"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("i.vtk", start + "LINES 1 90\n89 0 1\n")).find("LINES"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("j.vtk", start + "LINES 2 3\n2 0 1\n")).find("LINES"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("k.vtk", start + "LINES 1 3\n2 0 x\n")).find("LINES"), std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("l.vtk", start + "LINES 1 3\n2 0 1\nPOINT_DATA 9\n")).find("POINT_DATA"),
              std::string::npos);
}

TEST(ReadVesselTree, ReadsSlicerCurves)
{
    const test::TemporaryFolder folder;
    const std::string curve = R"({"markups": [{"type": "Curve", "coordinateSystem": "RAS", "coordinateUnits": "mm",
        "controlPoints": [{"position": [1, 2, 3]}, {"position": [4, 5, 6.5]},
                          {"position": [0, 0, 0], "positionStatus": "undefined"}]}]})";
    const auto tree = readTreeOrFail(folder.write("curve.mrk.json", curve));
    ASSERT_EQ(tree.branches.size(), 1u);
    EXPECT_EQ(tree.branches[0].pointsInPatient, (std::vector<Eigen::Vector3d>{{-1.0, -2.0, 3.0}, {-4.0, -5.0, 6.5}}));
    EXPECT_NE(treeErrorOf(folder.write("other.json", "{\"markups\": [{\"type\": \"Curve\"}]}")).find("Slicer"),
              std::string::npos);
    EXPECT_NE(treeErrorOf(folder.write("none.json", "{}")).find("Slicer"), std::string::npos);
}
