#include "io/vessel_tree_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

core::VesselTree named(const std::string& name, int points)
{
    core::VesselTree tree;
    tree.branches.push_back({1, name, {}, {}});
    tree.branches.push_back({2, "RCA", {}, {}});
    for (int i = 0; i < points; ++i) {
        tree.branches[0].pointsInPatient.emplace_back(i, 0, 50);
        tree.branches[1].pointsInPatient.emplace_back(i, 9, 50);
    }
    return tree;
}

std::vector<std::string> namesOf(const std::string& path)
{
    const auto tree = io::readVesselTree(path);
    EXPECT_TRUE(tree) << tree.error().message;
    std::vector<std::string> names;
    for (const core::VesselBranch& branch : tree ? tree.value().branches : std::vector<core::VesselBranch>{}) {
        names.push_back(branch.name);
    }
    return names;
}

}   // namespace

/// Found by fuzzing: a name with a zero byte was written to a table and a VTP file that could not be read back.
TEST(BranchNames, OfControlCharactersAreWrittenAsOneLineThatCanBeReadAgain)
{
    const test::TemporaryFolder folder;
    const core::VesselTree tree = named(std::string("LAD\0 of\nthe \x1b[31mheart\t", 23), 4);
    for (const char* file : {"tree.vtp", "tree.csv", "tree.mrk.json"}) {
        ASSERT_TRUE(io::writeVesselTree(tree, folder.file(file))) << file;
        EXPECT_EQ(namesOf(folder.file(file)), (std::vector<std::string>{"LAD  of the  [31mheart", "RCA"})) << file;
    }
}

TEST(BranchNames, StayWithBranchesOfTwoPoints)
{
    const test::TemporaryFolder folder;
    for (const char* file : {"tree.vtp", "tree.csv", "tree.mrk.json"}) {
        ASSERT_TRUE(io::writeVesselTree(named("LAD", 2), folder.file(file))) << file;
        EXPECT_EQ(namesOf(folder.file(file)), (std::vector<std::string>{"LAD", "RCA"})) << file;
    }
}

TEST(BranchNames, ATableWithAZeroAnywhereIsNoText)
{
    const test::TemporaryFolder folder;
    std::string table = "x,y,z,label\n";
    for (int i = 0; i < 2000; ++i) {
        table += std::to_string(i) + ",0,0,LAD\n";
    }
    ASSERT_TRUE(io::readVesselTree(folder.write("whole.csv", table)));
    table[table.size() - 3] = '\0';
    const auto tree = io::readVesselTree(folder.write("damaged.csv", table));
    ASSERT_FALSE(tree);
    EXPECT_NE(tree.error().message.text().find("not a text table"), std::string::npos) << tree.error().message;
}
