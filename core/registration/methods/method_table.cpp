#include "core/registration/methods/method.h"
#include "core/registration/methods/methods.h"

#include <algorithm>
#include <vector>

namespace angiopose::core {
namespace {

/// Add a new method as one more row; the default comes first.
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
         solveAssembledIcp,
         false},
        {{"rgbr", "RGBR",
          "Edges found along the vessel walls' normals, a pose chosen by RANSAC with gradient matching "
          "(Markelj 2008; re-implementation, parameters ours)."},
         solveRgbr},
        {{"automask", "AutoMask",
          "Rank correlation of the image with radiographs of the CTA or of tubes, Nelder–Mead "
          "(Steininger 2012; re-implementation, parameters ours)."},
         solveAutoMask},
        {{"gradient-matching", "Gradient matching",
          "Vessel walls against image gradients, Powell's method (Mitrović 2013; re-implementation, parameters ours)."},
         solveGradientMatching},
        {{"ogmm", "OGMM",
          "L2 distance of oriented Gaussian mixtures of tree and traced vessels (Baka 2014; re-implementation, "
          "parameters ours)."},
         solveOgmm},
        {{"cvo", "CVO",
          "Gradient flow of the inner product of tree and traced vessels as functions of the image (Ghaffari 2019; "
          "re-implementation, parameters ours)."},
         solveCvo},
        {{"matched-branches", "Matched branches",
          "Least squares on branches matched by their graphs, then vessels that move with their lengths kept (Groher "
          "2009; re-implementation, parameters ours)."},
         solveMatchedBranches},
        {{"graph-matching", "Graph matching",
          "Best-first search over sequences of matched branches, a pose from each (after Zhu; re-implementation, "
          "parameters ours)."},
         solveGraphMatching},
        {{"particle", "Particles",
          "Many poses at once, drawn anew by likelihood, or a walk over the out-of-plane angles (after Tian 2022; "
          "re-implementation, parameters ours)."},
         solveParticle},
        {{"evolution", "Evolution",
          "Brightness under the vessels at their own width, evolution strategy (Jomier 2006; re-implementation, "
          "parameters ours)."},
         solveEvolution},
        {{"wire", "Wire or catheter",
          "Only a wire or catheter is visible: which way of the tree it takes, and the pose near the last full one."},
         solveWire},
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

}   // namespace angiopose::core