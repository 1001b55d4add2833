#include "io/case/fields/tree_fields.h"

#include "io/messages/messages.h"

#include <limits>

namespace angiopose::io {
namespace {

Json branchJson(const core::VesselBranch& branch)
{
    Json json{{"id", branch.id}};
    if (!branch.name.empty()) {
        json["name"] = branch.name;
    }
    if (branch.generation >= 0) {
        json["generation"] = branch.generation;
    }
    const bool hasRadii = branch.radiusMm.size() == branch.pointsInPatient.size();
    Json& points = json["pointsMm"] = Json::array();
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d& point = branch.pointsInPatient[i];
        Json values = Json::array({point.x(), point.y(), point.z()});
        if (hasRadii) {
            values.push_back(branch.radiusMm[i]);
        }
        points.push_back(std::move(values));
    }
    return json;
}

core::VesselBranch branchFrom(const Json& json)
{
    core::VesselBranch branch;
    branch.id = json.at("id").get<int>();
    branch.name = json.value("name", "");
    branch.generation = json.value("generation", -1);
    for (const Json& values : json.at("pointsMm")) {
        branch.pointsInPatient.emplace_back(values.at(0).get<double>(), values.at(1).get<double>(),
                                            values.at(2).get<double>());
        if (values.size() > 3) {
            branch.radiusMm.push_back(values[3].get<double>());
        }
    }
    if (branch.radiusMm.size() != branch.pointsInPatient.size()) {
        branch.radiusMm.clear();   // radii are known for all points of a branch or for none
    }
    return branch;
}

}   // namespace

Json treeJson(const core::VesselTree& tree)
{
    Json json;
    Json& branches = json["branches"] = Json::array();
    for (const core::VesselBranch& branch : tree.branches) {
        branches.push_back(branchJson(branch));
    }
    return json;
}

core::Result<core::VesselTree> treeFromJson(const Json& json)
{
    core::VesselTree tree;
    for (const Json& branch : json.at("branches")) {
        tree.branches.push_back(branchFrom(branch));
        if (tree.find(tree.branches.back().id) != &tree.branches.back()) {
            return core::Error(messages::caseBranchTwice(tree.branches.back().id));
        }
    }
    if (const auto problem = core::findProblem(tree)) {
        return core::Error(*problem);
    }
    return tree;
}

Json treeSchema()
{
    Json point = listSchema(numberSchema());
    point["minItems"] = 3;
    point["maxItems"] = 4;
    Json points = about(listSchema(point), "Points in patient LPS, each with its radius if known.");
    points["minItems"] = 2;
    const Json id = integerSchema(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    Json branches = listSchema(objectSchema(
        {{"id", id}, {"name", textSchema()}, {"generation", integerSchema(0, 100000)}, {"pointsMm", std::move(points)}},
        {"id", "pointsMm"}));
    branches["minItems"] = 1;
    return objectSchema({{"branches", std::move(branches)}}, {"branches"});
}

}   // namespace angiopose::io
