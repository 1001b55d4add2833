#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/vessel/legacy_vtk_cells.h"
#include "io/vessel/legacy_vtk_cursor.h"
#include "io/vessel/vtk_lines.h"

#include <algorithm>
#include <cmath>

namespace angiopose::io {
namespace {

std::string upper(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return result;
}

/// Reads the body of one file; each method returns false when the section it reads is damaged.
class LegacyVtkParser {
public:
    explicit LegacyVtkParser(LegacyVtkCursor cursor) : cursor_(cursor) {}

    bool readSections();
    std::string_view section() const { return section_; }
    VtkLines finish() &&
    {
        addCells(std::move(cells_), result_);
        return std::move(result_);
    }

private:
    bool readSection(const std::string& keyword);
    bool readPoints();
    bool readCells(VtkCells& cells);
    bool readOffsetCells(std::size_t offsetCount, std::size_t size, VtkCells& cells);
    bool readCellTypes();
    bool readAttribute(const std::string& keyword);
    bool readScalars();
    bool readField();
    bool readFieldArray();
    void keepArray(const std::string& name, std::vector<double> values);

    enum class Place { DataSet, PointData, CellData };

    LegacyVtkCursor cursor_;
    std::string section_;
    VtkLines result_;
    Place place_ = Place::DataSet;
    std::size_t attributeCount_ = 0;
    LegacyVtkCells cells_;
};

bool LegacyVtkParser::readSections()
{
    while (!cursor_.isAtEnd()) {
        section_ = upper(cursor_.token());
        if (!readSection(section_)) {
            return false;
        }
    }
    return true;
}

bool LegacyVtkParser::readSection(const std::string& keyword)
{
    if (keyword == "POINTS") {
        return readPoints();
    }
    if (keyword == "LINES") {
        return readCells(cells_.lines);
    }
    if (keyword == "VERTICES") {
        return readCells(cells_.vertices);
    }
    if (keyword == "POLYGONS" || keyword == "TRIANGLE_STRIPS") {
        return readCells(keyword == "POLYGONS" ? cells_.polygons : cells_.strips);
    }
    if (keyword == "CELLS") {
        return readCells(cells_.mixed);
    }
    if (keyword == "CELL_TYPES") {
        return readCellTypes();
    }
    if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
        place_ = keyword == "POINT_DATA" ? Place::PointData : Place::CellData;
        const auto count = cursor_.count();
        attributeCount_ = count.value_or(0);
        return count.has_value();
    }
    if (keyword == "METADATA") {
        cursor_.skipParagraph();
        return true;
    }
    return readAttribute(keyword);
}

bool LegacyVtkParser::readPoints()
{
    const auto count = cursor_.count();
    const std::string type(cursor_.token());
    const auto values = count ? cursor_.numbers(3 * *count, type) : std::nullopt;
    if (!values) {
        return false;
    }
    for (std::size_t i = 0; i < *count; ++i) {
        result_.set.points.emplace_back((*values)[3 * i], (*values)[3 * i + 1], (*values)[3 * i + 2]);
    }
    return true;
}

bool LegacyVtkParser::readCells(VtkCells& cells)
{
    const auto count = cursor_.count();
    const auto size = cursor_.count();
    if (!count || !size) {
        return false;
    }
    if (upper(cursor_.peekToken()) == "OFFSETS") {
        return readOffsetCells(*count, *size, cells);
    }
    const auto values = cursor_.numbers(*size, "int");
    if (!values) {
        return false;
    }
    for (std::size_t at = 0; at < values->size();) {
        const double length = (*values)[at];
        if (!(length >= 0.0) || length > static_cast<double>(values->size() - at - 1)) {
            return false;
        }
        const std::size_t end = at + 1 + static_cast<std::size_t>(length);
        if (!appendCell(*values, at + 1, end, cells)) {
            return false;
        }
        at = end;
    }
    return cells.size() == *count;
}

/// Format 5: offsets and connectivity as two arrays.
bool LegacyVtkParser::readOffsetCells(std::size_t offsetCount, std::size_t size, VtkCells& cells)
{
    cursor_.token();
    const std::string offsetType(cursor_.token());
    const auto offsets = cursor_.numbers(offsetCount, offsetType);
    if (!offsets || upper(cursor_.token()) != "CONNECTIVITY") {
        return false;
    }
    const std::string type(cursor_.token());
    const auto values = cursor_.numbers(size, type);
    if (!values) {
        return false;
    }
    for (std::size_t i = 0; i + 1 < offsets->size(); ++i) {
        const double from = (*offsets)[i];
        const double to = (*offsets)[i + 1];
        if (!(from >= 0.0) || !(to >= from) || to > static_cast<double>(size) ||
            !appendCell(*values, static_cast<std::size_t>(from), static_cast<std::size_t>(to), cells)) {
            return false;
        }
    }
    return true;
}

bool LegacyVtkParser::readCellTypes()
{
    const auto count = cursor_.count();
    auto values = count ? cursor_.numbers(*count, "int") : std::nullopt;
    if (!values || values->size() != cells_.mixed.size()) {
        return false;
    }
    cells_.types = std::move(*values);
    return true;
}

bool LegacyVtkParser::readAttribute(const std::string& keyword)
{
    if (keyword == "SCALARS") {
        return readScalars();
    }
    if (keyword == "FIELD") {
        return readField();
    }
    const std::string name(cursor_.token());
    if (keyword == "VECTORS" || keyword == "NORMALS" || keyword == "TENSORS") {
        const std::string type(cursor_.token());
        return cursor_.skipNumbers((keyword == "TENSORS" ? 9 : 3) * attributeCount_, type);
    }
    if (keyword == "COLOR_SCALARS" || keyword == "TEXTURE_COORDINATES" || keyword == "LOOKUP_TABLE") {
        const auto components = cursor_.count();
        const bool isTable = keyword == "LOOKUP_TABLE";
        const std::string type(keyword == "TEXTURE_COORDINATES" ? cursor_.token() : std::string_view("unsigned_char"));
        return components && *components < 1'000'000 &&
               cursor_.skipNumbers(isTable ? 4 * *components : *components * attributeCount_, type);
    }
    return false;
}

bool LegacyVtkParser::readScalars()
{
    const std::string name(cursor_.token());
    const std::string type(cursor_.token());
    std::size_t components = 1;
    if (const auto given = parseInteger(cursor_.peekToken())) {
        components = *given > 0 && *given < 100 ? static_cast<std::size_t>(*given) : 0;
        cursor_.token();
    }
    if (components == 0 || upper(cursor_.token()) != "LOOKUP_TABLE") {
        return false;
    }
    cursor_.token();
    auto values = cursor_.numbers(components * attributeCount_, type);
    if (values && components == 1) {
        keepArray(name, std::move(*values));
    }
    return values.has_value();
}

bool LegacyVtkParser::readField()
{
    cursor_.token();   // the field's own name
    const auto arrays = cursor_.count();
    for (std::size_t i = 0; arrays && i < *arrays; ++i) {
        while (upper(cursor_.peekToken()) == "METADATA") {
            cursor_.skipParagraph();
        }
        if (cursor_.isAtEnd() || !readFieldArray()) {
            return false;
        }
    }
    return arrays.has_value();
}

bool LegacyVtkParser::readFieldArray()
{
    const std::string name(cursor_.token());
    const auto components = cursor_.count();
    const auto tuples = cursor_.count();
    const std::string type(cursor_.token());
    if (!components || !tuples || *components > 1000) {
        return false;
    }
    if (type == "string") {
        const auto texts = cursor_.strings(*components * *tuples);
        const bool isSpace = texts && !texts->empty() && place_ == Place::DataSet && upper(name).starts_with("SPACE");
        result_.set.isRas |= isSpace && upper(texts->front()).find("RAS") != std::string::npos;
        return texts.has_value();
    }
    auto values = cursor_.numbers(*components * *tuples, type);
    if (values && *components == 1) {
        keepArray(name, std::move(*values));
    }
    return values.has_value();
}

void LegacyVtkParser::keepArray(const std::string& name, std::vector<double> values)
{
    if (place_ == Place::PointData) {
        result_.pointArrays.emplace(name, std::move(values));
    } else if (place_ == Place::CellData) {
        result_.cellArrays.emplace(name, std::move(values));
    }
}

}   // namespace

core::Result<VtkLines> parseLegacyVtk(std::string_view content, const std::string& path)
{
    LegacyVtkCursor cursor(content);
    cursor.line();
    const std::string title = upper(cursor.line());
    const std::string format = upper(cursor.token());
    if (format != "ASCII" && format != "BINARY") {
        return fileError(path, says::vtkThirdLine());
    }
    if (format == "BINARY") {
        cursor.setBinary();
    }
    const bool hasDataSet = upper(cursor.token()) == "DATASET";
    const std::string kind = upper(cursor.token());
    if (!hasDataSet || (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")) {
        return fileError(path, kind.empty() ? says::vtkNoDataSet() : says::vtkOtherDataSet(kind.substr(0, 40)));
    }
    LegacyVtkParser parser(cursor);
    if (!parser.readSections()) {
        return fileError(path, says::vtkSectionDamaged(parser.section().substr(0, 40)));
    }
    VtkLines lines = std::move(parser).finish();
    lines.set.isRas |= title.find("SPACE=RAS") != std::string::npos;
    return lines;
}

}   // namespace angiopose::io