#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"

namespace angiopose::core {
namespace {

constexpr int clinicalAnatomies = 6;
constexpr std::uint64_t clinicalSeeds = 1000;

struct ClinicalSetting {
    Condition condition;
    double nonRigidStdMm = 0.0;
};

const std::vector<ClinicalSetting>& clinicalSettings()
{
    static const std::vector<ClinicalSetting> rows{
        {{"nonrigid-0", "synthetic DSA, rigid", false}, 0.0},
        {{"nonrigid-1", "synthetic DSA, deformed by 1 mm", true}, 1.0},
        {{"nonrigid-2", "synthetic DSA, deformed by 2 mm", false}, 2.0},
        {{"nonrigid-3", "synthetic DSA, deformed by 3 mm", false}, 3.0},
    };
    return rows;
}

TrialMaker prepareClinical(std::size_t condition, std::uint64_t seed)
{
    return [nonRigidStdMm = clinicalSettings()[condition].nonRigidStdMm, seed](std::uint64_t number) {
        DsaOptions dsa;
        dsa.frameCount = 1;
        dsa.nonRigidStdMm = nonRigidStdMm;
        const std::uint64_t treeSeed = seed * clinicalSeeds + number % clinicalAnatomies;
        return tracedTrial(simulateView(treeSeed, trialRandom(clinicalNumber, seed, number)(), {}, dsa));
    };
}

}   // namespace

Protocol clinicalProtocol()
{
    return {"clinical",
            "Synthetic angiograms of six trees through the real tracing, start poses as headers give them (ALGORITHMS "
            "4.4).",
            278,
            clinicalAnatomies,
            Success::RayDistanceWithin2Mm,
            conditionsOf(clinicalSettings()),
            prepareClinical};
}

Protocol ownProtocol()
{
    return {"own",
            "Cases of one's own, listed in a table with their reference poses, landmarks or pairs of points.",
            0,
            1,
            Success::RayDistanceWithin2Mm,
            {},
            nullptr};
}

}   // namespace angiopose::core
