#include "io/pose/diffdrr_text.h"

#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace angiopose::io {
namespace {

using DrrJson = nlohmann::ordered_json;

/// Thrown for a key that is missing or of the wrong type.
struct WrongKey {
    std::string key;
};

double lengthAt(const DrrJson& drr, const char* key)
{
    const auto found = drr.find(key);
    if (found == drr.end() || !found->is_number() || !(found->get<double>() > 0.0)) {
        throw WrongKey{key};
    }
    return found->get<double>();
}

int pixelsAt(const DrrJson& drr, const char* key)
{
    const double pixels = lengthAt(drr, key);
    if (pixels > 65535.0 || pixels != std::floor(pixels)) {
        throw WrongKey{key};
    }
    return static_cast<int>(pixels);
}

core::DiffDrrOrientation orientationOf(const DrrJson& drr)
{
    const auto found = drr.find("orientation");
    if (found == drr.end() || *found == "AP") {   // "AP" is the default of DiffDRR
        return core::DiffDrrOrientation::Ap;
    }
    if (*found == "PA") {
        return core::DiffDrrOrientation::Pa;
    }
    if (!found->is_null()) {
        throw WrongKey{"orientation"};
    }
    return core::DiffDrrOrientation::None;
}

core::DiffDrrDetector detectorOf(const DrrJson& drr)
{
    core::DiffDrrDetector detector;
    detector.sddMm = lengthAt(drr, "sdd");
    detector.height = pixelsAt(drr, "height");
    detector.width = drr.contains("width") ? pixelsAt(drr, "width") : detector.height;
    detector.delxMm = lengthAt(drr, "delx");
    detector.delyMm = drr.contains("dely") ? lengthAt(drr, "dely") : detector.delxMm;
    detector.x0Mm = drr.value("x0", 0.0);
    detector.y0Mm = drr.value("y0", 0.0);
    detector.isXReversed = drr.value("reverse_x_axis", true);
    detector.orientation = orientationOf(drr);
    return detector;
}

Eigen::Vector3d vectorOf(const DrrJson& json, const char* key)
{
    const DrrJson& plain = json.is_array() && json.size() == 1 ? json.front() : json;   // unwraps a batch of size one
    const auto values = plain.get<std::vector<double>>();
    if (values.size() != 3) {
        throw WrongKey{key};
    }
    return Eigen::Vector3d(values.data());
}

core::RigidTransform matrixOf(const DrrJson& json, const char* key)
{
    const auto pose = poseFromRows((json.size() == 1 ? json.front() : json).get<MatrixRows>());
    if (!pose) {
        throw WrongKey{key};
    }
    return pose.value();
}

std::optional<core::RigidTransform> poseOf(const DrrJson& root)
{
    for (const char* key : {"pose", "final_pose", "init_pose"}) {
        if (const auto found = root.find(key); found != root.end() && !found->is_null()) {
            return matrixOf(*found, key);
        }
    }
    if (!root.contains("rotation") && !root.contains("translation")) {
        return std::nullopt;
    }
    const std::string axes = root.value("convention", "ZXY");
    if (root.value("parameterization", "euler_angles") != "euler_angles") {
        throw WrongKey{"parameterization"};
    }
    if (axes.size() != 3 || axes.find_first_not_of("XYZ") != std::string::npos) {
        throw WrongKey{"convention"};
    }
    const double unit = root.value("degrees", false) ? std::numbers::pi / 180.0 : 1.0;
    return core::diffDrrPose(axes, unit * vectorOf(root.at("rotation"), "rotation"),
                             vectorOf(root.at("translation"), "translation"));
}

const char* nameOf(core::DiffDrrOrientation orientation)
{
    return orientation == core::DiffDrrOrientation::Ap ? "AP" : "PA";
}

}   // namespace

core::Result<DiffDrrParts> parseDiffDrrJson(std::string_view text, const std::string& path)
{
    if (const auto valid = checkJson(text, path); !valid) {
        return valid.error();
    }
    try {
        const DrrJson root = DrrJson::parse(text);
        const DrrJson& drr = root.contains("drr") ? root.at("drr") : root;
        DiffDrrParts parts;
        parts.pose = poseOf(root);
        if (drr.contains("sdd") || !parts.pose) {
            parts.detector = detectorOf(drr);
        }
        if (root.contains("volume_centre_lps")) {
            parts.volumeCenterInPatient = vectorOf(root.at("volume_centre_lps"), "volume_centre_lps");
        }
        return parts;
    } catch (const WrongKey& wrong) {
        return fileError(path, messages::diffDrrKeys(wrong.key));
    } catch (const DrrJson::exception&) {
        return fileError(path, messages::diffDrrKeys("pose"));
    }
}

core::Result<DiffDrrParts> parseDiffDrrTable(std::string_view text, const std::string& path)
{
    const auto table = parseCsv(text, path);
    if (!table) {
        return table.error();
    }
    core::Vector6d values;
    static constexpr std::array names{"r1", "r2", "r3", "tx", "ty", "tz"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto column = table.value().column(names[i]);
        if (!column || table.value().rows.empty()) {
            return fileError(path, messages::diffDrrKeys(names[i]));
        }
        const auto number = numberInCell(table.value(), table.value().rows.size() - 1, *column);
        if (!number) {
            return number.error();
        }
        values(static_cast<Eigen::Index>(i)) = number.value();
    }
    DiffDrrParts parts;
    parts.pose = core::diffDrrPose("ZXY", values.head<3>(), values.tail<3>());
    return parts;
}

std::string diffDrrText(const core::DiffDrrView& view)
{
    const core::DiffDrrDetector& detector = view.detector;
    const core::Vector6d parameters = core::diffDrrParameters(view.pose);
    const Eigen::Vector3d& center = view.volumeCenterInPatient;
    DrrJson root;
    root["format"] = "diffdrr-view";
    root["drr"] = {{"orientation", nameOf(detector.orientation)},
                   {"sdd", detector.sddMm},
                   {"height", detector.height},
                   {"width", detector.width},
                   {"delx", detector.delxMm},
                   {"dely", detector.delyMm},
                   {"x0", detector.x0Mm},
                   {"y0", detector.y0Mm},
                   {"reverse_x_axis", detector.isXReversed}};
    root["volume_centre_lps"] = {center.x(), center.y(), center.z()};
    root["pose"] = rowsOf(view.pose);
    root["parameterization"] = "euler_angles";
    root["convention"] = "ZXY";
    root["degrees"] = false;
    root["rotation"] = {parameters(0), parameters(1), parameters(2)};
    root["translation"] = {parameters(3), parameters(4), parameters(5)};
    return prettyJson(root.dump());
}

}   // namespace angiopose::io
