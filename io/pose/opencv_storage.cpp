#include "io/pose/opencv_storage.h"

#include "core/exchange/projection_matrix.h"
#include "io/support/csv_table.h"
#include "io/support/json_text.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

constexpr std::size_t maxNumbers = 4096;
constexpr std::string_view betweenNumbers = " \t\r\n,;[]";

/// Appends the numbers in a string; returns false at the first word that is no number. Skips the dashes of YAML lists.
bool appendTo(std::vector<double>& numbers, std::string_view part)
{
    while (true) {
        part.remove_prefix(std::min(part.find_first_not_of(betweenNumbers), part.size()));
        if (part.empty()) {
            return true;
        }
        const std::string_view word = part.substr(0, part.find_first_of(betweenNumbers));
        part.remove_prefix(word.size());
        if (word == "-") {
            continue;
        }
        const auto number = parseNumber(word);
        if (!number || numbers.size() >= maxNumbers) {
            return false;
        }
        numbers.push_back(*number);
    }
}

/// Returns the number of opening minus closing square brackets.
std::ptrdiff_t openedBrackets(std::string_view line)
{
    return std::ranges::count(line, '[') - std::ranges::count(line, ']');
}

std::string_view afterColon(std::string_view line, std::size_t colon)
{
    std::string_view rest = trimmed(line.substr(colon + 1));
    if (rest.starts_with("!!")) {   // skip the YAML type tag
        rest = trimmed(rest.substr(std::min(rest.find(' '), rest.size())));
    }
    return rest;
}

std::string joined(const double* values, std::size_t count, std::string_view between)
{
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += (i == 0 ? std::string() : std::string(between)) + toText(values[i]);
    }
    return text;
}

using Rows3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Matrix of a camera or pose to write; the files keep the order of these matrices.
struct StoredMatrix {
    const char* name;
    int rows, columns;
    std::vector<double> values;
};

std::array<StoredMatrix, 3> storedMatrices(const core::PosedCamera& posedCamera)
{
    const Rows3 K = core::intrinsicMatrix(posedCamera.camera), R = posedCamera.cameraFromPatient.rotation;
    const Eigen::Vector3d& t = posedCamera.cameraFromPatient.translation;
    return {StoredMatrix{"K", 3, 3, {K.data(), K.data() + 9}}, StoredMatrix{"R", 3, 3, {R.data(), R.data() + 9}},
            StoredMatrix{"t", 3, 1, {t.data(), t.data() + 3}}};
}

}   // namespace

NamedMatrices parseYamlMatrices(std::string_view text)
{
    NamedMatrices matrices;
    std::string name;
    std::ptrdiff_t depth = 0;   // number of open brackets; above 0, the list continues on the next line
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view raw = text.substr(begin, end - begin);
        begin = end + 1;
        const std::string_view line = trimmed(raw);
        if (line.empty() || line.front() == '#' || line.front() == '%' || line.starts_with("---")) {
            continue;
        }
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) {
            if (!name.empty() && (depth > 0 || line.starts_with("- "))) {
                appendTo(matrices[name], line);
                depth = std::max<std::ptrdiff_t>(0, depth + openedBrackets(line));
            }
            continue;
        }
        const std::string key(trimmed(line.substr(0, colon)));
        const bool isTop = raw.front() != ' ' && raw.front() != '\t';
        const std::string_view rest = afterColon(line, colon);
        depth = 0;
        if (isTop) {
            name = key;
        }
        const bool isList = rest.starts_with('[');
        if ((!isTop && key != "data") || (!isList && !parseNumber(rest)) || matrices.size() > maxNumbers) {
            continue;
        }
        std::vector<double>& values = matrices[name];
        values.clear();
        appendTo(values, rest);
        depth = std::max<std::ptrdiff_t>(0, openedBrackets(rest));
    }
    return matrices;
}

NamedMatrices parseXmlMatrices(std::string_view text)
{
    NamedMatrices matrices;
    std::string name;
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos) {
            break;
        }
        const std::string_view tag = text.substr(at + 1, end - at - 1);
        const std::string_view word = tag.substr(0, tag.find_first_of(" \t\r\n"));
        if (word.empty() || word.front() == '/' || word.front() == '?' || word.front() == '!' || word == "rows" ||
            word == "cols" || word == "dt" || word == "opencv_storage") {
            continue;
        }
        if (word != "data") {
            name = word;
        }
        const std::string_view content = text.substr(end + 1, std::min(text.find('<', end), text.size()) - end - 1);
        std::vector<double> values;
        if (appendTo(values, content) && !values.empty()) {
            matrices[name] = std::move(values);
        }
    }
    return matrices;
}

std::string openCvYaml(const core::PosedCamera& posedCamera)
{
    std::string text = "%YAML:1.0\n---\nimage_width: " + std::to_string(posedCamera.camera.width) +
                       "\nimage_height: " + std::to_string(posedCamera.camera.height) + "\n";
    for (const StoredMatrix& matrix : storedMatrices(posedCamera)) {
        text += std::string(matrix.name) + ": !!opencv-matrix\n   rows: " + std::to_string(matrix.rows) +
                "\n   cols: " + std::to_string(matrix.columns) + "\n   dt: d\n   data: [ " +
                joined(matrix.values.data(), matrix.values.size(), ", ") + " ]\n";
    }
    return text;
}

std::string openCvXml(const core::PosedCamera& posedCamera)
{
    std::string text = "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>" +
                       std::to_string(posedCamera.camera.width) + "</image_width>\n<image_height>" +
                       std::to_string(posedCamera.camera.height) + "</image_height>\n";
    for (const StoredMatrix& matrix : storedMatrices(posedCamera)) {
        const std::string name = matrix.name;
        text += "<" + name + " type_id=\"opencv-matrix\">\n  <rows>" + std::to_string(matrix.rows) +
                "</rows>\n  <cols>" + std::to_string(matrix.columns) + "</cols>\n  <dt>d</dt>\n  <data>\n    " +
                joined(matrix.values.data(), matrix.values.size(), " ") + "</data></" + name + ">\n";
    }
    return text + "</opencv_storage>\n";
}

std::string openCvJson(const core::PosedCamera& posedCamera)
{
    nlohmann::ordered_json root{{"image_width", posedCamera.camera.width}, {"image_height", posedCamera.camera.height}};
    const Rows3 K = core::intrinsicMatrix(posedCamera.camera), R = posedCamera.cameraFromPatient.rotation;
    for (const auto& [name, matrix] : {std::pair<const char*, const Rows3*>{"K", &K}, {"R", &R}}) {
        for (int row = 0; row < 3; ++row) {
            root[name].push_back({(*matrix)(row, 0), (*matrix)(row, 1), (*matrix)(row, 2)});
        }
    }
    const Eigen::Vector3d& t = posedCamera.cameraFromPatient.translation;
    root["t"] = {t.x(), t.y(), t.z()};
    return prettyJson(root.dump());
}

std::string projectionText(const core::PosedCamera& posedCamera)
{
    const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> P = core::projectionMatrix(posedCamera);
    std::string text = "# P = K [R t]: patient LPS mm to px; (0, 0) is the center of the first pixel\n";
    for (int row = 0; row < 3; ++row) {
        text += joined(P.row(row).data(), 4, " ") + "\n";
    }
    return text;
}

std::vector<double> parseNumbers(std::string_view text)
{
    std::vector<double> numbers;
    for (LineReader lines(text); lines.next();) {
        if (!appendTo(numbers, lines.line().substr(0, lines.line().find('#')))) {
            return {};
        }
    }
    return numbers;
}

}   // namespace angiopose::io
