#include "core/registration/experience.h"

#include "core/messages/says.h"
#include "core/registration/bending_doubt.h"
#include "core/registration/judging/within_2mm.h"

#include <algorithm>

namespace angiopose::core {
namespace {

// Chosen in the made-up world (DECISIONS D73): fewer false alarms and fewer errors that are trusted than by rules
// alone.
constexpr double allButSure = 0.99;
constexpr double oftenFails = 0.8;

/// Rules of thumb that experience with many fits may overrule; what other poses or other frames say it may not.
bool isRuleOfThumb(const Message& said)
{
    return said.is(says::trustFilledDoubtful) || said.is(says::trustLittleAgreement) ||
           said.is(says::trustLittleExplained) || said.is(says::trustBetterAside) || said.is(says::trustPoseUncertain);
}

bool onlyRulesOfThumbSpeakAgainst(const RegistrationResult& result)
{
    const bool isOff = result.bent && putsOverlayOff(*result.bent);
    const bool isHeard = std::ranges::any_of(result.warnings, speaksAgainstTrust);
    return !isOff && isHeard && std::ranges::all_of(result.warnings, [](const Message& said) {
        return !speaksAgainstTrust(said) || isRuleOfThumb(said);
    });
}

}   // namespace

void heedExperience(RegistrationResult& result)
{
    const double probability = overlayProbability(result);
    result.probabilityWithin2Mm = probability;
    if (!result.trustworthy && probability >= allButSure && onlyRulesOfThumbSpeakAgainst(result)) {
        std::erase_if(result.warnings, isRuleOfThumb);
        result.trustworthy = true;
    }
    if (result.trustworthy && probability < oftenFails) {
        result.trustworthy = false;
        result.warnings.insert(result.warnings.begin(), says::trustOftenFails(Quantity{100.0 * probability, 0, "%"}));
    }
    if (!result.trustworthy && probability >= oftenFails) {   // it knows nothing of what speaks against this fit
        result.probabilityWithin2Mm.reset();
    }
}

}   // namespace angiopose::core
