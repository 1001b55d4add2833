#pragma once

#include "tests/io/series/dicom_slices.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace angiopose::test {

/// A run of two frames with an identifier, PLANTEDnn, in every location where one was ever found: 67 of them.
class PlantedRun {
public:
    static constexpr int columns = 256;
    static constexpr int rows = 192;

    /// Content of the file; `pixels` have 12 bits, and the four bits above them hold letters of another identifier.
    std::string content(const std::vector<std::int16_t>& pixels)
    {
        std::string file = planted();
        file.resize(128);
        file += "DICM";
        DicomBytes meta;
        meta.text(0x0002, 0x0002, "UI", "1.2.840.10008.5.1.4.1.1.12.1");
        meta.text(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.1");
        meta.text(0x0002, 0x0016, "AE", planted());
        meta.text(0x0002, 0x0100, "UI", "1.2.3.4");
        meta.bytes(0x0002, 0x0102, planted());
        file += meta.content() + head() + relation() + image(pixels);
        return file;
    }

    int count() const { return count_; }

private:
    std::string planted()
    {
        std::array<char, 16> text{};
        std::snprintf(text.data(), text.size(), "PLANTED%02d", count_++);
        return text.data();
    }

    std::string head()
    {
        DicomBytes data;
        data.text(0x0008, 0x0005, "CS", "ISO_IR 100");
        data.text(0x0008, 0x0008, "CS", "ORIGINAL\\PRIMARY\\SINGLE PLANE");
        data.text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.12.1");
        data.text(0x0008, 0x0018, "UI", "1.2.3.777.18");
        data.text(0x0008, 0x0020, "DA", "20250314");
        data.text(0x0008, 0x0022, "DA", "20250315");
        data.text(0x0008, 0x002a, "DT", "20250315101112.5");
        data.text(0x0008, 0x0030, "TM", "101112");
        data.text(0x0008, 0x0050, "SH", planted());
        data.text(0x0008, 0x0060, "CS", "XA");
        data.text(0x0008, 0x0070, "LO", "Maker of arms");
        for (const auto& [element, vr] : std::vector<std::pair<std::uint16_t, const char*>>{{0x0080, "LO"},
                                                                                            {0x0081, "ST"},
                                                                                            {0x0090, "PN"},
                                                                                            {0x0092, "ST"},
                                                                                            {0x0094, "SH"},
                                                                                            {0x009c, "PN"},
                                                                                            {0x0201, "SH"},
                                                                                            {0x1010, "SH"},
                                                                                            {0x1030, "LO"},
                                                                                            {0x103e, "LO"},
                                                                                            {0x1040, "LO"},
                                                                                            {0x1048, "PN"},
                                                                                            {0x1050, "PN"},
                                                                                            {0x1060, "PN"},
                                                                                            {0x1070, "PN"},
                                                                                            {0x1080, "LO"}}) {
            data.text(0x0008, element, vr, planted());
        }
        data.sequence(0x0008, 0x1110, {nested(0x0008, 0x1155, "UI", "1.2.3.777.1110")});
        data.sequence(0x0008, 0x1140, {nested(0x0008, 0x1155, "UI", "1.2.3.777.1140")});
        data.text(0x0008, 0x2111, "ST", planted());
        data.sequence(0x0008, 0x2218, {nested(0x0008, 0x0104, "LO", planted())});
        data.text(0x0009, 0x0010, "LO", planted());
        data.text(0x0009, 0x1001, "LO", planted());
        data.text(0x0010, 0x0010, "PN", planted() + "^JANE");
        data.text(0x0010, 0x0020, "LO", "4711-0815");
        data.text(0x0010, 0x0021, "LO", planted());
        data.text(0x0010, 0x0030, "DA", "19500102");
        data.text(0x0010, 0x0040, "CS", "F");
        for (const int element : {0x1000, 0x1001, 0x1005, 0x1040, 0x1060, 0x2154, 0x2160, 0x2180, 0x4000}) {
            data.text(0x0010, static_cast<std::uint16_t>(element), element == 0x1000 ? "LO" : "LT", planted());
        }
        data.text(0x0018, 0x0010, "LO", planted());
        data.text(0x0018, 0x0015, "CS", "JANE");   // the patient's name in place of a code
        data.text(0x0018, 0x1000, "LO", planted());
        data.text(0x0018, 0x1012, "DA", "20250314");
        data.text(0x0018, 0x1030, "LO", planted());
        data.text(0x0018, 0x1063, "DS", "66.6");
        data.text(0x0018, 0x1110, "DS", "1000");
        data.text(0x0018, 0x1111, "DS", planted());   // not a number
        data.text(0x0018, 0x1164, "DS", "0.2\\0.2");
        data.text(0x0018, 0x1400, "LO", planted());
        data.text(0x0018, 0x1510, "DS", "-30.5");
        data.text(0x0018, 0x4000, "LT", planted());
        data.sequence(0x0018, 0x9506, {nested(0x0008, 0x0080, "LO", planted())});
        return data.content();
    }

    std::string relation()
    {
        DicomBytes data;
        data.text(0x0020, 0x000d, "UI", "1.2.3.777.13");
        data.text(0x0020, 0x000e, "UI", "1.2.3.777.14");
        data.text(0x0020, 0x0010, "SH", planted());
        data.text(0x0020, 0x0013, "IS", "7");
        data.text(0x0020, 0x0020, "CS", "L\\F");
        data.text(0x0020, 0x4000, "LT", planted());
        return data.content();
    }

    std::string image(const std::vector<std::int16_t>& pixels)
    {
        DicomBytes data;
        data.number(0x0028, 0x0002, 1);
        data.text(0x0028, 0x0004, "CS", "MONOCHROME2");
        data.text(0x0028, 0x0008, "IS", "2");
        data.number(0x0028, 0x0010, rows);
        data.number(0x0028, 0x0011, columns);
        data.number(0x0028, 0x0100, 16);
        data.number(0x0028, 0x0101, 12);
        data.number(0x0028, 0x0102, 11);
        data.number(0x0028, 0x0103, 0);
        data.text(0x0028, 0x1055, "LO", planted());
        data.sequence(0x0028, 0x6100, {maskItem()});
        for (const auto& [group, element] : std::vector<std::pair<std::uint16_t, std::uint16_t>>{{0x0032, 0x1032},
                                                                                                 {0x0032, 0x1060},
                                                                                                 {0x0032, 0x4000},
                                                                                                 {0x0038, 0x0010},
                                                                                                 {0x0038, 0x0300},
                                                                                                 {0x0038, 0x4000},
                                                                                                 {0x0040, 0x0006},
                                                                                                 {0x0040, 0x0241},
                                                                                                 {0x0040, 0x0253},
                                                                                                 {0x0040, 0x0254},
                                                                                                 {0x0040, 0x1001},
                                                                                                 {0x0040, 0xa123},
                                                                                                 {0x0088, 0x0904},
                                                                                                 {0x4008, 0x0042}}) {
            data.text(group, element, "LO", planted());
        }
        data.bytes(0x5000, 0x3000, planted());
        data.text(0x5000, 0x2500, "LO", planted());
        data.bytes(0x6000, 0x3000, planted());
        data.text(0x6000, 0x1500, "LO", planted());
        const std::string letters = planted();
        std::vector<std::int16_t> stored = pixels;
        for (std::size_t n = 0; n < stored.size(); ++n) {   // half of a letter in the bits above the twelve
            const auto half = static_cast<unsigned>(letters[n / 2 % letters.size()]) >> (n % 2 == 0 ? 4U : 0U) & 15U;
            stored[n] = static_cast<std::int16_t>(static_cast<unsigned>(stored[n]) | half << 12U);
        }
        data.words(0x7fe0, 0x0010, stored);
        data.bytes(0xfffc, 0xfffc, planted());
        return data.content();
    }

    std::string maskItem()
    {
        DicomBytes data;
        data.text(0x0028, 0x6101, "CS", "AVG_SUB");
        data.text(0x0028, 0x6190, "ST", planted());
        return data.content();
    }

    static std::string nested(std::uint16_t group, std::uint16_t element, const char* vr, const std::string& value)
    {
        DicomBytes data;
        data.text(group, element, vr, value);
        return data.content();
    }

    int count_ = 1;
};

}   // namespace angiopose::test
