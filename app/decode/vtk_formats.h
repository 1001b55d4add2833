#pragma once

#include "io/decode/decoder_reply.h"

#include <string>

namespace angiopose::decode {

/// A legacy VTK file of that data set ("polydata" or "unstructured_grid"); a refusal names the section that is damaged.
io::DecoderReply readLegacyVtk(const std::string& path, const std::string& dataSet);

/// VTK XML ("xml_polydata" or "xml_unstructured_grid"); a refusal says nothing more.
io::DecoderReply readXmlVtk(const std::string& path, const std::string& dataSet);

/// A surface in PLY; a refusal says "header", "element NAME" (it has no properties) or "data".
io::DecoderReply readPly(const std::string& path);

}   // namespace angiopose::decode
