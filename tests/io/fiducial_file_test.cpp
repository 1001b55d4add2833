#include "io/fiducial_file.h"

#include "io/messages/messages.h"
#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using io::Fiducial;

const std::vector<Fiducial> twoPoints{{{12.5, -80.25, 1.0 / 3.0}, "LAD, proximal", "seen at \"frame\" 5"},
                                      {{-3.0, 4.0, 5.0}, "apex", ""}};

std::vector<Fiducial> readOr(const std::string& path)
{
    const auto read = io::readFiducials(path);
    return read ? read.value() : std::vector<Fiducial>{{{0, 0, 0}, read.error().message.text(), ""}};
}

TEST(Fiducials, RestorePointsNamesAndDescriptions)
{
    const test::TemporaryFolder folder;
    for (const char* name : {"points.fcsv", "points.mrk.json"}) {
        ASSERT_TRUE(io::writeFiducials(twoPoints, folder.file(name)));
        EXPECT_EQ(readOr(folder.file(name)), twoPoints) << name;
        EXPECT_TRUE(io::isFiducialFile(folder.file(name)));
    }
    EXPECT_TRUE(io::writeFiducials({}, folder.file("none.fcsv")).error().message.is(io::messages::fiducialsNone));
    EXPECT_TRUE(
        io::writeFiducials(twoPoints, folder.file("points.csv")).error().message.is(io::messages::fiducialsExtension));
}

TEST(Fiducials, TablesOfEveryVersionAreTurnedToLps)
{
    const test::TemporaryFolder folder;
    const auto table = [&](const std::string& system, const std::string& row) {
        return folder.write(
            "p.fcsv", "# Markups fiducial file version = 4.11\n" + system +
                          "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n" + row + "\n");
    };
    const std::string row = "vtkMRMLMarkupsFiducialNode_0,1,2,3,0,0,0,1,1,1,0,F-1,note,vtkMRMLScalarVolumeNode1";
    const Fiducial turned{{-1, -2, 3}, "F-1", "note"}, asItIs{{1, 2, 3}, "F-1", "note"};
    EXPECT_EQ(readOr(table("# CoordinateSystem = 0\n", row)).front(), turned);
    EXPECT_EQ(readOr(table("# CoordinateSystem = RAS\r\n", row)).front(), turned);
    EXPECT_EQ(readOr(table("# CoordinateSystem = 1\n", row)).front(), asItIs);
    EXPECT_EQ(readOr(table("# CoordinateSystem = LPS\n", row)).front(), asItIs);
    EXPECT_EQ(readOr(table("", row)).front(), turned);   // versions that do not state it use RAS
    EXPECT_TRUE(
        io::readFiducials(table("# CoordinateSystem = 2\n", row)).error().message.is(io::messages::fiducialsSystem));
    const auto old = folder.write("old.fcsv", "# name = L\n# columns = label,x,y,z,sel,vis\nnose,1,2,3,1,1\n");
    EXPECT_EQ(readOr(old).front(), (Fiducial{{-1, -2, 3}, "nose", ""}));
}

TEST(Fiducials, MarkupsSayTheirSystemAndCurvesAreNone)
{
    const test::TemporaryFolder folder;
    const std::string point = R"({"id": "1", "label": "A", "position": [1, 2, 3]},
        {"id": "2", "label": "B", "position": [9, 9, 9], "positionStatus": "undefined"})";
    const auto markups = [&](const std::string& type, const std::string& system) {
        return folder.write("m.mrk.json", R"({"markups": [{"type": ")" + type + R"(", "coordinateSystem": ")" + system +
                                              R"(", "controlPoints": [)" + point + "]}]}");
    };
    EXPECT_EQ(readOr(markups("Fiducial", "RAS")), (std::vector<Fiducial>{{{-1, -2, 3}, "A", ""}}));
    EXPECT_EQ(readOr(markups("Fiducial", "LPS")).front().pointInPatient, Eigen::Vector3d(1, 2, 3));
    EXPECT_FALSE(io::isFiducialFile(markups("Curve", "LPS")));
    EXPECT_TRUE(io::readFiducials(markups("Fiducial", "IJK")).error().message.is(io::messages::fiducialsSystem));
}

TEST(Fiducials, WrongLinesAreNamed)
{
    const test::TemporaryFolder folder;
    const auto read = io::readFiducials(folder.write("p.fcsv", "# CoordinateSystem = LPS\nid,1,2,x,0\n"));
    ASSERT_FALSE(read);
    EXPECT_TRUE(read.error().message.is(io::messages::fiducialsLine));
    EXPECT_NE(read.error().message.text().find("line 2"), std::string::npos);
}

}   // namespace
