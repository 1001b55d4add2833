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
StoredField<Owner> storedMeasure(std::string key, double Owner::*member)
{
    StoredField<Owner> field = storedValue(std::move(key), measureSchema(), member);
    field.read = [member](const Json& value, Owner& owner, Reading&) { owner.*member = measureFrom(value); };
    return field;
}

template <class Owner>
StoredField<Owner> storedPose(core::RigidTransform Owner::*member)
{
    return {"cameraFromPatient", definedAs("matrix"),
            [member](const Json& value, Owner& owner, Reading& reading) {
                if (const auto pose = poseFromRows(value.get<MatrixRows>())) {
                    owner.*member = pose.value();
                } else {
                    reading.problems.push_back(pose.error().message.about("result"));
                }
            },
            [member](const Owner& owner, const std::filesystem::path&) { return Json(rowsOf(owner.*member)); }};
}

template <class Owner>
StoredField<Owner> storedReason(core::StopReason Owner::*member)
{
    using enum core::StopReason;
    static constexpr std::array reasons{Converged, IterationLimit, NoImprovement, StoppedByUser};
    Json schema;
    for (const core::StopReason reason : reasons) {
        schema["enum"].push_back(core::toText(reason));
    }
    return {"stopReason", std::move(schema),
            [member](const Json& value, Owner& owner, Reading&) {
                owner.*member = *std::ranges::find(reasons, value.get<std::string>(),
                                                   [](core::StopReason reason) { return core::toText(reason); });
            },
            [member](const Owner& owner, const std::filesystem::path&) { return Json(core::toText(owner.*member)); }};
}

template <class Owner>
StoredField<Owner> storedMessages(core::Messages Owner::*member)
{
    return {"messages", about(listSchema(Json{{"type", "object"}}), "The warnings, for programs."),
            [member](const Json& value, Owner& owner, Reading&) { owner.*member = messagesFrom(value.dump()); },
            [member](const Owner& owner, const std::filesystem::path&) {
                return Json::parse(messagesJson(owner.*member));
            }};
}

}   // namespace angiopose::io
