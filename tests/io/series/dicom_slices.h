#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace angiopose::test {

/// Writes little-endian explicit DICOM data elements byte by byte, sharing no code with the reader under test.
class DicomBytes {
public:
    void text(std::uint16_t group, std::uint16_t element, const char* vr, std::string value)
    {
        value += value.size() % 2 == 1 ? " " : "";
        head(group, element, vr);
        number(static_cast<std::uint16_t>(value.size()));
        bytes_ += value;
    }
    void number(std::uint16_t group, std::uint16_t element, std::uint16_t value)
    {
        head(group, element, "US");
        number(std::uint16_t{2});
        number(value);
    }
    void words(std::uint16_t group, std::uint16_t element, const std::vector<std::int16_t>& values)
    {
        head(group, element, "OW");
        bytes_ += std::string(2, '\0');
        size(2 * values.size());
        bytes_.append(reinterpret_cast<const char*>(values.data()), 2 * values.size());
    }
    void bytes(std::uint16_t group, std::uint16_t element, std::string value)
    {
        value += value.size() % 2 == 1 ? std::string(1, '\0') : "";
        head(group, element, "OB");
        bytes_ += std::string(2, '\0');
        size(value.size());
        bytes_ += value;
    }
    /// Writes a sequence of items, each with its own encoded elements.
    void sequence(std::uint16_t group, std::uint16_t element, const std::vector<std::string>& items)
    {
        std::size_t length = 0;
        for (const std::string& item : items) {
            length += 8 + item.size();
        }
        head(group, element, "SQ");
        bytes_ += std::string(2, '\0');
        size(length);
        for (const std::string& item : items) {
            number(std::uint16_t{0xfffe});
            number(std::uint16_t{0xe000});
            size(item.size());
            bytes_ += item;
        }
    }
    const std::string& content() const { return bytes_; }

private:
    void head(std::uint16_t group, std::uint16_t element, const char* vr)
    {
        number(group);
        number(element);
        bytes_ += vr;
    }
    void size(std::size_t value)
    {
        const auto length = static_cast<std::uint32_t>(value);
        bytes_.append(reinterpret_cast<const char*>(&length), 4);
    }
    void number(std::uint16_t value) { bytes_.append(reinterpret_cast<const char*>(&value), 2); }

    std::string bytes_;
};

struct CtSlice {
    std::string seriesUid = "1.2.3";
    std::string sopInstanceUid;
    std::string patientName = "Phantom^CT", patientId, birthDate, sex, laterality;   ///< empty: attribute absent
    std::string description = "CTA 0.75";
    std::string modality = "CT";
    int instanceNumber = 1;
    std::string acquisition = "1";
    int columns = 8, rows = 9;
    double columnSpacingMm = 0.5, rowSpacingMm = 0.75;
    std::vector<double> orientation = {1, 0, 0, 0, 1, 0};
    std::vector<double> position = {0, 0, 0};
    double slope = 1.0, intercept = -1024.0;
    std::vector<std::int16_t> pixels;   ///< row by row
};

inline std::string joined(const std::vector<double>& values)
{
    std::string text;
    for (const double value : values) {
        char number[32];
        std::snprintf(number, sizeof number, "%.12g", value);
        text += (text.empty() ? "" : "\\") + std::string(number);
    }
    return text;
}

inline std::string ctSlice(const CtSlice& slice)
{
    DicomBytes data;
    data.text(0x0008, 0x0018, "UI", slice.sopInstanceUid);
    data.text(0x0008, 0x0020, "DA", "20260401");
    data.text(0x0008, 0x0060, "CS", slice.modality);
    data.text(0x0008, 0x103e, "LO", slice.description);
    data.text(0x0010, 0x0010, "PN", slice.patientName);
    data.text(0x0010, 0x0020, "LO", slice.patientId);
    data.text(0x0010, 0x0030, "DA", slice.birthDate);
    data.text(0x0010, 0x0040, "CS", slice.sex);
    data.text(0x0020, 0x000d, "UI", "1.2");
    data.text(0x0020, 0x000e, "UI", slice.seriesUid);
    data.text(0x0020, 0x0011, "IS", "4");
    data.text(0x0020, 0x0012, "IS", slice.acquisition);
    data.text(0x0020, 0x0013, "IS", std::to_string(slice.instanceNumber));
    data.text(0x0020, 0x0032, "DS", joined(slice.position));
    data.text(0x0020, 0x0037, "DS", joined(slice.orientation));
    data.text(0x0020, 0x0060, "CS", slice.laterality);
    data.number(0x0028, 0x0002, 1);
    data.text(0x0028, 0x0004, "CS", "MONOCHROME2");
    data.number(0x0028, 0x0010, static_cast<std::uint16_t>(slice.rows));
    data.number(0x0028, 0x0011, static_cast<std::uint16_t>(slice.columns));
    data.text(0x0028, 0x0030, "DS", joined({slice.rowSpacingMm, slice.columnSpacingMm}));
    data.number(0x0028, 0x0100, 16);
    data.number(0x0028, 0x0101, 16);
    data.number(0x0028, 0x0102, 15);
    data.number(0x0028, 0x0103, 1);
    data.text(0x0028, 0x1052, "DS", joined({slice.intercept}));
    data.text(0x0028, 0x1053, "DS", joined({slice.slope}));
    data.words(0x7fe0, 0x0010, slice.pixels);
    return std::string(128, '\0') + "DICM" + data.content();
}

}   // namespace angiopose::test
