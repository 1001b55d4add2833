#pragma once

#include "core/registration/problem/registration_result.h"
#include "tests/benchmark/foreign_trees.h"

#include <array>
#include <string_view>

namespace angiopose::benchmarks {

/// What the image shows of the tree, and how its points are handed over. The last four hold no right answer.
enum class ForeignScene {
    WholeTree,
    OneTerritory,   ///< a subtree of a tenth to a half of the tree's length
    TwoTerritories,   ///< two subtrees apart from each other
    OneVessel,   ///< the way of the blood to one free end: what a catheter or wire shows, here on its axis
    LeavesMissing,   ///< a fifth of the free ends not filled, foreign curves instead
    ShuffledPoints,   ///< the whole tree, all points in one curve in any order
    SkeletonPixels,   ///< the whole tree, pixels row by row
    ShuffledRows,   ///< the whole tree, each branch a curve with its points in any order
    WideVessel,   ///< from the side: a carotid of 5 mm, half of the fine branches that leave it, fine vessels of others
    OtherPatient,   ///< the image shows another tree whole
    OtherTerritory,   ///< … or one territory of it
    Scribbles,   ///< … or two thousand short curves that are no vessels
    LoosePoints,   ///< … or twenty thousand points all over it
};

struct NamedScene {
    ForeignScene scene;
    std::string_view key;   ///< for the command line
    std::string_view words;
};
inline constexpr std::array<NamedScene, 13> foreignScenes{{
    {ForeignScene::WholeTree, "whole", "whole tree"},
    {ForeignScene::OneTerritory, "one", "one territory filled"},
    {ForeignScene::TwoTerritories, "two", "two territories filled"},
    {ForeignScene::OneVessel, "vessel", "one vessel of the tree"},
    {ForeignScene::LeavesMissing, "leaves", "1/5 of leaves missing, foreign curves"},
    {ForeignScene::ShuffledPoints, "points", "whole tree, points in any order"},
    {ForeignScene::SkeletonPixels, "pixels", "whole tree, pixels row by row"},
    {ForeignScene::ShuffledRows, "rows", "whole tree, rows of branches in any order"},
    {ForeignScene::WideVessel, "wide", "one wide vessel beside fine ones, from the side"},
    {ForeignScene::OtherPatient, "other", "another patient's tree"},
    {ForeignScene::OtherTerritory, "other-one", "another patient's territory"},
    {ForeignScene::Scribbles, "other-curves", "2000 curves, no vessels"},
    {ForeignScene::LoosePoints, "other-points", "20,000 points, no vessels"},
}};

/// One question to the solver and its answer.
struct ForeignCase {
    core::RegistrationInput input;
    core::RigidTransform truth;   ///< cameraFromPatient
    std::vector<std::size_t> filled;   ///< indices of the branches that the image shows; empty: another tree's
    std::size_t foreignCurves = 0;   ///< how many of the target's curves, the last ones, are vessels that no tree has
};

/// Numbers `trial` of a scene, the same on every call: pose, filling, noise and start follow from it. Starts are up to
/// 15°, 30 mm across and 50 mm along the ray off. For one wide vessel the tree is changed, see wide_vessel.h.
ForeignCase makeForeignCase(const std::vector<RootedTree>& trees, std::size_t tree, ForeignScene scene,
                            std::uint64_t trial);

/// The whole tree in two views 60° apart, as two questions whose start poses tell the geometry between them, off by
/// 0.25° and 0.75 mm (1-σ per axis) from the true one.
std::array<ForeignCase, 2> makeForeignPair(const std::vector<RootedTree>& trees, std::size_t tree, std::uint64_t trial);

/// How far an answer lies from the truth.
struct ForeignError {
    double inPlaneMm = 0.0;   ///< mean over the filled branches, across the rays
    double spaceMm = 0.0;   ///< mean distance in 3-D
    double turnDeg = 0.0;
};
ForeignError errorOf(const ForeignCase& asked, const core::RigidTransform& answer);

}   // namespace angiopose::benchmarks
