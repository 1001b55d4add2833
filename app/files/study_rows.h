#pragma once

#include "io/study/study_tree.h"
#include "ui/dialogs/study_rows.h"

#include <QString>

namespace angiopose::app {

enum class IdentityShown { Yes, No };

/// The studies in words; without names, IDs, dates of birth and accessions where identity is hidden.
std::vector<ui::PatientRow> studyRows(const io::StudyTree& tree, IdentityShown identity);

/// By which a series is known to the list.
QString keyOf(const io::StudySeries& series);

}   // namespace angiopose::app
