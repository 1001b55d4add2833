#include "core/simulation/simulated_case.h"
#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

/// Poly data of two points and one line, with a radius per point; any of the lists may be shorter than declared.
std::string polyData(const std::string& points, const std::string& radii, const std::string& offsets)
{
    return R"(<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="1" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Float64" Name="Radius" format="ascii">)" +
           radii + R"(</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">)" +
           points + R"(</DataArray></Points>
<Lines><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">)" +
           offsets + "</DataArray></Lines></Piece></PolyData></VTKFile>";
}

TEST(ShortArrays, AreRefusedAndNotReadOnAsTheMemoryWas)
{
    const test::TemporaryFolder folder;
    const auto read = [&](const std::string& content) { return io::readVesselTree(folder.write("tree.vtp", content)); };
    EXPECT_TRUE(read(polyData("0 0 0 10 0 0 20 0 0", "1 1 1", "3")));
    EXPECT_FALSE(read(polyData("0 0 0 10 0 0 20 0", "1 1 1", "3")));
    EXPECT_FALSE(read(polyData("0 0 0", "1 1 1", "3")));
    EXPECT_FALSE(read(polyData("0 0 0 10 0 0 20 0 0", "1 1", "3")));
    EXPECT_FALSE(read(polyData("0 0 0 10 0 0 20 0 0", "1 1 1", "")));
}

/// Points of one component each: VTK allocated memory for one component and wrote three.
TEST(ShortArrays, OfFewerComponentsThanAreReadAreRefused)
{
    const test::TemporaryFolder folder;
    std::string content = polyData("0 0 0 10 0 0 20 0 0", "1 1 1", "3");
    const std::string components = "NumberOfComponents=\"3\"";
    content.replace(content.find(components), components.size(), "Components=\"3\"");
    EXPECT_FALSE(io::readVesselTree(folder.write("tree.vtp", content)));
}

TEST(ShortArrays, OfBytesAreRefusedWhereverSomeAreMissing)
{
    const test::TemporaryFolder folder;
    core::TreeOptions options;
    options.branchCount = 2;
    const std::string path = folder.file("good.vtp");
    ASSERT_TRUE(io::writeVesselTree(core::simulateTree(3, options), path));
    const std::string good = test::readText(path);
    const std::size_t points = good.find("<Points>");
    const std::size_t begin = good.find('>', good.find("<DataArray", points)) + 40;
    const std::size_t end = good.find("</DataArray>", points) - 40;
    ASSERT_LT(begin + 400, end);
    for (std::size_t at = begin; at + 80 < end; at += (end - begin) / 7) {
        std::string cut = good;
        cut.erase(at, 40);   // whole groups of four, so that the rest is valid base64
        EXPECT_FALSE(io::readVesselTree(folder.write("cut.vtp", cut))) << at;
    }
}

/// VTK allocates memory for every block declared by the header of a compressed array, here ten gigabytes.
TEST(ShortArrays, CompressedInMoreBlocksThanAnyMemoryHoldsAreRefused)
{
    const test::TemporaryFolder folder;
    std::string content = polyData("AAAAkACAAAAAAAAA", "1 1 1", "3");
    const std::string plain = "byte_order=\"LittleEndian\"";
    content.replace(content.find(plain), plain.size(), plain + " compressor=\"vtkZLibDataCompressor\"");
    const std::string ascii = "NumberOfComponents=\"3\" format=\"ascii\"";
    content.replace(content.find(ascii), ascii.size(), "NumberOfComponents=\"3\" format=\"binary\"");
    const std::string path = folder.write("tree.vtp", content);
    const auto read = io::readVesselTree(path);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.text().find(path), std::string::npos) << read.error().message.text();
}

}   // namespace
