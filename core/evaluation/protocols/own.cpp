#include "core/evaluation/protocols/protocol_rows.h"

namespace angiopose::core {

Protocol ownProtocol()
{
    return {"own",
            "Cases of one's own, listed in a table with their reference poses, landmarks or pairs of points.",
            0,
            1,
            Success::RayDistanceWithin2Mm,
            {},
            nullptr};
}

}   // namespace angiopose::core
