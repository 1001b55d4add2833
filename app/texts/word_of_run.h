#pragma once

#include "core/case/view.h"

namespace angiopose::app {

/// Who found a pose: the run whose result stands beside it, of the shown frame; a run before, or one in another frame;
/// or no run.
enum class FoundBy { ItsRun, AnEarlierRun, NoRun };

/// What a run knows more of the pose of `view` than `judged`, a look at that pose in the shown frame, can say: other
/// solutions, why it stopped, how long it took, what is empty. Of an earlier run only its distrust counts: nothing that
/// was distrusted turns green.
FoundBy takeWordOfRun(core::RegistrationResult& judged, const core::View& view);

}   // namespace angiopose::app
