#pragma once

#include "core/imaging/image2d.h"
#include "io/image_file.h"
#include "tests/fuzz/input_file.h"

namespace angiopose::fuzz {

/// Writes a small tree and image that cases and results may reference: in/tree.csv, in/image.png.
inline void writeSmallInputs()
{
    std::filesystem::create_directories(folder() / "in");
    inputFile("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,0,1\n20,1,0,1\n10,0,0,2\n10,8,0,2\n");
    const core::ColorImage picture{16, 12, std::vector<std::uint8_t>(16 * 12 * 3, 90)};
    (void)io::writePng(picture, (folder() / "in/image.png").string());
}

}   // namespace angiopose::fuzz
