#include "core/registration/method.h"
#include "core/registration/methods/angiopose.h"
#include "core/registration/methods/assembled_icp.h"
#include "core/registration/methods/dt_icp.h"
#include "core/registration/methods/dynaweight.h"
#include "core/registration/methods/iterative_pnp.h"
#include "core/registration/methods/nicp.h"

#include <algorithm>
#include <vector>

namespace core {
namespace {

/// A new method is one more row, the default first.
const std::vector<Method>& table()
{
    static const std::vector<Method> rows{
        {{"angiopose", "AngioPose",
          "Coarse search, then robust point-to-line refinement about the tree's centroid, with uncertainty."},
         solveAngioPose},
        {{"dynaweight", "DynaWeightPnP",
          "Alternates between a few auxiliary points and all points by kernel-weighted PnP (Song, Ghaffari)."},
         solveDynaWeight},
        {{"iterative-pnp", "DynaWeightPnP*", "Kernel-weighted iterative PnP on all points (Song, Ghaffari)."},
         solveIterativePnp},
        {{"nicp", "NICP",
          "Gradient ascent of the mean kernel between tree and traced vessels, or of the image's brightness "
          "(Aylward 2003; re-implementation, parameters ours)."},
         solveNicp},
        {{"nicp-alternating", "NICP*",
          "NICP inside the alternating search (Song, Ghaffari; re-implementation, parameters ours)."},
         solveNicpAlternating},
        {{"dt-icp", "DT-ICP",
          "Least Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; "
          "re-implementation, parameters ours)."},
         solveDtIcp},
        {{"assembled-icp", "Assembled ICP",
          "Least squares on nearest pairs by OpenCV's SQPNP, repeated: what library parts make in an afternoon."},
         solveAssembledIcp},
    };
    return rows;
}

}   // namespace

std::span<const Method> methods()
{
    return table();
}

const Method* findMethod(std::string_view id)
{
    const auto found =
        std::find_if(table().begin(), table().end(), [&](const Method& method) { return method.info.id == id; });
    return found == table().end() ? nullptr : &*found;
}

std::span<const MethodInfo> methodInfos()
{
    static const std::vector<MethodInfo> infos = [] {
        std::vector<MethodInfo> all;
        for (const Method& method : table()) {
            all.push_back(method.info);
        }
        return all;
    }();
    return infos;
}

}   // namespace core
