#include "core/tracing/volume/tracing_warnings.h"

#include "core/tracing/volume/chosen_pieces.h"

#include <cmath>

namespace angiopose::core {

std::string loopWarning(int loops)
{
    return loops == 1 ? "1 loop was opened at the thinnest place: look there for vessels that only touch."
                      : std::to_string(loops) +
                            " loops were opened at their thinnest places: look there for vessels that only touch.";
}

std::string unitWarning()
{
    return "Nothing in the scan is as dark as air in Hounsfield units: if its values are others, bone cannot be told "
           "from blood for sure. Look for bone among the vessels, or export the scan in Hounsfield units.";
}

std::string dimWarning(int parts)
{
    return parts == 1
               ? "A part less bright than the vessels was left out, as veins and organs are. Place a seed in it if it "
                 "belongs to the tree."
               : std::to_string(parts) +
                     " parts less bright than the vessels were left out, as veins and organs are. Place seeds in "
                     "those that belong to the tree.";
}

std::string besideWarning(double besideMm)
{
    return "A wide vessel that was not traced runs beside the traced ones for " +
           std::to_string(std::lround(besideMm / 10.0)) +
           " cm: the other lumen, if the aorta is torn. Place a seed in each lumen to trace both.";
}

std::string startWarning(const std::optional<Eigen::Vector3d>& foundStart)
{
    if (!foundStart) {
        return "No seed was placed, and nothing is like a great vessel: the largest piece was traced. Place a seed in "
               "the vessels if it is not them.";
    }
    return "No seed was placed: the great vessel at " + placeText(*foundStart) +
           " mm (LPS) was found and traced. Place a seed in another vessel if it is the wrong one.";
}

}   // namespace angiopose::core