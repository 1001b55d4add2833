#pragma once

#include "io/decode/decoder_reply.h"

#include <string>

namespace angiopose::decode {

/// Reads a legacy VTK file with the given data set type ("polydata" or "unstructured_grid"); a refusal names the
/// damaged section.
io::DecoderReply readLegacyVtk(const std::string& path, const std::string& dataSet);

/// Reads a VTK XML file ("xml_polydata" or "xml_unstructured_grid"); a refusal has no details.
io::DecoderReply readXmlVtk(const std::string& path, const std::string& dataSet);

/// Reads a PLY surface; a refusal contains "header", "element NAME" (an element without properties) or "data".
io::DecoderReply readPly(const std::string& path);

}   // namespace angiopose::decode
