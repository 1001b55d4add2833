#pragma once

#include "io/study/study_tree.h"
#include "ui/dialogs/study_list.h"

#include <QString>

namespace angiopose::app {

enum class IdentityShown { Yes, No };

enum class Numbering { Final, Provisional };   ///< whether part numbers of a series may change

/// Builds the list rows of the studies; omits names, IDs, dates of birth and accession numbers if the identity is
/// hidden. A part of a series can be opened once its number is final.
std::vector<ui::PatientRow> studyRows(const io::StudyTree& tree, IdentityShown identity, Numbering numbering);

/// Returns the key that identifies a series in the list.
QString keyOf(const io::StudySeries& series);

}   // namespace angiopose::app
