#pragma once

#include "io/decode/decoder_reply.h"
#include "io/vessel/vtk_lines.h"

namespace angiopose::io {

/// Visits the members that are sent through the pipe, in the order of transmission.
template <class Lines, class Use>
void visitFields(Lines& lines, const Use& use)
{
    use(lines.set.points);
    use(lines.set.lines);
    use(lines.set.hasSurface);
    use(lines.cellOfLine);
    use(lines.pointArrays);
    use(lines.cellArrays);
    use(lines.cellNames);
    use(lines.header);
    use(lines.triangles);
}

inline std::string toReply(const VtkLines& lines)
{
    ReplyWriter writer;
    visitFields(lines, [&writer](const auto& field) { writer.put(field); });
    return std::move(writer).bytes();
}

/// Decodes the reply; returns nullopt if the reply is incomplete.
inline std::optional<VtkLines> linesFromReply(std::string_view bytes)
{
    VtkLines lines;
    ReplyReader reader(bytes);
    visitFields(lines, [&reader](auto& field) { reader.take(field); });
    return reader.isDone() ? std::optional(std::move(lines)) : std::nullopt;
}

}   // namespace angiopose::io
