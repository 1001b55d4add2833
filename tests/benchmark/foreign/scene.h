#pragma once

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

}   // namespace angiopose::benchmarks
