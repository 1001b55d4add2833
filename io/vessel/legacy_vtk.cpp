#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
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

/// Appends the cell of `length` point ids from `values[first]` on; false when they are not all there, or no ids.
bool appendCell(const std::vector<double>& values, double first, double length, VtkCells& cells)
{
    if (!(first >= 0.0 && length >= 0.0 && first + length <= static_cast<double>(values.size()))) {
        return false;
    }
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(length);
    if (!std::all_of(begin, end, [](double id) { return id >= 0.0 && id <= 1e12; })) {
        return false;
    }
    cells.emplace_back(begin, end);
    return true;
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
    VtkCellSections cells_;
};

bool LegacyVtkParser::readSections()
{
    while (!cursor_.isAtEnd()) {
        section_ = upper(cursor_.word());
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
    static const std::map<std::string, VtkCells VtkCellSections::*> cellSections = {
        {"LINES", &VtkCellSections::lines},
        {"POLYGONS", &VtkCellSections::polygons},
        {"TRIANGLE_STRIPS", &VtkCellSections::strips},
        {"CELLS", &VtkCellSections::mixed}};
    if (const auto found = cellSections.find(keyword); found != cellSections.end()) {
        return readCells(cells_.*found->second);
    }
    if (keyword == "VERTICES") {
        VtkCells vertices;
        const bool isRead = readCells(vertices);
        cells_.vertexCount = vertices.size();
        return isRead;
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
    const auto values = count ? cursor_.numbers(3 * *count, cursor_.word()) : std::nullopt;
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
    if (upper(cursor_.peekWord()) == "OFFSETS") {
        return readOffsetCells(*count, *size, cells);
    }
    const auto values = cursor_.numbers(*size, "int");
    if (!values) {
        return false;
    }
    for (std::size_t at = 0; at < values->size(); at += 1 + cells.back().size()) {
        if (!appendCell(*values, static_cast<double>(at + 1), (*values)[at], cells)) {
            return false;
        }
    }
    return cells.size() == *count;
}

/// Format 5: offsets and connectivity as two arrays.
bool LegacyVtkParser::readOffsetCells(std::size_t offsetCount, std::size_t size, VtkCells& cells)
{
    cursor_.word();
    const auto offsets = cursor_.numbers(offsetCount, cursor_.word());
    if (!offsets || upper(cursor_.word()) != "CONNECTIVITY") {
        return false;
    }
    const auto values = cursor_.numbers(size, cursor_.word());
    if (!values) {
        return false;
    }
    for (std::size_t i = 0; i + 1 < offsets->size(); ++i) {
        if (!appendCell(*values, (*offsets)[i], (*offsets)[i + 1] - (*offsets)[i], cells)) {
            return false;
        }
    }
    return true;
}

bool LegacyVtkParser::readCellTypes()
{
    const auto count = cursor_.count();
    const auto values = count ? cursor_.numbers(*count, "int") : std::nullopt;
    if (!values || values->size() != cells_.mixed.size()) {
        return false;
    }
    for (const double type : *values) {
        cells_.types.push_back(type >= 0.0 && type < 256.0 ? static_cast<int>(type) : 0);
    }
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
    const std::string name(cursor_.word());
    if (keyword == "VECTORS" || keyword == "NORMALS" || keyword == "TENSORS") {
        return cursor_.numbers((keyword == "TENSORS" ? 9 : 3) * attributeCount_, cursor_.word()).has_value();
    }
    if (keyword == "COLOR_SCALARS" || keyword == "TEXTURE_COORDINATES" || keyword == "LOOKUP_TABLE") {
        const auto components = cursor_.count();
        const bool isTable = keyword == "LOOKUP_TABLE";
        const std::string type(keyword == "TEXTURE_COORDINATES" ? cursor_.word() : std::string_view("unsigned_char"));
        return components && *components < 1'000'000 &&
               cursor_.numbers(isTable ? 4 * *components : *components * attributeCount_, type).has_value();
    }
    return false;
}

bool LegacyVtkParser::readScalars()
{
    const std::string name(cursor_.word());
    const std::string type(cursor_.word());
    std::size_t components = 1;
    if (const auto given = parseInteger(cursor_.peekWord())) {
        components = *given > 0 && *given < 100 ? static_cast<std::size_t>(*given) : 0;
        cursor_.word();
    }
    if (components == 0 || upper(cursor_.word()) != "LOOKUP_TABLE") {
        return false;
    }
    cursor_.word();
    auto values = cursor_.numbers(components * attributeCount_, type);
    if (values && components == 1) {
        keepArray(name, std::move(*values));
    }
    return values.has_value();
}

bool LegacyVtkParser::readField()
{
    cursor_.word();   // the field's own name
    const auto arrays = cursor_.count();
    for (std::size_t i = 0; arrays && i < *arrays; ++i) {
        while (upper(cursor_.peekWord()) == "METADATA") {
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
    const std::string name(cursor_.word());
    const auto components = cursor_.count();
    const auto tuples = cursor_.count();
    const std::string type(cursor_.word());
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
    const std::string format = upper(cursor.word());
    if (format != "ASCII" && format != "BINARY") {
        return fileError(path, says::vtkThirdLine());
    }
    cursor.setCoding(format == "BINARY" ? Coding::BigEndian : Coding::Text);
    const bool hasDataSet = upper(cursor.word()) == "DATASET";
    const std::string kind = upper(cursor.word());
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