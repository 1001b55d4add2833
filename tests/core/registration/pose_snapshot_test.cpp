#include "core/registration/pose_snapshot.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

PoseSnapshot snapshot(SnapshotKind kind, const std::string& name)
{
    PoseSnapshot made;
    made.kind = kind;
    made.name = name;
    return made;
}

TEST(PoseSnapshot, DropsOldRunsButNothingThatWasKept)
{
    std::vector<PoseSnapshot> snapshots;
    snapshots = withSnapshot(snapshots, snapshot(SnapshotKind::Saved, "mine"), 2);
    for (const char* name : {"first", "second", "third"}) {
        snapshots = withSnapshot(snapshots, snapshot(SnapshotKind::Run, name), 2);
    }

    ASSERT_EQ(snapshots.size(), 3u);
    EXPECT_EQ(snapshots[0].name, "mine");
    EXPECT_EQ(snapshots[1].name, "second");
    EXPECT_EQ(snapshots[2].name, "third");
}

TEST(PoseSnapshot, NeverUsesAnIdTwice)
{
    std::vector<PoseSnapshot> snapshots;
    snapshots = withSnapshot(snapshots, snapshot(SnapshotKind::Saved, "a"));
    snapshots = withSnapshot(snapshots, snapshot(SnapshotKind::Saved, "b"));
    snapshots.erase(snapshots.begin());
    snapshots = withSnapshot(snapshots, snapshot(SnapshotKind::Saved, "c"));

    EXPECT_NE(snapshots[0].id, snapshots[1].id);
    ASSERT_TRUE(findSnapshot(snapshots, snapshots[1].id));
    EXPECT_EQ(findSnapshot(snapshots, snapshots[1].id)->name, "c");
    EXPECT_FALSE(findSnapshot(snapshots, 77));
}

}   // namespace
