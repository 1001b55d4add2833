#include "io/vessel/fiducial_table.h"

#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <optional>

namespace angiopose::io {
namespace {

/// Columns and coordinate system of a fiducial table.
struct FiducialLayout {
    std::size_t x = 1, label = 11, description = 12;
    bool isRas = true;   // files that state no coordinate system come from older Slicer versions
};

/// Splits a line into cells; quoted cells may contain commas, and a doubled quote stands for one quote.
std::vector<std::string> cellsOf(std::string_view line)
{
    std::vector<std::string> cells(1);
    bool isQuoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool isQuote = line[i] == '"';
        if (isQuote && isQuoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += '"';
            ++i;
        } else if (isQuote) {
            isQuoted = !isQuoted;
        } else if (line[i] == ',' && !isQuoted) {
            cells.emplace_back();
        } else {
            cells.back() += line[i];
        }
    }
    return cells;
}

void readColumns(std::string_view list, FiducialLayout& layout)
{
    const std::vector<std::string> names = cellsOf(list);
    const auto placeOf = [&names](std::string_view name, std::size_t otherwise) {
        const auto found =
            std::ranges::find_if(names, [name](const std::string& each) { return trimmed(each) == name; });
        return found == names.end() ? otherwise : static_cast<std::size_t>(found - names.begin());
    };
    layout.x = placeOf("x", layout.x);
    layout.label = placeOf("label", names.size());
    layout.description = placeOf("desc", names.size());
}

/// Reads a comment line into `layout`; returns the name of an unsupported coordinate system, otherwise nullopt.
std::optional<std::string> readComment(std::string_view line, FiducialLayout& layout)
{
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string value = toLower(trimmed(line.substr(equals + 1)));
    if (line.find("CoordinateSystem") < equals) {
        layout.isRas = value == "0" || value == "ras";
        return layout.isRas || value == "1" || value == "lps" ? std::nullopt : std::optional(value);
    }
    if (line.find("columns") < equals) {
        readColumns(value, layout);
    }
    return std::nullopt;
}

std::optional<Fiducial> pointOf(const std::vector<std::string>& cells, const FiducialLayout& layout)
{
    Fiducial fiducial;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = layout.x + axis < cells.size() ? parseNumber(cells[layout.x + axis]) : std::nullopt;
        if (!number || !(std::abs(*number) < 1e6)) {
            return std::nullopt;
        }
        fiducial.pointInPatient(static_cast<Eigen::Index>(axis)) = *number;
    }
    if (layout.isRas) {
        fiducial.pointInPatient.head<2>() *= -1.0;
    }
    fiducial.name = layout.label < cells.size() ? std::string(trimmed(cells[layout.label])) : std::string();
    fiducial.description =
        layout.description < cells.size() ? std::string(trimmed(cells[layout.description])) : std::string();
    return fiducial;
}

/// Returns the name without line breaks, which would start another point.
std::string cellOf(std::string name)
{
    std::ranges::replace_if(
        name, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return csvCell(name);
}

}   // namespace

core::Result<std::vector<Fiducial>> parseFiducialTable(std::string_view text, const std::string& path)
{
    FiducialLayout layout;
    std::vector<Fiducial> fiducials;
    int number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        ++number;
        if (line.empty()) {
            continue;
        }
        if (line.front() == '#') {
            if (const auto foreign = readComment(line, layout)) {
                return fileError(path, messages::fiducialsSystem(foreign->substr(0, 20)));
            }
            continue;
        }
        const auto fiducial = pointOf(cellsOf(line), layout);
        if (!fiducial) {
            return fileError(path, messages::fiducialsLine(number));
        }
        fiducials.push_back(*fiducial);
    }
    return fiducials.empty() ? core::Result<std::vector<Fiducial>>(fileError(path, messages::fiducialsNone()))
                             : fiducials;
}

std::string fiducialTable(const std::vector<Fiducial>& fiducials)
{
    std::string text =
        "# Markups fiducial file version = 4.11\n"
        "# CoordinateSystem = LPS\n"
        "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
    for (std::size_t i = 0; i < fiducials.size(); ++i) {
        const Eigen::Vector3d& point = fiducials[i].pointInPatient;
        text += std::to_string(i + 1) + "," + toText(point.x()) + "," + toText(point.y()) + "," + toText(point.z()) +
                ",0,0,0,1,1,1,0," + cellOf(fiducials[i].name) + "," + cellOf(fiducials[i].description) + ",\n";
    }
    return text;
}

}   // namespace angiopose::io
