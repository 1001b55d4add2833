#include "core/registration/method.h"
#include "core/registration/methods/angiopose.h"
#include "core/registration/methods/dynaweight.h"
#include "core/registration/methods/iterative_pnp.h"

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
