#include "io/evaluation/observer_readings.h"

#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

namespace angiopose::io {
namespace {

/// Accesses the cells of one log row by column name.
class ReadingRow {
public:
    ReadingRow(const CsvTable& table, std::size_t row) : table_(table), row_(row) {}

    core::Result<std::string> text(const std::string& column) const
    {
        const auto index = table_.column(column);
        return index ? core::Result<std::string>(std::string(table_.rows[row_][*index]))
                     : core::Result<std::string>(fileError(table_.path, messages::observerColumnMissing(column)));
    }

    core::Result<double> number(const std::string& column) const
    {
        const auto index = table_.column(column);
        return index ? numberInCell(table_, row_, *index)
                     : core::Result<double>(fileError(table_.path, messages::observerColumnMissing(column)));
    }

    core::Result<core::RigidTransform> pose(const std::string& prefix) const
    {
        core::RigidTransform pose;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                const std::string place = std::to_string(row) + (column < 3 ? std::to_string(column) : "");
                const auto value = number(prefix + (column < 3 ? "_r" : "_t") + place);
                if (!value) {
                    return value.error();
                }
                (column < 3 ? pose.rotation(row, column) : pose.translation(row)) = value.value();
            }
        }
        return pose;
    }

private:
    const CsvTable& table_;
    std::size_t row_;
};

core::Result<core::ObserverReading> parseReading(const ReadingRow& row)
{
    core::ObserverReading reading;
    for (const char* column : {"case", "image_sha256", "frame"}) {
        const auto text = row.text(column);
        if (!text) {
            return text.error();
        }
        reading.image += (reading.image.empty() ? "" : " · ") + text.value();
    }
    const auto observer = row.text("observer");
    const auto found = row.pose("final");
    const auto center = row.pose("centre");
    if (!observer || !found || !center) {
        return !observer ? observer.error() : !found ? found.error() : center.error();
    }
    reading.observer = observer.value();
    reading.cameraFromPatient = found.value();
    reading.referenceCameraFromPatient = center.value();
    for (int axis = 0; axis < 3; ++axis) {
        const auto value = row.number(std::string("pivot_") + "xyz"[axis]);
        if (!value) {
            return value.error();
        }
        reading.pivotInPatient(axis) = value.value();
    }
    return reading;
}

}   // namespace

core::Result<std::vector<core::ObserverReading>> readObserverReadings(const std::string& path)
{
    const auto content = openInput(path);
    if (!content) {
        return content.error();
    }
    const auto table = parseCsv(content.value().view(), path);
    if (!table) {
        return table.error();
    }
    std::vector<core::ObserverReading> readings;
    for (std::size_t k = 0; k < table.value().rows.size(); ++k) {
        const ReadingRow row(table.value(), k);
        const auto outcome = row.text("outcome");
        if (!outcome) {
            return outcome.error();
        }
        if (outcome.value() == "done") {
            auto reading = parseReading(row);
            if (!reading) {
                return reading.error();
            }
            readings.push_back(std::move(reading).value());
        }
    }
    return readings;
}

}   // namespace angiopose::io
