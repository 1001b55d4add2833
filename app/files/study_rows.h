#pragma once

#include "io/study/study_tree.h"
#include "ui/dialogs/study_list.h"

#include <QString>

namespace angiopose::app {

enum class IdentityShown { Yes, No };

enum class Numbering { Final, Passing };   ///< of the parts of a series: passing while more of it may come

/// The studies in words; without names, IDs, dates of birth and accessions where identity is hidden. A part of a series
/// can be opened once it is known which one it is.
std::vector<ui::PatientRow> studyRows(const io::StudyTree& tree, IdentityShown identity, Numbering numbering);

/// By which a series is known to the list.
QString keyOf(const io::StudySeries& series);

}   // namespace angiopose::app
