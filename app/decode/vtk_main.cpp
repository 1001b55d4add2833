#include "app/decode/helper_session.h"
#include "app/decode/vtk_formats.h"

#include <filesystem>

// angiopose-decode-vtk FORMAT FILE: polydata, unstructured_grid (legacy VTK) or ply. What VTK reads comes as
// io::VtkLines.

int main(int count, char** arguments)
{
    if (count != 3) {
        return 2;
    }
    const std::string format = arguments[1], path = arguments[2];
    std::error_code ignored;
    angiopose::decode::limitProcess(std::filesystem::file_size(path, ignored));
    return angiopose::decode::sayReply([&] {
        return format == "ply" ? angiopose::decode::readPly(path) : angiopose::decode::readLegacyVtk(path, format);
    });
}
