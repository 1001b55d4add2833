#include "app/decode/vtk_formats.h"
#include "app/decode/vtk_reading.h"
#include "io/decode/vtk_lines_reply.h"
#include "io/vessel/parse_xml_vtk.h"

namespace angiopose::decode {

using io::DecoderReply;
using io::ReplyKind;

DecoderReply readXmlVtk(const std::string& path, const std::string& dataSet)
{
    const auto kind = dataSet == "xml_polydata" ? io::XmlVtkKind::PolyData : io::XmlVtkKind::UnstructuredGrid;
    const auto lines = io::parseXmlVtk(contentOf(path), kind);
    return lines ? DecoderReply{ReplyKind::Result, io::toReply(*lines)} : DecoderReply{ReplyKind::Refusal, {}};
}

}   // namespace angiopose::decode
