#include "io/angle_map_table.h"

#include "io/support/atomic_file.h"
#include "io/support/numbers.h"

namespace angiopose::io {

core::Status writeAngleMap(const core::AngleMap& map, const std::string& path)
{
    std::string table = "primary_deg,secondary_deg,foreshortening,overlap\n";
    for (std::size_t row = 0; row < map.secondaryDeg.size(); ++row) {
        for (std::size_t column = 0; column < map.primaryDeg.size(); ++column) {
            const core::ViewQuality& quality = map.at(column, row);
            table += toText(map.primaryDeg[column]) + "," + toText(map.secondaryDeg[row]) + "," +
                     toText(quality.foreshortening) + "," + toText(quality.overlap) + "\n";
        }
    }
    return writeAtomically(path, table);
}

}   // namespace angiopose::io
