#pragma once

#include <array>
#include <string_view>

namespace angiopose::benchmarks {

/// The part of the tree that the image shows, and the form of its points. The last four have no right answer.
enum class ForeignScene {
    WholeTree,
    OneTerritory,   ///< a subtree of a tenth to a half of the tree's length
    TwoTerritories,   ///< two separate subtrees
    OneVessel,   ///< the path of the blood to one free end, as shown by a catheter or guidewire, here on the axis
    LeavesMissing,   ///< a fifth of the free ends unopacified, foreign curves instead
    ShuffledPoints,   ///< the whole tree, all points in one curve in random order
    SkeletonPixels,   ///< the whole tree, pixels row by row
    ShuffledRows,   ///< the whole tree, each branch a curve with its points in random order
    WideVessel,   ///< lateral view: a 5 mm carotid, half of the thin branches that leave it, thin foreign vessels
    OtherPatient,   ///< the image shows the whole tree of another patient
    OtherTerritory,   ///< … or one territory of it
    Scribbles,   ///< … or two thousand short curves that are not vessels
    LoosePoints,   ///< … or twenty thousand points spread over the image
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
