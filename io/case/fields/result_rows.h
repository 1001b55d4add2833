#pragma once

#include "core/registration/registration.h"
#include "io/case/fields/json_values.h"
#include "io/case/fields/stored_field.h"
#include "io/support/message_json.h"
#include "io/support/pose_matrix.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

/// Rows shared by several kinds of results.
namespace angiopose::io {

/// Returns the schema of a number that may be unknown: null represents NaN, which JSON does not support.
inline Json measureSchema()
{
    return {{"type", {"number", "null"}}};
}

inline double measureFrom(const Json& value)
{
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

template <class Owner>
StoredField<Owner> measureField(std::string key, double Owner::*member)
{
    StoredField<Owner> field = valueField(std::move(key), measureSchema(), member);
    field.read = [member](const Json& value, Owner& owner, ReadContext&) { owner.*member = measureFrom(value); };
    return field;
}

template <class Owner>
StoredField<Owner> poseMatrixField(core::RigidTransform Owner::*member)
{
    return {"cameraFromPatient", schemaReference("matrix"),
            [member](const Json& value, Owner& owner, ReadContext& reading) {
                if (const auto pose = poseFromRows(value.get<MatrixRows>())) {
                    owner.*member = pose.value();
                } else {
                    reading.problems.push_back(pose.error().message.about("result"));
                }
            },
            [member](const Owner& owner, const std::filesystem::path&) { return Json(rowsOf(owner.*member)); }};
}

template <class Owner>
StoredField<Owner> stopReasonField(core::StopReason Owner::*member)
{
    using enum core::StopReason;
    static constexpr std::array reasons{Converged, IterationLimit, NoImprovement, StoppedByUser};
    Json schema;
    for (const core::StopReason reason : reasons) {
        schema["enum"].push_back(core::toText(reason));
    }
    return {"stopReason", std::move(schema),
            [member](const Json& value, Owner& owner, ReadContext&) {
                owner.*member = *std::ranges::find(reasons, value.get<std::string>(),
                                                   [](core::StopReason reason) { return core::toText(reason); });
            },
            [member](const Owner& owner, const std::filesystem::path&) { return Json(core::toText(owner.*member)); }};
}

template <class Owner>
StoredField<Owner> messagesField(core::Messages Owner::*member)
{
    return {"messages", about(listSchema(Json{{"type", "object"}}), "The warnings, for programs."),
            [member](const Json& value, Owner& owner, ReadContext&) { owner.*member = parseMessages(value.dump()); },
            [member](const Owner& owner, const std::filesystem::path&) {
                return Json::parse(messagesJson(owner.*member));
            }};
}

}   // namespace angiopose::io
