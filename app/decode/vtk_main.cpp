#include "app/decode/helper_session.h"
#include "app/decode/vtk_formats.h"

#include <filesystem>

// angiopose-decode-vtk FORMAT FILE reads a file of the format polydata, unstructured_grid (legacy VTK), xml_polydata,
// xml_unstructured_grid or ply, and replies with io::VtkLines.

namespace {

angiopose::io::DecoderReply decoded(const std::string& path, const std::string& format)
{
    if (format == "ply") {
        return angiopose::decode::readPly(path);
    }
    return format.starts_with("xml_") ? angiopose::decode::readXmlVtk(path, format)
                                      : angiopose::decode::readLegacyVtk(path, format);
}

}   // namespace

int main(int count, char** arguments)
{
    if (count != 3) {
        return 2;
    }
    const std::string format = arguments[1], path = arguments[2];
    std::error_code ignored;
    angiopose::decode::limitProcess(std::filesystem::file_size(path, ignored));
    return angiopose::decode::writeReply([&] { return decoded(path, format); });
}
