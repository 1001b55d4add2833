#include "tests/io/volume/volume_bytes.h"
#include "tests/support/german_locale.h"

#include <gtest/gtest.h>

using namespace angiopose;

// Numbers in headers use a decimal point whatever the locale of the reading program, and the locale stays unchanged.

namespace {

std::string voxels()
{
    return std::string(2 * 2 * 2, '\1');
}

std::string nrrd()
{
    return "NRRD0005\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\nspace directions: "
           "(0.8,0,0) (0,1.5,0) (0,0,123.5)\nspace origin: (-36.25,7.75,0.125)\nencoding: raw\n\n" +
           voxels();
}

std::string meta()
{
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nCompressedData = False\nTransformMatrix = 1.0 0 0 0 1.0 "
           "0 0 "
           "0 1.0\nOffset = -36.25 7.75 0.125\nElementSpacing = 0.8 1.5 123.5\nDimSize = 2 2 2\nElementType = "
           "MET_UCHAR\nElementDataFile = LOCAL\n" +
           voxels();
}

std::string vtk()
{
    return "# vtk DataFile Version 3.0\nmask\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nSPACING 0.8 1.5 "
           "123.5\nORIGIN -36.25 7.75 0.125\nPOINT_DATA 8\nSCALARS s float 1\nLOOKUP_TABLE default\n"
           "0.5 1.5 2.5 3.5 4.5 5.5 6.5 7.5\n";
}

}   // namespace

TEST(GermanVolumes, KeepTheirSizesAndPlaces)
{
    const test::TemporaryFolder folder;
    const test::GermanLocale german;
    if (!german.isSet()) {
        GTEST_SKIP() << "locale de_DE.UTF-8 is neither installed nor can it be made (package locales)";
    }
    for (const auto& [name, content] :
         {std::pair{"a.nrrd", nrrd()}, std::pair{"a.mha", meta()}, std::pair{"a.vtk", vtk()}}) {
        SCOPED_TRACE(name);
        const core::VolumeGeometry geometry = test::readBack(folder.write(name, content)).geometry;
        EXPECT_LT((geometry.spacingMm - Eigen::Vector3d(0.8, 1.5, 123.5)).norm(), 1e-9) << geometry.spacingMm;
        EXPECT_LT((geometry.originInPatient - Eigen::Vector3d(-36.25, 7.75, 0.125)).norm(), 1e-9)
            << geometry.originInPatient;
    }
    EXPECT_NEAR(test::readBack(folder.file("a.vtk")).value(7), 7.5, 1e-3);
    EXPECT_TRUE(german.isSet()) << "the program's own locale was changed";
}
